// Child processes stay within their limits, and none of their processes survives.
#include "../../../core/support/child_process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

#include "../../is_gone.hpp"
#include "../../temporary_folder.hpp"

namespace pardel {
namespace {

using namespace std::chrono_literals;

bool never() { return false; }

class ChildProcess : public ::testing::Test {
 protected:
  [[nodiscard]] std::string said() const { return folder_.read("log"); }
  ChildRun shell(const std::string& script, const ChildLimits& limits = {},
                 const std::function<bool()>& stop = never) const {
    return run_child({"/bin/sh", "-c", script}, folder_ / "log", limits, stop);
  }

  const TemporaryFolder folder_;
};

TEST_F(ChildProcess, returns_its_exit_code_and_logs_both_outputs) {
  const ChildRun run = shell("echo out; echo err >&2; exit 7");
  EXPECT_EQ(run.ending, ChildEnding::exited);
  EXPECT_EQ(run.number, 7);
  EXPECT_EQ(said(), "out\nerr\n");
}

TEST_F(ChildProcess, has_an_empty_standard_input) { EXPECT_EQ(shell("cat").number, 0); }

TEST_F(ChildProcess, returns_the_signal_that_ended_it) {
  const ChildRun run = shell("kill -SEGV $$");
  EXPECT_EQ(run.ending, ChildEnding::signalled);
  EXPECT_EQ(run.number, SIGSEGV);
  EXPECT_EQ(signal_name(run.number), "SIGSEGV");
}

TEST_F(ChildProcess, is_killed_with_its_children_at_the_time_limit) {
  const auto start = std::chrono::steady_clock::now();
  const ChildRun run = shell("sleep 600 & echo $!; wait", {.seconds = 0.3});
  EXPECT_EQ(run.ending, ChildEnding::timed_out);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 60s);
  EXPECT_TRUE(is_gone(said()));
}

TEST_F(ChildProcess, leaves_no_process_running) {
  EXPECT_EQ(shell("sleep 600 & echo $!").ending, ChildEnding::exited);
  EXPECT_TRUE(is_gone(said()));
}

TEST_F(ChildProcess, is_killed_when_stop_returns_true) {
  EXPECT_EQ(shell("sleep 600", {}, [] { return true; }).ending, ChildEnding::interrupted);
}

TEST_F(ChildProcess, cannot_write_a_file_above_the_size_limit) {
  shell("head -c 1000000 /dev/zero > " + (folder_ / "large").string(), {.file_bytes = 1000});
  EXPECT_LE(std::filesystem::file_size(folder_ / "large"), 1000);
}

TEST_F(ChildProcess, cannot_use_more_memory_than_its_limit) {
  const ChildRun run = shell("head -c 200000000 /dev/zero | sort > /dev/null || exit 9", {.memory_bytes = 50'000'000});
  EXPECT_NE(run.number, 0);
}

TEST_F(ChildProcess, that_cannot_be_run_exits_with_126_and_logs_the_reason) {
  const ChildRun run = run_child({folder_.write("no-program", "")}, folder_ / "log", {}, never);
  EXPECT_EQ(run.ending, ChildEnding::exited);
  EXPECT_EQ(run.number, 126);
  EXPECT_NE(said().find("error: the program cannot be started: Permission denied"), std::string::npos) << said();
}

TEST_F(ChildProcess, has_one_thread_if_it_may_have_no_more) {
  shell("echo $OMP_NUM_THREADS $HOME", {.one_thread = true});
  EXPECT_EQ(said(), std::string("1 ") + std::getenv("HOME") + "\n");
}

TEST_F(ChildProcess, tells_an_error_or_else_its_last_line) {
  const auto told = [&](const std::string& script) {
    shell(script);
    return telling_line(folder_ / "log", folder_.path());
  };
  EXPECT_EQ(told("printf 'one\\ntwo\\a\\n  \\n'"), "two");
  EXPECT_EQ(told("echo Error in " + (folder_ / "file").string() + "; echo end"), "Error in file");
  EXPECT_EQ(told(":"), "");
}

}  // namespace
}  // namespace pardel
