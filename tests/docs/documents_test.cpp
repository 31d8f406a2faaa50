// All files, folders and headings that the documents name exist.
#include "documents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../../core/formats.hpp"
#include "../cli/program.hpp"

namespace pardel::testing {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

const fs::path source_root = PARDEL_SOURCE;

/// The documents of the project, relative to its root.
std::vector<fs::path> documents() {
  std::vector<fs::path> found = {"README.md",    "ARCHITECTURE.md",      "CONTRIBUTING.md",
                                 "CHANGELOG.md", "properties/THEORY.md", "properties/THEORY_OF_RANKS.md"};
  for (const fs::path folder : {"docs", "docs/decisions"})
    for (const auto& entry : fs::directory_iterator(source_root / folder))
      if (entry.path().extension() == ".md") found.push_back(folder / entry.path().filename());
  return found;
}

std::vector<std::smatch> matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

/// The anchors of a document's headings, as GitHub makes them: lower case, hyphens instead of spaces, no punctuation.
std::set<std::string> anchors(const std::string& text) {
  std::set<std::string> found;
  std::istringstream lines(without_code(text));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
    std::string anchor;
    for (const char c : line.substr(level + 1)) {
      const auto byte = static_cast<unsigned char>(c);
      if (std::isalnum(byte) != 0 || c == '-' || c == '_') anchor += static_cast<char>(std::tolower(byte));
      if (c == ' ') anchor += '-';
    }
    found.insert(anchor);
  }
  return found;
}

/// Finds links `[text](FILE#ANCHOR)` to places of the project that do not exist.
std::vector<std::string> broken_links(const std::string& text, const fs::path& document) {
  std::vector<std::string> broken;
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  const std::string searched = without_code(text);
  for (const std::smatch& match : matches(searched, link)) {
    const std::string target = match[1];
    if (target.find("://") != std::string::npos) continue;
    const std::size_t hash = target.find('#');
    const fs::path file = source_root / document.parent_path() / target.substr(0, hash);
    const bool here = hash == 0;
    if (!here && !fs::exists(file)) broken.push_back(target);
    if (hash == std::string::npos || (!here && !fs::exists(file))) continue;
    if (!anchors(here ? text : read_document(fs::relative(file, source_root))).contains(target.substr(hash + 1)))
      broken.push_back(target);
  }
  return broken;
}

/// True if the word looks like a path of the project: it begins with one of its folders, or is a file in its root
/// folder.
bool looks_like_a_path(const std::string& word) {
  static const std::regex path(
      R"((core|ref|parallel|distributed|properties|fuzz|bench|tests|cli|cmake|scripts|examples|docs|\.ci)/[\w./-]*|[A-Z_]+\.md)");
  return std::regex_match(word, path);
}

/// The names of all files of the project's sources.
const std::set<std::string>& file_names() {
  static const std::set<std::string> names = [] {
    std::set<std::string> found;
    for (const char* folder :
         {"core", "ref", "parallel", "distributed", "properties", "fuzz", "bench", "tests", "cli", "cmake"}) {
      for (const auto& entry : fs::recursive_directory_iterator(source_root / folder)) {
        found.insert(entry.path().filename().string());
      }
    }
    return found;
  }();
  return names;
}

/// True if the word looks like the name of a source file without a folder, for example `delaunay.hpp`.
bool looks_like_a_source(const std::string& word) {
  static const std::regex source(R"([a-z_0-9]+\.(hpp|cpp|cmake))");
  return std::regex_match(word, source);
}

/// The paths and names of source files in a document that do not exist in the project.
std::vector<std::string> missing_paths(const std::string& text, const fs::path& document) {
  std::vector<std::string> missing;
  static const std::regex word(R"([\w./*{},-]+)");
  for (const std::smatch& match : matches(text, word)) {
    std::string path = match[0];
    while (path.ends_with('.') || path.ends_with(',')) path.pop_back();
    if (looks_like_a_source(path) && !file_names().contains(path)) missing.push_back(path);
    if (!looks_like_a_path(path)) continue;
    const bool found = fs::exists(source_root / path) || fs::exists(source_root / document.parent_path() / path) ||
                       file_names().contains(path);
    if (!found) missing.push_back(path);
  }
  return missing;
}

