// Runs a program within limits on time, memory and file size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pardel::harness {

struct Limits {
  double seconds = 10;                                 ///< wall-clock time
  std::uint64_t memory_bytes = 0;                      ///< address space; 0: no limit
  std::uint64_t file_bytes = std::uint64_t{1} << 28U;  ///< size of each file that it writes
};

enum class Ending : std::uint8_t {
  exited,     ///< the child process exited; `number` is its exit code: that of the program, or 126 if the program could
              ///< not be run
  signalled,  ///< a signal ended the program; `number` is the signal
  timed_out,
  interrupted,  ///< stop() returned true
  not_started,  ///< fork or pidfd_open failed; `number` is its errno
};

struct ChildRun {
  Ending ending = Ending::not_started;
  int number = 0;  ///< its meaning depends on `ending`
};

/// Runs a command; words[0] is the path of the program. Standard input is empty; both outputs go to the file `log`. The
/// program runs in a new process group. All processes of the group are killed when the program ends, when its time is
/// over, or when stop() returns true; stop() is called about ten times a second. Several threads may
/// call run_child() at the same time.
[[nodiscard]] ChildRun run_child(const std::vector<std::string>& words, const std::filesystem::path& log,
                                 const Limits& limits, const std::function<bool()>& stop);

/// The name of a signal, such as "SIGSEGV".
[[nodiscard]] std::string signal_name(int signal);

}  // namespace pardel::harness
