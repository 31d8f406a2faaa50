// A signal at any moment of a run leaves old files or complete new ones.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "../../properties/domains/generators/random.hpp"
#include "../cli/program.hpp"
#include "selection.hpp"

namespace pardel::testing {
namespace fs = std::filesystem;
namespace {

constexpr const char* earlier = "an earlier file\n";

/// A command that takes some tenths of a second, and what it writes.
struct LongRun {
  std::vector<std::string> arguments;
  Files outputs;
  /// The output that is put in place before the others. Without it, all are put in place together.
  std::optional<std::string> first = {};
  std::map<std::string, std::string> complete = {};  ///< the texts of the outputs of a run without a signal
  double seconds = 0;                                ///< of a run without a signal
};

class Signals : public Workshop, public ::testing::WithParamInterface<int> {
 protected:
  Signals() {
    // A shell makes programs in the background ignore SIGINT. The programs that this one starts would do the same.
    std::signal(SIGINT, SIG_DFL);
    write("square.poly", square_poly);
    pardel({"mesh", "square.poly", "-o", "fine.off", "--max-area", "5e-6"});
    inputs_ = files();
    for (LongRun& command : commands_) run_to_the_end(command);
  }

  Ran run(const LongRun& command, const RunOptions& how) const {
    for (const std::string& file : files())
      if (!inputs_.contains(file)) fs::remove(folder_ / "work" / file);
    for (const std::string& file : command.outputs) write(file, earlier);
    return pardel(command.arguments, how);
  }

  void run_to_the_end(LongRun& command) const {
    const Clock::time_point start = Clock::now();
    const Ran ran = run(command, {});
    command.seconds = seconds_since(start);
    EXPECT_EQ(ran.exit_code, 0) << ran;
    for (const std::string& file : command.outputs) command.complete[file] = read(file);
  }

  /// Reports contain times, so a complete one is not always the same.
  static bool is_complete(const LongRun& command, const std::string& file, const std::string& text) {
    return file.ends_with(".json") ? nlohmann::json::accept(text) : text == command.complete.at(file);
  }

  /// Sends the signal at a random moment. False if the run ended before.
  bool interrupt(LongRun& command, generators::Random& random) const {
    const double after = random.uniform(0, command.seconds);
    SCOPED_TRACE(command.arguments.front() + ", signal " + std::to_string(GetParam()) + " after " +
                 std::to_string(after) + " s");
    const Clock::time_point start = Clock::now();
    const Ran ran = run(command, {.interrupt_after = after, .signal = GetParam()});
    std::size_t fresh = 0;
    for (const std::string& file : command.outputs) {
      const std::string text = read(file);
      if (text == earlier) continue;
      ++fresh;
      EXPECT_TRUE(is_complete(command, file, text)) << file << " is not complete\n" << ran;
    }
    // A process that is killed while a file replaces another one can leave partial names. The next one removes them.
    if (GetParam() == SIGKILL) {
      EXPECT_EQ(pardel(command.arguments).exit_code, 0);
    }
    Files expected = inputs_;
    expected.insert(command.outputs.begin(), command.outputs.end());
    EXPECT_EQ(files(), expected) << ran;
    if (GetParam() != SIGKILL) {
      EXPECT_TRUE(fresh == 0 || fresh == command.outputs.size() || (command.first && read(*command.first) != earlier))
          << ran;
    }
    if (ran.exit_code == 0) {
      EXPECT_EQ(fresh, command.outputs.size()) << ran;
      // A whole run takes no longer. Other work may have slowed down the first one.
      command.seconds = std::min(command.seconds, seconds_since(start));
      return false;
    }
    // Before main() watches for it, a signal ends the process in the usual way of the system.
    EXPECT_TRUE(ran.exit_code == 128 + GetParam() || (ran.exit_code == 130 && GetParam() == SIGTERM)) << ran;
    return true;
  }

  std::vector<LongRun> commands_ = {
      {{"mesh", "square.poly", "-o", "out.node", "--max-area", "5e-6", "--check"}, {"out.node", "out.ele", "out.poly"}},
      {{"mesh", "square.poly", "-o", "out.vtu", "--max-area", "5e-6", "--json", "out.json"},
       {"out.vtu", "out.json"},
       "out.vtu"},
      {{"check", "square.poly", "fine.off", "--json", "out.json"}, {"out.json"}},
      {{"convert", "fine.off", "out.msh"}, {"out.msh"}},
      {{"triangle", "-pqa0.000005", "square.poly"}, {"square.1.node", "square.1.ele", "square.1.poly"}}};

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  Files inputs_;
};

TEST_P(Signals, at_random_moments_leave_old_files_or_complete_new_ones) {
  ASSERT_FALSE(HasFailure());
  generators::Random random(fault_seed());
  std::uint64_t all_interrupted = 0;
  for (LongRun& command : commands_) {
    std::uint64_t interrupted = 0;
    const std::uint64_t cases = fault_cases(4);
    for (std::uint64_t i = 0; i < cases && !HasFailure(); ++i) interrupted += interrupt(command, random) ? 1 : 0;
    // Of the few signals of a usual run, all may come too late.
    if (cases >= 20) {
      EXPECT_GT(interrupted, cases / 10) << command.arguments.front() << ": most runs ended before";
    }
    all_interrupted += interrupted;
  }
  EXPECT_GT(all_interrupted, 0U) << "all runs ended before the signal";
}

INSTANTIATE_TEST_SUITE_P(Kinds, Signals, ::testing::Values(SIGINT, SIGTERM, SIGKILL), [](const auto& parameter) {
  return parameter.param == SIGINT ? "SIGINT" : parameter.param == SIGTERM ? "SIGTERM" : "SIGKILL";
});

}  // namespace
}  // namespace pardel::testing
