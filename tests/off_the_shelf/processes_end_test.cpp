// How processes of a mesher end, and that none is left.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "../../off_the_shelf/meshers/channel.hpp"
#include "../temporary_folder.hpp"
#include "scripted_mesher.hpp"

namespace pardel {
namespace {

using Ending = RefinedSubdomain::Ending;
using Clock = std::chrono::steady_clock;

/// The open descriptors of this process but those of the standard input and outputs.
std::vector<int> open_descriptors() {
  std::vector<int> found;
  for (int descriptor = 3; descriptor < 1024; ++descriptor)
    if (fcntl(descriptor, F_GETFD) >= 0) found.push_back(descriptor);
  return found;
}

[[noreturn]] void sleep_for_ever() {
  while (true) pause();
}

/// Does something bad if the corner is at x = 1, and otherwise nothing.
std::unique_ptr<SubdomainMesher> bad_at_one(std::function<void()> bad) {
  return scripted_in_processes([bad = std::move(bad)](const Subdomain& subdomain) {
    if (subdomain.points.front().x == 1) bad();
    return unchanged(subdomain);
  });
}

/// Expects this ending of the mesher at x = 1, and that another process answers the next task.
void expect_ending(SubdomainMesher& mesher, Ending ending, const std::string& why) {
  for (int i = 0; i < 2; ++i) {
    Subdomain subdomain = one_triangle(1);
    if (ending == Ending::timed_out) subdomain.seconds = 0.25;
    const RefinedSubdomain answer = mesher.refine(subdomain);
    EXPECT_EQ(answer.ending, ending);
    EXPECT_EQ(answer.why, why);
    EXPECT_TRUE(answer.triangles.empty());
    EXPECT_EQ(mesher.refine(one_triangle()).ending, Ending::finished);
  }
}

bool has_children() { return waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD; }

TEST(ProcessesEnd, by_a_signal) {
  expect_ending(*bad_at_one([] { raise(SIGSEGV); }), Ending::crashed, "SIGSEGV");
  expect_ending(*bad_at_one([] { raise(SIGKILL); }), Ending::crashed, "SIGKILL");
  expect_ending(*bad_at_one([] { std::abort(); }), Ending::crashed, "SIGABRT");
}

TEST(ProcessesEnd, by_exit_halfway) {
  expect_ending(*bad_at_one([] { std::exit(0); }), Ending::crashed, "exit code 0");
  expect_ending(*bad_at_one([] { std::exit(3); }), Ending::crashed, "exit code 3");
  expect_ending(*bad_at_one([] { _exit(1); }), Ending::crashed, "exit code 1");
}

TEST(ProcessesEnd, after_the_time_of_the_task) {
  const auto begin = Clock::now();
  expect_ending(*bad_at_one(sleep_for_ever), Ending::timed_out, "no answer in 0.25 s");
  const std::chrono::duration<double> seconds = Clock::now() - begin;
  EXPECT_GE(seconds.count(), 0.5);
  EXPECT_LT(seconds.count(), 30);
}

TEST(ProcessesEnd, after_words_that_are_no_message) {
  expect_ending(*bad_at_one([] {
    const std::string words = "Internal error in triangulate(): please report this bug.";
    if (write(open_descriptors().front(), words.data(), words.size()) < 0) std::abort();
    sleep_for_ever();
  }),
                Ending::unreadable, "what the process has sent is no answer");
}

TEST(ProcessesEnd, after_a_message_that_is_no_answer) {
  const auto send = [](std::uint64_t number) {
    engine::Channel channel{engine::Descriptor(open_descriptors().front())};
    (void)channel.send(number, std::vector<std::byte>(3));
    sleep_for_ever();
  };
  const auto mesher = bad_at_one([send] { send(1); });
  EXPECT_EQ(mesher->refine(one_triangle(1)).ending, Ending::unreadable);
  const auto wrong_number = bad_at_one([send] { send(77); });
  expect_ending(*wrong_number, Ending::unreadable, "what the process has sent is no answer");
}

TEST(ProcessesEnd, not_by_an_exception_of_the_mesher) {
  const auto mesher = scripted_in_processes([calls = 0](const Subdomain& subdomain) mutable -> RefinedSubdomain {
    if (++calls == 1) throw std::runtime_error("out of ideas");
    if (calls == 2) throw 2;
    return unchanged(subdomain, "call " + std::to_string(calls));
  });
  EXPECT_EQ(mesher->refine(one_triangle()).why, "out of ideas");
  const RefinedSubdomain second = mesher->refine(one_triangle());
  EXPECT_EQ(second.ending, Ending::failed);
  EXPECT_EQ(second.why, "the mesher threw an exception");
  EXPECT_EQ(mesher->refine(one_triangle()).why, "call 3");
}

TEST(ProcessesEnd, without_writing_what_the_caller_has_not_written) {
  const TemporaryFolder folder;
  std::FILE* const file = std::fopen((folder / "file").c_str(), "w");
  ASSERT_NE(file, nullptr);
  std::fputs("once", file);  // stays in a buffer, which the processes copy
  expect_ending(*bad_at_one([] { std::exit(0); }), Ending::crashed, "exit code 0");
  std::fclose(file);
  EXPECT_EQ(folder.read("file"), "once");
}

TEST(ProcessesEnd, with_the_mesher_and_leave_no_child) {
  ASSERT_FALSE(has_children());
  for (const int workers : {1, 3}) {
    const auto mesher = scripted_in_processes(
        [](const Subdomain& subdomain) {
          if (subdomain.points.front().x == 1) std::abort();
          if (subdomain.points.front().x == 2) sleep_for_ever();
          return unchanged(subdomain);
        },
        workers);
    Subdomain slow = one_triangle(2);
    slow.seconds = 0.1;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
      threads.emplace_back([&] {
        EXPECT_EQ(mesher->refine(one_triangle()).ending, Ending::finished);
        EXPECT_EQ(mesher->refine(one_triangle(1)).ending, Ending::crashed);
        EXPECT_EQ(mesher->refine(slow).ending, Ending::timed_out);
        EXPECT_EQ(mesher->refine(one_triangle()).ending, Ending::finished);
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(has_children());
  }
  EXPECT_FALSE(has_children());
}

TEST(ProcessesEnd, if_the_caller_is_killed_while_they_are_busy) {
  // Processes whose parent has ended become children of this one.
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  auto ends = engine::connected_sockets(SOCK_STREAM);
  const pid_t caller = fork();
  if (caller == 0) {
    const auto mesher = scripted_in_processes(
        [](const Subdomain& subdomain) {
          if (subdomain.points.front().x == 1) sleep_for_ever();
          return unchanged(subdomain);
        },
        2);
    (void)mesher->refine(one_triangle());
    (void)!write(ends->second.number(), "1", 1);
    (void)mesher->refine(one_triangle(1));
    _exit(1);
  }
  ends->second = {};
  char word = 0;
  ASSERT_EQ(read(ends->first.number(), &word, 1), 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until the worker is busy
  kill(caller, SIGKILL);
  const auto deadline = Clock::now() + std::chrono::seconds(60);
  while (has_children() && Clock::now() < deadline) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(has_children());
}

TEST(ProcessesEnd, while_they_wait_without_a_signal_for_the_caller) {
  const auto mesher =
      scripted_in_processes([](const Subdomain& subdomain) { return unchanged(subdomain, std::to_string(getpid())); });
  std::signal(SIGPIPE, SIG_DFL);  // would end this test
  const pid_t worker = std::stoi(mesher->refine(one_triangle()).why);
  kill(worker, SIGKILL);
  const RefinedSubdomain answer = mesher->refine(one_triangle());
  EXPECT_EQ(answer.ending, Ending::crashed);
  EXPECT_EQ(answer.why, "SIGKILL");
  EXPECT_NE(mesher->refine(one_triangle()).why, std::to_string(worker));
}

TEST(ProcessesEnd, and_with_them_the_processes_that_the_mesher_has_started) {
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  {
    const auto mesher = bad_at_one([] {
      if (fork() == 0) sleep_for_ever();
      sleep_for_ever();
    });
    expect_ending(*mesher, Ending::timed_out, "no answer in 0.25 s");
  }
  // Killed processes are children of this one now.
  const auto deadline = Clock::now() + std::chrono::seconds(60);
  while (has_children() && Clock::now() < deadline) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(has_children());
}

TEST(ProcessesEnd, and_nothing_more_is_answered_if_the_process_that_starts_them_is_killed) {
  const auto mesher =
      scripted_in_processes([](const Subdomain& subdomain) { return unchanged(subdomain, std::to_string(getppid())); });
  kill(std::stoi(mesher->refine(one_triangle()).why), SIGKILL);
  RefinedSubdomain answer;
  do answer = mesher->refine(one_triangle());  // the worker ends a little later
  while (answer.ending == Ending::finished);
  EXPECT_EQ(answer.ending, Ending::crashed);
  EXPECT_EQ(answer.why, "the process that starts the others has ended");
  answer = mesher->refine(one_triangle());
  EXPECT_EQ(answer.ending, Ending::failed);
  EXPECT_EQ(answer.why, "the process that starts the others has ended");
}

TEST(ProcessesEnd, not_if_a_copy_of_the_caller_ends) {
  auto mesher = scripted_in_processes([](const Subdomain& subdomain) { return unchanged(subdomain); });
  EXPECT_EQ(mesher->refine(one_triangle()).ending, Ending::finished);
  const pid_t copy = fork();
  if (copy == 0) {
    mesher.reset();
    _exit(0);
  }
  ASSERT_EQ(waitpid(copy, nullptr, 0), copy);
  EXPECT_EQ(mesher->refine(one_triangle()).ending, Ending::finished);
}

TEST(Processes, have_no_open_file_of_the_caller_and_ignore_its_terminal) {
  const TemporaryFolder folder;
  std::FILE* const file = std::fopen((folder / "file").c_str(), "w");
  const auto other = scripted_in_processes([](const Subdomain& subdomain) { return unchanged(subdomain); });
  const auto mesher = scripted_in_processes([group = getpgrp()](const Subdomain& subdomain) {
    return unchanged(subdomain, std::to_string(open_descriptors().size()) + (getpgrp() == group ? " same" : " other"));
  });
  EXPECT_EQ(mesher->refine(one_triangle()).why, "1 other");
  std::fclose(file);
}

TEST(Processes, have_the_usual_signals) {
  std::signal(SIGUSR1, SIG_IGN);
  sigset_t blocked;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGUSR2);
  pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
  expect_ending(*bad_at_one([] { raise(SIGUSR1); }), Ending::crashed, "SIGUSR1");
  expect_ending(*bad_at_one([] { raise(SIGUSR2); }), Ending::crashed, "SIGUSR2");
  sigset_t now;
  pthread_sigmask(SIG_UNBLOCK, &blocked, &now);
  EXPECT_EQ(sigismember(&now, SIGUSR2), 1);
  EXPECT_EQ(sigismember(&now, SIGTERM), 0);
}

TEST(Processes, know_nothing_of_each_other) {
  const auto mesher = scripted_in_processes(
      [calls = 0](const Subdomain& subdomain) mutable {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return unchanged(subdomain, std::to_string(++calls));
      },
      2);
  std::string one, two;
  std::thread thread([&] { one = mesher->refine(one_triangle()).why; });
  two = mesher->refine(one_triangle()).why;
  thread.join();
  EXPECT_EQ(one, "1");
  EXPECT_EQ(two, "1");
}

}  // namespace
}  // namespace pardel