TEST(Documents, name_only_files_and_folders_that_exist) {
  for (const fs::path& document : documents()) {
    EXPECT_EQ(missing_paths(read_document(document), document), Strings()) << document;
  }
}

/// The part of a document under a heading, up to the next one.
std::string section(const std::string& text, const std::string& heading) {
  const std::size_t begin = text.find("\n## " + heading + "\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

/// The functions that a cell of the table names and that are not in their files. `path`: `name`, `name`
Strings missing_functions(const std::string& cell) {
  static const std::regex place(R"(`([\w/]+\.[hc]pp)`: ((`\w+`(, )?)+))"), name(R"(\w+)");
  Strings missing;
  for (const std::smatch& match : matches(cell, place)) {
    const std::string source = read_document(match[1].str()), names = match[2];
    for (const std::smatch& each : matches(names, name))
      if (!std::regex_search(source, std::regex("\\b" + each[0].str() + "\\b")))
        missing.push_back(match[1].str() + ": " + each[0].str());
  }
  return missing;
}

TEST(Documents, lead_from_each_statement_of_the_paper_to_lines_that_exist) {
  const std::string table = section(read_document("ARCHITECTURE.md"), "From the paper to the line");
  const std::string catalogue = read_document("properties/CATALOGUE.md");
  static const std::regex row(R"(\n\| (\[[^|]*)\|([^|]*)\|([^|]*)\| (`[^|]*`) \| ?(?:`(\w+)`)? ?\|)");
  int rows = 0, functions = 0;
  for (const std::smatch& match : matches(table, row)) {
    ++rows;
    for (const int cell : {2, 3}) {
      EXPECT_EQ(missing_functions(match[cell]), Strings());
      functions += static_cast<int>(std::ranges::count(match[cell].str(), ':'));
    }
    EXPECT_NE(catalogue.find(match[4].str()), std::string::npos) << match[4];
    if (match[5].matched) {
      EXPECT_TRUE(fs::exists(source_root / "tests/witnesses" / (match[5].str() + ".svg"))) << match[5];
    }
  }
  EXPECT_GE(rows, 10);
  EXPECT_GE(functions, 16);
  EXPECT_EQ(missing_functions("`ref/ruppert.hpp`: `no_function`"), Strings{"ref/ruppert.hpp: no_function"});
}

TEST(Documents, link_only_to_files_and_headings_that_exist) {
  for (const fs::path& document : documents()) {
    EXPECT_EQ(broken_links(read_document(document), document), Strings()) << document;
  }
}

TEST(Documents, fit_the_width_except_for_tables_links_and_code) {
  for (const fs::path& document : documents()) {
    std::istringstream lines(without_code(read_document(document)));
    for (std::string line; std::getline(lines, line);) {
      const bool exempt = line.starts_with('|') || line.find("](") != std::string::npos;
      // Bytes that continue a character of several bytes do not count.
      const auto width = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
      EXPECT_TRUE(exempt || width <= 120) << document << ": " << line;
    }
  }
}

TEST(Documents, list_every_folder_and_room_in_the_architecture) {
  const std::string text = read_document("ARCHITECTURE.md");
  for (const char* folder : {"core", "parallel", "properties"}) {
    for (const auto& entry : fs::directory_iterator(source_root / folder)) {
      const std::string room = "`" + fs::relative(entry.path(), source_root).string() + "/`";
      EXPECT_TRUE(!entry.is_directory() || text.find(room) != std::string::npos) << room;
    }
  }
}

/// The number of cells in a row of a table. `\\|` does not separate cells.
std::ptrdiff_t cells_of(const std::string& row) {
  const auto separators = std::count(row.begin(), row.end(), '|');
  return separators - static_cast<std::ptrdiff_t>(matches(row, std::regex(R"(\\\|)")).size()) - 1;
}

TEST(Documents, have_tables_whose_rows_have_equally_many_cells) {
  for (const fs::path& document : documents()) {
    std::ptrdiff_t cells = 0;
    for (const std::string& line : lines_of(without_code(read_document(document)))) {
      if (!line.starts_with('|')) {
        cells = 0;
        continue;
      }
      if (cells == 0) cells = cells_of(line);
      EXPECT_EQ(cells_of(line), cells) << document << ": " << line;
    }
  }
}

/// Returns an empty text if a file was read; otherwise the error message.
template <class T>
std::string message_of(const Result<T>& result) {
  return result ? "" : result.error().message;
}

class FormatExamples : public Workshop {};

TEST_F(FormatExamples, can_be_read) {
  // Collects the examples of docs/formats.md: the last code block under each heading, by the heading's text up to a
  // colon.
  std::map<std::string, std::string> example;
  std::string heading;
  const std::string text = read_document("docs/formats.md");
  std::string section;
  bool code = false;  // in a code block, `#` begins a comment, not a heading
  for (const std::string& line : lines_of(text + "\n# end")) {
    if (line.starts_with("```")) code = !code;
    if (!code && line.starts_with('#')) {
      if (const Strings blocks = code_blocks(section, ""); blocks.size() > 1) example[heading] = blocks.back();
      heading = line.substr(line.find(' ') + 1);
      heading = heading.substr(0, heading.find(':'));
      section.clear();
    }
    section += line + '\n';
  }
  write("domain.poly", example.at(".poly"));
  write("mesh.node", example.at(".node"));
  write("mesh.ele", example.at(".ele"));
  write("mesh.off", example.at(".off"));
  write("caps.area", example.at(".area"));
  write("domain.sizes", example.at("The file of --sizes"));

  EXPECT_EQ(pardel({"mesh", "domain.poly", "-o", "domain.vtu", "--regions", "--check"}).exit_code, 0);
  EXPECT_EQ(message_of(read_mesh(folder_ / "work" / "mesh.ele")), "");
  EXPECT_EQ(message_of(read_mesh(folder_ / "work" / "mesh.off")), "");
  EXPECT_EQ(message_of(read_area(folder_ / "work" / "caps.area")), "");
  EXPECT_EQ(message_of(read_sizes(folder_ / "work" / "domain.sizes")), "");
}

class QuickStart : public Workshop {
 protected:
  /// Runs the commands below the heading "Quick start" of a document.
  void run_quick_start_of(const fs::path& document) const {
    const Strings blocks = code_blocks(section(read_document(document), "Quick start"), "sh");
    const std::string folder = fs::path(PARDEL_PROGRAM).parent_path().string();
    const Ran ran = run("sh", {"-c", "set -e; PATH='" + folder + "':$PATH\n" + blocks.at(0)});
    EXPECT_EQ(ran.exit_code, 0) << document << ran;
  }
};

TEST_F(QuickStart, of_the_readme_and_of_the_manual_run) {
  run_quick_start_of("README.md");
  EXPECT_EQ(files(), (Files{"key.poly", "key.vtu"}));
  run_quick_start_of("docs/manual.md");
  EXPECT_EQ(files(), (Files{"key.1.ele", "key.1.node", "key.1.poly", "key.msh", "key.poly", "key.vtu", "mesh.ele",
                            "mesh.node", "mesh.poly", "mesh.png"}));
}

TEST(DocumentsControl, a_missing_file_or_heading_is_found) {
  EXPECT_EQ(
      missing_paths("See core/pslg.hpp, `core/no_such_file.hpp`, pslg.hpp, `nothing.hpp` and NOTHING.md.", "README.md"),
      (Strings{"core/no_such_file.hpp", "nothing.hpp", "NOTHING.md"}));
  EXPECT_EQ(broken_links("# A heading: here\n[a](#a-heading-here) [b](#b) [c](core/none.hpp) [d](LICENSE) "
                         "[e](https://example.org)",
                         "README.md"),
            (Strings{"#b", "core/none.hpp"}));
}

}  // namespace
}  // namespace pardel::testing
