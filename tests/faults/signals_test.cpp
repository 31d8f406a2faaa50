// A signal at any moment of a run leaves old files or complete new ones.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "../../properties/domains/generators/random.hpp"
#include "../cli/program.hpp"
#include "selection.hpp"

namespace pardel::testing {
namespace fs = std::filesystem;
namespace {

constexpr const char* earlier = "an earlier file\n";
const Files outputs = {"out.node", "out.ele", "out.poly"};

class Signals : public Workshop, public ::testing::WithParamInterface<int> {
 protected:
  Signals() { write("square.poly", square_poly); }

  Ran mesh(const RunOptions& how) const {
    for (const std::string& file : outputs) write(file, earlier);
    return pardel({"mesh", "square.poly", "-o", "out.node", "--max-area", "5e-6", "--check"}, how);
  }
};

TEST_P(Signals, at_random_moments_leave_old_files_or_complete_new_ones) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  auto start = Clock::now();
  const Ran normal = mesh({});
  double seconds = seconds_since(start);  // of a whole run
  ASSERT_EQ(normal.exit_code, 0) << normal;
  std::map<std::string, std::string> complete;
  for (const std::string& file : outputs) complete[file] = read(file);

  generators::Random random(fault_seed());
  std::uint64_t interrupted = 0;
  const std::uint64_t cases = fault_cases(12);
  for (std::uint64_t i = 0; i < cases; ++i) {
    const double after = random.uniform(0, seconds);
    SCOPED_TRACE("signal " + std::to_string(GetParam()) + " after " + std::to_string(after) + " s");
    start = Clock::now();
    const Ran ran = mesh({.interrupt_after = after, .signal = GetParam()});
    std::size_t fresh = 0;
    for (const std::string& file : outputs) {
      const std::string text = read(file);
      if (text == earlier) continue;
      ++fresh;
      EXPECT_TRUE(text == complete[file]) << file << " is not complete\n" << ran;
    }
    if (GetParam() != SIGKILL) {
      Files expected = outputs;
      expected.insert("square.poly");
      EXPECT_EQ(files(), expected) << ran;
      EXPECT_TRUE(fresh == 0 || fresh == outputs.size()) << ran;
    }
    if (ran.exit_code == 0) {
      EXPECT_EQ(fresh, outputs.size()) << ran;
      seconds = std::min(
          seconds, seconds_since(start));  // a whole run takes no longer; other work may have slowed down the first one
      continue;
    }
    // Before main() watches for it, a signal ends the process in the usual way of the system.
    EXPECT_TRUE(ran.exit_code == 128 + GetParam() || (ran.exit_code == 130 && GetParam() == SIGTERM)) << ran;
    ++interrupted;
    if (HasFailure()) return;
    for (const std::string& file : files())  // SIGKILL leaves them
      if (file.ends_with(".partial")) fs::remove(folder_ / "work" / file);
  }
  EXPECT_GT(interrupted, 0U) << "all runs ended before the signal";
}

INSTANTIATE_TEST_SUITE_P(Kinds, Signals, ::testing::Values(SIGINT, SIGTERM, SIGKILL), [](const auto& parameter) {
  return parameter.param == SIGINT ? "SIGINT" : parameter.param == SIGTERM ? "SIGTERM" : "SIGKILL";
});

}  // namespace
}  // namespace pardel::testing
