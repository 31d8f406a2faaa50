// Every known mistake is noticed, by the property that its entry in the registry names.
//
// A mutant's killer runs twice: asleep, where it must pass (one test per killer), and with the mutant awake, where it
// must fail. All runs are of the mutated twins, with the same cases, so that nothing but the mistake differs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "../checker/check.hpp"
#include "../checker/stages/findings.hpp"
#include "registry.hpp"

namespace pardel::mutants {
namespace {
namespace fs = std::filesystem;

struct Run {
  End end;
  std::string output;
};

/// Few cases, and the first that fails is enough. A mistake that takes longer to show is none that a property notices.
constexpr const char* parameters = "max_success=1000 noshrink=1";
constexpr int time_limit_seconds = 60;

/// Runs the killer with the mutant awake; none is where its name is empty.
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
  const auto says = [&](const std::string& words) { return output.find(words) != std::string::npos; };
  output = command + "\n" + output;
  if (code == 0) return {says("[  PASSED  ] 1 test.") ? End::passed : End::not_found, output};
  if (code == 1 && says("[  FAILED  ] " + killer.property)) return {End::failed, output};
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
      add_test("asleep." + mutant.killer.property, [&mutant] { expect_end(mutant.killer, "", End::passed); });
  }
  return true;
}();

/// What mutated("...") asks for, with the files that ask. A family's prefix stands for its members.
std::map<std::string, std::set<std::string>> sites() {
  static const std::regex site("mutated\\(\"([a-z0-9_]+)\"(, name\\(kind\\))?\\)");
  std::map<std::string, std::set<std::string>> found;
  for (const char* folder : {"core", "parallel", "properties", "ref"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(PARDEL_SOURCE) / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
      const std::string file = fs::relative(entry.path(), PARDEL_SOURCE).string();
      if (file.starts_with("properties/mutants/") || file == "core/mutants.hpp") continue;
      std::ifstream in(entry.path());
      const std::string text{std::istreambuf_iterator<char>(in), {}};
      for (auto at = std::sregex_iterator(text.begin(), text.end(), site); at != std::sregex_iterator(); ++at) {
        if (!(*at)[2].matched) {
          found[(*at)[1]].insert(file);
          continue;
        }
        for (std::size_t kind = 0; kind < checker::violation_kinds; ++kind)
          found[(*at)[1].str() + name(static_cast<ViolationKind>(kind))].insert(file);
      }
    }
  return found;
}

TEST(Registry, has_an_entry_for_every_mutant_in_the_sources_and_no_other) {
  std::map<std::string, std::set<std::string>> entries;
  for (const Mutant& mutant : registry()) {
    EXPECT_FALSE(entries.contains(mutant.name)) << mutant.name << " twice";
    entries[mutant.name].insert(mutant.file);
  }
  for (const auto& [mutant, files] : sites()) EXPECT_EQ(entries[mutant], files) << mutant;
  for (const auto& [mutant, files] : entries) EXPECT_TRUE(sites().contains(mutant)) << mutant << " is nowhere";
}

TEST(Registry, has_at_least_forty_five_mutants) { EXPECT_GE(registry().size(), 45U); }

/// The canary: a mutant without an effect must be seen to survive, or the runner could not fail.
TEST(Runner, sees_a_mutant_without_effect_survive) {
  expect_end(registry().front().killer, "asleep_canary", End::passed);
}

TEST(Runner, tells_a_missing_property_from_one_that_passes) {
  expect_end({registry().front().killer.program, "No.such_property"}, "", End::not_found);
}

TEST(Runner, tells_a_missing_program_from_a_failed_property) {
  expect_end({"no_such_program", registry().front().killer.property}, "", End::crashed);
}

}  // namespace
}  // namespace pardel::mutants
