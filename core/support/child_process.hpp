// Runs a program within limits on time, memory and file size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pardel {

struct ChildLimits {
  double seconds = 10;                                 ///< wall-clock time
  std::uint64_t memory_bytes = 0;                      ///< address space; 0: no limit
  std::uint64_t file_bytes = std::uint64_t{1} << 28U;  ///< size of each file that it writes
  bool one_thread = false;                             ///< its OMP_NUM_THREADS is 1
};

enum class ChildEnding : std::uint8_t {
  exited,     ///< the child process exited; `number` is its exit code: that of the program, or 126 if the program could
              ///< not be run
  signalled,  ///< a signal ended the program; `number` is the signal
  timed_out,
  interrupted,  ///< stop() returned true
  not_started,  ///< fork or pidfd_open failed; `number` is its errno
};

struct ChildRun {
  ChildEnding ending = ChildEnding::not_started;
  int number = 0;  ///< its meaning depends on `ending`
};

/// Runs a command; words[0] is the path of the program. Standard input is empty; both outputs go to the file `log`. The
/// program runs in a new process group. All processes of the group are killed when the program ends, when its time is
/// over, when stop() returns true, or when this process ends early (short_lived.hpp); the program itself also when this
/// process is killed. stop() is called about ten times a second. Several threads may
/// call run_child() at the same time.
[[nodiscard]] ChildRun run_child(const std::vector<std::string>& words, const std::filesystem::path& log,
                                 const ChildLimits& limits, const std::function<bool()>& stop);

/// Of what a program has written to its log: the first line that contains "error", otherwise the last line that is not
/// blank; without control characters, and not more than some hundred characters of it. File names are shown without
/// `folder`. Empty if the log is not a regular file.
[[nodiscard]] std::string telling_line(const std::filesystem::path& log, const std::filesystem::path& folder);

/// The name of a signal, such as "SIGSEGV".
[[nodiscard]] std::string signal_name(int signal);

}  // namespace pardel
