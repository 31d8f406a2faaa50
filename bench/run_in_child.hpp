// Runs one measurement in a child process, to measure only its peak memory and to survive a crash of the measurement.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pardel::bench {

/// The largest resident set of this process so far, in bytes.
[[nodiscard]] inline std::uint64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

/// Runs `work` in a forked process, which the constructor starts. On Linux the child's peak memory includes the
/// parent's memory at the fork, so the parent must stay small: create inputs inside `work`.
template <class T>
class Child {
  static_assert(std::is_trivially_copyable_v<T>, "the result travels through a pipe as bytes");

 public:
  explicit Child(const std::function<T()>& work) {
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) return;
    process_ = fork();
    if (process_ == 0) {
      close(pipe_ends[0]);
      bool written = false;
      try {
        const T result = work();
        written = write(pipe_ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
      } catch (...) {  // must not unwind the parent's stack frames
      }
      _exit(written ? 0 : 1);
    }
    close(pipe_ends[1]);
    read_end_ = pipe_ends[0];
  }
  Child(Child&& other) noexcept
      : process_(std::exchange(other.process_, -1)), read_end_(std::exchange(other.read_end_, -1)) {}
  Child& operator=(Child&&) = delete;
  ~Child() { (void)result(); }

  /// Waits for the end of the process. The first call returns the result of the work, or nothing if the process died.
  [[nodiscard]] std::optional<T> result() {
    if (read_end_ < 0) return std::nullopt;
    T result{};
    const bool complete =
        process_ > 0 && read(read_end_, &result, sizeof result) == static_cast<ssize_t>(sizeof result);
    close(std::exchange(read_end_, -1));
    int status = 0;
    if (process_ > 0) waitpid(process_, &status, 0);
    if (!complete || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
    return result;
  }

 private:
  pid_t process_ = -1;
  int read_end_ = -1;
};

template <class T>
[[nodiscard]] std::optional<T> run_in_child(const std::function<T()>& work) {
  return Child<T>(work).result();
}

/// The result of a program: its exit code, its output (stdout and stderr) and its peak memory.
struct ProgramRun {
  int exit_code = -1;
  std::string output;
  std::uint64_t peak_rss_bytes = 0;
};

/// Runs a program without a shell. arguments[0] is the program, which is searched on the PATH.
[[nodiscard]] inline ProgramRun run_program(const std::vector<std::string>& arguments) {
  ProgramRun run;
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return run;
  const pid_t child = fork();
  if (child == 0) {
    dup2(pipe_ends[1], STDOUT_FILENO);
    dup2(pipe_ends[1], STDERR_FILENO);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  close(pipe_ends[1]);
  char buffer[4096];
  for (ssize_t n = 0; child > 0 && (n = read(pipe_ends[0], buffer, sizeof buffer)) > 0;)
    run.output.append(buffer, static_cast<std::size_t>(n));
  close(pipe_ends[0]);
  int status = 0;
  rusage usage{};
  if (child > 0 && wait4(child, &status, 0, &usage) == child && WIFEXITED(status)) {
    run.exit_code = WEXITSTATUS(status);
    run.peak_rss_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  }
  return run;
}

}  // namespace pardel::bench
