// Limits hold, and nothing outlives its time.
#include "../../cli/harness/child_process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "../temporary_folder.hpp"

namespace pardel::harness {
namespace {

using namespace std::chrono_literals;

bool never() { return false; }

/// Waits for it: whoever inherits an orphan may take a while to bury it, so a zombie counts as gone.
bool is_gone(const std::string& process) {
  for (int tries = 0; tries < 1000; ++tries, std::this_thread::sleep_for(10ms)) {
    std::ifstream stat("/proc/" + process.substr(0, process.find('\n')) + "/stat");
    std::string id, name, state;
    if (!(stat >> id >> name >> state) || state == "Z" || state == "X") return true;
  }
  return false;
}

class AChildProcess : public ::testing::Test {
 protected:
  [[nodiscard]] std::string said() const { return folder_.read("log"); }
  ChildRun shell(const std::string& script, const Limits& limits = {},
                 const std::function<bool()>& stop = never) const {
    return run_child({"/bin/sh", "-c", script}, folder_ / "log", limits, stop);
  }

  const TemporaryFolder folder_;
};

TEST_F(AChildProcess, GivesItsExitCodeAndWhatItSaid) {
  const ChildRun run = shell("echo out; echo err >&2; exit 7");
  EXPECT_EQ(run.ending, Ending::exited);
  EXPECT_EQ(run.number, 7);
  EXPECT_EQ(said(), "out\nerr\n");
}

TEST_F(AChildProcess, ReadsNothing) { EXPECT_EQ(shell("cat").number, 0); }

TEST_F(AChildProcess, GivesTheSignalThatEndedIt) {
  const ChildRun run = shell("kill -SEGV $$");
  EXPECT_EQ(run.ending, Ending::signalled);
  EXPECT_EQ(run.number, SIGSEGV);
  EXPECT_EQ(signal_name(run.number), "SIGSEGV");
}

TEST_F(AChildProcess, IsKilledWithItsChildrenWhenTimeIsUp) {
  const auto start = std::chrono::steady_clock::now();
  const ChildRun run = shell("sleep 600 & echo $!; wait", {.seconds = 0.3});
  EXPECT_EQ(run.ending, Ending::timed_out);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 60s);
  EXPECT_TRUE(is_gone(said()));
}

TEST_F(AChildProcess, LeavesNothingRunningBehindIt) {
  EXPECT_EQ(shell("sleep 600 & echo $!").ending, Ending::exited);
  EXPECT_TRUE(is_gone(said()));
}

TEST_F(AChildProcess, IsStoppedWhenAskedTo) {
  EXPECT_EQ(shell("sleep 600", {}, [] { return true; }).ending, Ending::interrupted);
}

TEST_F(AChildProcess, WritesNoFileAboveItsLimit) {
  shell("head -c 1000000 /dev/zero > " + (folder_ / "large").string(), {.file_bytes = 1000});
  EXPECT_LE(std::filesystem::file_size(folder_ / "large"), 1000);
}

TEST_F(AChildProcess, GetsNoMoreMemoryThanItsLimit) {
  const ChildRun run = shell("head -c 200000000 /dev/zero | sort > /dev/null || exit 9", {.memory_bytes = 50'000'000});
  EXPECT_NE(run.number, 0);
}

TEST_F(AChildProcess, ThatCannotBeRunSaysWhy) {
  const ChildRun run = run_child({folder_.write("no-program", "")}, folder_ / "log", {}, never);
  EXPECT_EQ(run.ending, Ending::exited);
  EXPECT_EQ(run.number, 126);
  EXPECT_NE(said().find("error: it cannot be run: Permission denied"), std::string::npos) << said();
}

}  // namespace
}  // namespace pardel::harness
