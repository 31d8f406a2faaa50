// Child processes and folders do not outlive a process that ends early.
#include "../../../core/support/short_lived.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "../../../core/support/child_process.hpp"
#include "../../../core/support/work_folder.hpp"
#include "../../is_gone.hpp"
#include "../../temporary_folder.hpp"
#include "../../with_variable.hpp"

namespace pardel {
namespace {

class ShortLivedThings : public ::testing::Test {
 protected:
  /// A process with a work folder and a child that never ends. When the child runs, calls then().
  pid_t start(const std::function<void()>& then) const {
    const pid_t process = fork();
    if (process != 0) return process;
    WorkFolder work;
    (void)work.make("work");
    std::thread([&] {
      (void)run_child({"/bin/sh", "-c", "echo $$ > " + (folder_ / "pid").string() + "; exec sleep 600"},
                      work.path() / "log", {.seconds = 600}, [] { return false; });
    }).detach();
    while (pid().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    then();
    for (;;) pause();
  }
  [[nodiscard]] std::string pid() const {
    std::ifstream in(folder_ / "pid");
    std::string line;
    return std::getline(in, line) && !in.eof() ? line : "";
  }

  const TemporaryFolder folder_;
  const WithVariable temporary_{"TMPDIR", folder_.path()};
};

TEST_F(ShortLivedThings, are_gone_when_a_process_ends_at_once) {
  const pid_t process = start([] {
    const auto lock = leave_nothing_behind();
    _exit(0);
  });
  ASSERT_EQ(waitpid(process, nullptr, 0), process);
  ASSERT_FALSE(pid().empty());
  EXPECT_TRUE(is_gone(pid()));
  EXPECT_EQ(folder_.names(), "pid ");
}

TEST_F(ShortLivedThings, that_are_processes_are_gone_when_a_process_is_killed) {
  const pid_t process = start([] { kill(getpid(), SIGKILL); });
  ASSERT_EQ(waitpid(process, nullptr, 0), process);
  ASSERT_FALSE(pid().empty());
  EXPECT_TRUE(is_gone(pid()));
}

}  // namespace
}  // namespace pardel
