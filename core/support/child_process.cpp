#include "child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <mutex>
#include <string_view>

#include "partial_files.hpp"
#include "shell_words.hpp"
#include "short_lived.hpp"
#include "shortened.hpp"

namespace pardel {
namespace {

using Clock = std::chrono::steady_clock;

void limit(__rlimit_resource resource, std::uint64_t value) {
  const rlimit both = {value, value};
  setrlimit(resource, &both);
}

/// Replaces the child process, after the fork, by the program argv[0]. Makes system calls only, because other threads
/// may have held locks at the fork.
[[noreturn]] void exec_in_child(char* const* argv, char* const* environment, const char* log, const ChildLimits& limits,
                                pid_t parent) {
  setpgid(0, 0);
  // The signal comes when the thread that waits for the child ends: then the whole process has ended.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(126);
  const int in = open("/dev/null", O_RDONLY);
  const int out = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
  if (in < 0 || out < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0) _exit(126);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, limits.file_bytes);
  if (limits.memory_bytes > 0) limit(RLIMIT_AS, limits.memory_bytes);
  execve(argv[0], argv, environment);
  constexpr char reason[] = "error: the program cannot be started: ";
  const char* why = strerrordesc_np(errno);
  if (write(2, reason, sizeof reason - 1) > 0 && why != nullptr && write(2, why, std::strlen(why)) > 0) _exit(126);
  _exit(126);
}

/// The variables of this process; with one_thread also OMP_NUM_THREADS=1.
std::vector<char*> environment_for(const ChildLimits& limits) {
  static constexpr std::string_view threads = "OMP_NUM_THREADS=";
  std::vector<char*> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!limits.one_thread || !std::string_view(*variable).starts_with(threads)) variables.push_back(*variable);
  if (limits.one_thread) variables.push_back(const_cast<char*>("OMP_NUM_THREADS=1"));
  variables.push_back(nullptr);
  return variables;
}

/// Waits until the child has exited, its time is over, or stop() returns true.
ChildEnding wait_for(int handle, const ChildLimits& limits, const std::function<bool()>& stop) {
  const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
  while (true) {
    const double left = std::chrono::duration<double, std::milli>(deadline - Clock::now()).count();
    if (left <= 0) return ChildEnding::timed_out;
    if (stop()) return ChildEnding::interrupted;
    pollfd end = {handle, POLLIN, 0};
    if (poll(&end, 1, static_cast<int>(std::clamp(left, 1.0, 100.0))) > 0) return ChildEnding::exited;
  }
}

}  // namespace

ChildRun run_child(const std::vector<std::string>& words, const std::filesystem::path& log, const ChildLimits& limits,
                   const std::function<bool()>& stop) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const std::vector<char*> environment = environment_for(limits);

  const pid_t parent = getpid();
  pid_t child = -1;
  {
    const std::scoped_lock lock(PartialFiles::of_process().mutex);
    child = fork();
    if (child < 0) return {ChildEnding::not_started, errno};
    if (child == 0) exec_in_child(argv.data(), environment.data(), log.c_str(), limits, parent);
    setpgid(child, child);  // in parent and child, so the group exists before it is killed
    ShortLived::of_process().add_child(child);
  }
  // glibc 2.36 declares pidfd_open() without extern "C".
  const int handle = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
  const int no_handle = errno;
  const ChildEnding ending = handle < 0 ? ChildEnding::not_started : wait_for(handle, limits, stop);
  if (handle >= 0) close(handle);
  kill(-child, SIGKILL);  // before waitpid(), while the process id cannot be reused
  ShortLived::of_process().forget_child(child);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (ending == ChildEnding::not_started) return {ending, no_handle};
  if (ending != ChildEnding::exited) return {ending, 0};
  if (WIFSIGNALED(status)) return {ChildEnding::signalled, WTERMSIG(status)};
  return {ChildEnding::exited, WEXITSTATUS(status)};
}

std::string telling_line(const std::filesystem::path& log, const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(log, error)) return "";  // a pipe would never end
  std::ifstream in(log);
  std::string telling;
  for (std::string line; std::getline(in, line);) {
    std::erase_if(line, [](unsigned char c) { return std::iscntrl(c) != 0; });
    if (line.find_first_not_of(' ') != std::string::npos) telling = line;
    if (line.find("rror") != std::string::npos) break;
  }
  return shortened(replaced(telling, folder.string() + '/', ""));
}

std::string signal_name(int signal) {
  const char* abbreviation = sigabbrev_np(signal);
  return abbreviation != nullptr ? std::string("SIG") + abbreviation : "signal " + std::to_string(signal);
}

}  // namespace pardel
