// Tests that every known mistake makes the property fail that the registry names (its killer).
//
// The killer of a mutant runs twice in its mutated twin, on the same random cases. With all mutants off it must pass
// (one test per killer, named no_mutant.PROPERTY); with the mutant on it must fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "../checker/check.hpp"
#include "patch.hpp"
#include "registry.hpp"
#include "text_file.hpp"

namespace pardel::mutants {
namespace {
namespace fs = std::filesystem;

struct Run {
  End end;
  std::string output;
};

/// The killers run with few cases and without shrinking, because one failing case is enough. A property must find a
/// mistake within these limits.
constexpr const char* parameters = "max_success=1000 noshrink=1";
constexpr int time_limit_seconds = 200;

/// Runs the killer with this mutant on. An empty name switches no mutant on.
Run run(const Killer& killer, const std::string& mutant) {
  const fs::path program = fs::path(PARDEL_KILLERS) / (killer.program + "_mutated");
  const fs::path failures = fs::path(PARDEL_KILLERS) / "failures" / mutant;
  const std::string command = "OMP_WAIT_POLICY=passive PARDEL_MUTANT='" + mutant + "' RC_PARAMS='" + parameters +
                              "' PARDEL_FAILURES='" + failures.string() + "' timeout --signal=KILL " +
                              std::to_string(time_limit_seconds) + " '" + program.string() + "' --gtest_filter='" +
                              killer.property + "' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {End::not_found, "cannot run " + command};
  std::string output;
  std::array<char, 4096> buffer;
  for (std::size_t got = 0; (got = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.append(buffer.data(), got);
  const int status = pclose(pipe);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  const auto prints = [&](const std::string& words) { return output.find(words) != std::string::npos; };
  output = command + "\n" + output;
  if (code == 0) return {prints("[  PASSED  ] 1 test.") ? End::passed : End::not_found, output};
  if (code == 1 && prints("[  FAILED  ] " + killer.property)) return {End::failed, output};
  constexpr int killed_by_timeout = 128 + 9;
  return {code == killed_by_timeout ? End::timed_out : End::crashed, output};
}

void expect_end(const Killer& killer, const std::string& mutant, End expected) {
  const Run result = run(killer, mutant);
  EXPECT_EQ(name(result.end), std::string(name(expected))) << result.output;
}

const std::vector<Mutant>& registry() {
  static const std::vector<Mutant> all = read_registry(fs::path(PARDEL_SOURCE) / "properties/mutants/registry");
  return all;
}

class Deferred : public testing::Test {
 public:
  explicit Deferred(std::function<void()> body) : body_(std::move(body)) {}
  void TestBody() override { body_(); }

 private:
  std::function<void()> body_;
};

void add_test(const std::string& test_name, const std::function<void()>& body) {
  testing::RegisterTest("Mutants", test_name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                        [body]() -> testing::Test* { return new Deferred(body); });
}

const bool registered = [] {
  std::set<Killer> killers;
  for (const Mutant& mutant : registry()) {
    add_test(mutant.name, [&mutant] { expect_end(mutant.killer, mutant.name, mutant.end); });
    if (killers.insert(mutant.killer).second)
      add_test("no_mutant." + mutant.killer.property, [&mutant] { expect_end(mutant.killer, "", End::passed); });
  }
  return true;
}();

const fs::path mutants_folder = fs::path(PARDEL_SOURCE) / "properties/mutants";

/// The source file that the patch of each mutant changes. A patch of a family has one mutant for each kind of
/// violation.
std::map<std::string, std::string> places_in_the_patches() {
  std::map<std::string, std::string> places;
  for (const fs::directory_entry& entry : fs::directory_iterator(mutants_folder / "patches")) {
    const Patch patch = read_patch(entry.path());
    if (!patch.name.ends_with('_')) places[patch.name] = patch.changes.string();
    for (std::size_t kind = 0; patch.name.ends_with('_') && kind < violation_kinds; ++kind)
      places[patch.name + name(static_cast<ViolationKind>(kind))] = patch.changes.string();
  }
  return places;
}

TEST(Registry, names_no_mutant_twice) {
  std::set<std::string> names;
  for (const Mutant& mutant : registry()) EXPECT_TRUE(names.insert(mutant.name).second) << mutant.name;
}

TEST(Registry, has_an_entry_with_the_right_place_for_every_patch_and_no_other) {
  std::map<std::string, std::string> places;
  for (const Mutant& mutant : registry()) places[mutant.name] = mutant.file;
  EXPECT_EQ(places, places_in_the_patches());
}

TEST(Registry, has_as_many_mutants_as_the_catalogue_says) {
  const std::string catalogue = contents(mutants_folder.parent_path() / "CATALOGUE.md");
  EXPECT_NE(catalogue.find(" " + std::to_string(registry().size()) + " known mistakes (mutants)"), std::string::npos)
      << "The registry has " << registry().size() << " mutants.";
}

TEST(Sources, contain_no_mutants) {
  std::size_t files = 0;
  for (const char* folder : {"core", "parallel", "properties", "ref", "cli"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(PARDEL_SOURCE) / folder)) {
      const bool is_source = entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp";
      if (!is_source || entry.path().parent_path() == mutants_folder) continue;
      ++files;
      EXPECT_EQ(contents(entry.path()).find("mutated"), std::string::npos) << entry.path();
    }
  EXPECT_GT(files, 200U);
}

/// The runner must report that a mutant without an effect survives. Otherwise the tests above could never fail.
TEST(Runner, reports_that_a_mutant_without_effect_survives) {
  expect_end(registry().front().killer, "no_such_mutant", End::passed);
}

TEST(Runner, distinguishes_a_missing_property_from_one_that_passes) {
  expect_end({registry().front().killer.program, "No.such_property"}, "", End::not_found);
}

TEST(Runner, distinguishes_a_missing_program_from_a_failed_property) {
  expect_end({"no_such_program", registry().front().killer.property}, "", End::crashed);
}

}  // namespace
}  // namespace pardel::mutants
