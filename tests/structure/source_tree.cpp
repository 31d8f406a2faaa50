#include "source_tree.hpp"

#include <fstream>
#include <regex>

namespace pardel::structure {
namespace {

namespace fs = std::filesystem;

/// The file that a line includes; "" if the line includes no file of the repository.
std::string included_by(const std::string& line, const fs::path& folder) {
  static const std::regex relative(R"re(^\s*#\s*include\s*"([^"]+)".*)re");
  static const std::regex public_header(R"re(^\s*#\s*include\s*<pardel/([^>]+)>.*)re");
  std::smatch match;
  if (std::regex_match(line, match, relative)) return (folder / match[1].str()).lexically_normal().string();
  if (!std::regex_match(line, match, public_header)) return {};
  return match[1].str() == "pardel.hpp" ? "parallel/pardel.hpp" : match[1].str();
}

SourceFile read_source_file(const fs::path& file, const fs::path& folder) {
  static const std::regex opens_namespace(R"re(^namespace (pardel[A-Za-z0-9_:]*) \{.*)re");
  static const std::regex opens_class(R"re(^(?:class|struct) (\w+)[^;]*\{)re");
  SourceFile source;
  std::ifstream in(file);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, opens_class)) source.classes.push_back({match[1].str(), number, 0});
    if (line == "};" && !source.classes.empty() && source.classes.back().lines == 0)
      source.classes.back().lines = number - source.classes.back().line + 1;
    if (std::regex_match(line, match, opens_namespace)) source.namespaces.push_back(match[1].str());
    if (std::string target = included_by(line, folder); !target.empty()) source.includes.push_back({number, target});
  }
  return source;
}

bool is_left_out(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name == "build" || name.starts_with('.');
}

}  // namespace

SourceTree read_source_tree(const fs::path& root) {
  SourceTree tree;
  for (const fs::directory_entry& top : fs::directory_iterator(root)) {
    if (!top.is_directory() || is_left_out(top.path())) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top.path())) {
      const fs::path extension = entry.path().extension();
      if (!entry.is_regular_file() || (extension != ".hpp" && extension != ".cpp")) continue;
      const fs::path path = entry.path().lexically_relative(root);
      tree[path.string()] = read_source_file(entry.path(), path.parent_path());
    }
  }
  return tree;
}

}  // namespace pardel::structure
