// Tests that the catalogue has a row for every property in the sources and for every statement of the theory.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../checker/check.hpp"
#include "registry.hpp"
#include "text_file.hpp"

namespace pardel::mutants {
namespace {
namespace fs = std::filesystem;

/// For every match: its first group, or its first two groups with a dot between them.
std::set<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::set<std::string> result;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), regex); at != std::sregex_iterator(); ++at)
    result.insert(at->size() > 2 ? (*at)[1].str() + "." + (*at)[2].str() : (*at)[1].str());
  return result;
}

std::set<std::string> properties_in_the_sources() {
  std::set<std::string> properties;
  for (const char* folder : {"properties/theorems", "tests"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(PARDEL_SOURCE) / folder))
      if (entry.path().extension() == ".cpp")
        properties.merge(found(contents(entry.path()), R"(PARDEL_(?:PROPERTY|FACT)\(\s*(\w+),\s*(\w+),)"));
  for (std::size_t kind = 0; kind < violation_kinds; ++kind)
    properties.insert(std::string("Checker.reports_") + name(static_cast<ViolationKind>(kind)));
  return properties;
}

/// A section of the theory that begins with "### LABEL: title" or "### LABEL".
struct Statement {
  std::string label, text;
  [[nodiscard]] bool has_line(std::string_view begin) const {
    return text.find("\n" + std::string(begin)) != std::string::npos;
  }
};

std::vector<Statement> statements_of_the_theory() {
  const fs::path folder = fs::path(PARDEL_SOURCE) / "properties";
  const std::string theory = contents(folder / "THEORY.md") + contents(folder / "THEORY_OF_RANKS.md");
  std::vector<Statement> statements;
  constexpr std::string_view heading = "\n### ";
  for (std::size_t at = theory.find(heading), next; at != std::string::npos; at = next) {
    next = theory.find(heading, at + heading.size());
    std::string text = theory.substr(at + heading.size(), next - at - heading.size());
    std::string label = text.substr(0, text.find_first_of(":\n"));
    statements.push_back({std::move(label), std::move(text)});
  }
  return statements;
}

/// The name of the suite that tests a statement: T1Sharp for T1-sharp.
std::string suite_of(const std::string& label) {
  if (label == "T1-closures") return "EdelsbrunnerGuoy";
  std::string suite;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] != '-') suite += i > 0 && label[i - 1] == '-' ? static_cast<char>(std::toupper(label[i])) : label[i];
  return suite;
}

std::set<std::string> rows_of_the_catalogue() {
  return found(contents(fs::path(PARDEL_SOURCE) / "properties/CATALOGUE.md"), R"(\n\| `(\w+\.\w+)` \|)");
}

TEST(Catalogue, has_a_row_for_every_statement_of_the_theory) {
  std::set<std::string> suites;
  for (const std::string& row : rows_of_the_catalogue()) suites.insert(row.substr(0, row.find('.')));
  EXPECT_GE(statements_of_the_theory().size(), 10U);
  for (const Statement& statement : statements_of_the_theory())
    EXPECT_TRUE(statement.has_line("Tested by: nothing") || suites.contains(suite_of(statement.label)))
        << statement.label << " has no row";
}

TEST(Theory, says_of_every_statement_what_tests_it_and_whether_it_is_proved) {
  for (const Statement& statement : statements_of_the_theory())
    for (const char* line : {"Tested by:", "Status: "})
      EXPECT_TRUE(statement.has_line(line)) << statement.label << ": " << line;
}

/// Cases are counted by classify() (framework/shares.hpp), which promises a share. RapidCheck's own macro promises
/// none.
TEST(Catalogue, has_a_promised_share_for_every_kind_of_case) {
  for (const char* folder : {"properties/theorems", "tests"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(PARDEL_SOURCE) / folder)) {
      const bool is_source = entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp";
      EXPECT_FALSE(is_source && contents(entry.path()).find("RC_CLASSIFY") != std::string::npos) << entry.path();
    }
}

TEST(Catalogue, has_no_share_of_zero_and_none_above_a_hundred_percent) {
  const std::string catalogue = contents(fs::path(PARDEL_SOURCE) / "properties/CATALOGUE.md");
  const std::regex percents(R"(<br>[^|<]* (\d+(?:\.\d+)?) %)");
  std::size_t shares = 0;
  for (auto at = std::sregex_iterator(catalogue.begin(), catalogue.end(), percents); at != std::sregex_iterator();
       ++at, ++shares) {
    EXPECT_GT(std::stod((*at)[1]), 0) << at->str();
    EXPECT_LE(std::stod((*at)[1]), 100) << at->str();
  }
  EXPECT_GT(shares, 100U);
}

TEST(Catalogue, has_a_row_for_every_property_and_no_other) {
  const std::set<std::string> rows = rows_of_the_catalogue();
  const std::set<std::string> properties = properties_in_the_sources();
  for (const std::string& property : properties) EXPECT_TRUE(rows.contains(property)) << property << " has no row";
  for (const std::string& row : rows) EXPECT_TRUE(properties.contains(row)) << row << " is not a property";
}

/// A mutant that was renamed must not keep its old name in the catalogue.
TEST(Catalogue, names_beside_each_property_the_mutants_that_the_registry_gives_it) {
  const std::set<std::string> rows = rows_of_the_catalogue();
  std::set<std::string> expected, written;  // PROPERTY.MUTANT
  for (const Mutant& mutant : read_registry(fs::path(PARDEL_SOURCE) / "properties/mutants/registry"))
    if (rows.contains(mutant.killer.property)) expected.insert(mutant.killer.property + "." + mutant.name);
  std::istringstream catalogue(contents(fs::path(PARDEL_SOURCE) / "properties/CATALOGUE.md"));
  for (std::string line; std::getline(catalogue, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string property = line.substr(3, line.find('`', 3) - 3);
    const std::size_t end_of_column = line.rfind(" |"), last_column = line.rfind('|', end_of_column - 1);
    for (const std::string& mutant : found(line.substr(last_column), R"(`(\w+)`)"))
      written.insert(property + "." + mutant);
  }
  EXPECT_EQ(written, expected);
}

/// A property that notices no known mistake may test nothing.
TEST(Catalogue, has_a_property_only_if_a_mutant_names_it) {
  std::set<std::string> killers;
  for (const Mutant& mutant : read_registry(fs::path(PARDEL_SOURCE) / "properties/mutants/registry"))
    killers.insert(mutant.killer.property);
  for (const std::string& property : properties_in_the_sources())
    EXPECT_TRUE(killers.contains(property)) << "no line of properties/mutants/registry names " << property;
}

}  // namespace
}  // namespace pardel::mutants
