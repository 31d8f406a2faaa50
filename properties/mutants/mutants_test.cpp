// Tests that every known mistake makes the property fail that the registry names (its killer).
//
// The killer of a mutant runs twice in its mutated twin. With the mutant on it must fail. Then the random case that
// failed, or the whole test if it has no random cases, runs again with all mutants off, and must pass.
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
constexpr const char* random_cases = "max_success=1000 noshrink=1";
constexpr int time_limit_seconds = 200;

/// Runs the killer with this mutant on, with settings of RapidCheck. An empty name switches no mutant on.
Run run(const Killer& killer, const std::string& mutant, const std::string& settings = random_cases) {
  const fs::path program = fs::path(PARDEL_KILLERS) / (killer.program + "_mutated");
  const fs::path failures = fs::path(PARDEL_KILLERS) / "failures" / mutant;
  const std::string command = "OMP_WAIT_POLICY=passive PARDEL_MUTANT='" + mutant + "' RC_PARAMS='" + settings +
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

void expect_end(const Run& run, End expected) { EXPECT_EQ(name(run.end), std::string(name(expected))) << run.output; }

/// The setting that repeats only the random case that failed. If the output names none, because the killer has no
/// random cases, crashed, or failed by what all cases have in common: the settings that repeat everything.
std::string setting_of_the_failure(const std::string& output) {
  const std::size_t begin = output.find("reproduce=");
  return begin == std::string::npos ? random_cases : output.substr(begin, output.find('"', begin) - begin);
}

void expect_killed(const Mutant& mutant) {
  const Run killed = run(mutant.killer, mutant.name);
  expect_end(killed, mutant.end);
  expect_end(run(mutant.killer, "", setting_of_the_failure(killed.output)), End::passed);
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
  for (const Mutant& mutant : registry()) add_test(mutant.name, [&mutant] { expect_killed(mutant); });
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
  expect_end(run(registry().front().killer, "no_such_mutant"), End::passed);
}

TEST(Runner, distinguishes_a_missing_property_from_one_that_passes) {
  expect_end(run({registry().front().killer.program, "No.such_property"}, ""), End::not_found);
}

TEST(Runner, distinguishes_a_missing_program_from_a_failed_property) {
  expect_end(run({"no_such_program", registry().front().killer.property}, ""), End::crashed);
}

/// Otherwise the second run of expect_killed() could not fail.
TEST(Runner, repeats_the_case_that_failed) {
  const Mutant& mutant = registry().front();
  const std::string setting = setting_of_the_failure(run(mutant.killer, mutant.name).output);
  ASSERT_NE(setting, random_cases);
  expect_end(run(mutant.killer, mutant.name, setting), End::failed);
}

}  // namespace
}  // namespace pardel::mutants
