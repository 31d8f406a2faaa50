// A program of unknown manners, run within limits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pardel::harness {

struct Limits {
  double seconds = 10;                                 ///< of wall clock
  std::uint64_t memory_bytes = 0;                      ///< of address space; 0: no limit
  std::uint64_t file_bytes = std::uint64_t{1} << 28U;  ///< of each file that it writes
};

enum class Ending : std::uint8_t {
  exited,     ///< number: the exit code; 126 where it could not be run at all
  signalled,  ///< number: the signal
  timed_out,
  interrupted,  ///< by `stop`
  not_started,  ///< number: the errno of fork
};

struct ChildRun {
  Ending ending = Ending::not_started;
  int number = 0;
};

/// Runs `words` (the first is a path), standard input empty, both outputs into the file `log`. The program gets a
/// process group of its own, all of which is killed when it ends, its time is over, or stop() says so (asked about
/// ten times a second). Callable from several threads.
[[nodiscard]] ChildRun run_child(const std::vector<std::string>& words, const std::filesystem::path& log,
                                 const Limits& limits, const std::function<bool()>& stop);

/// "SIGSEGV".
[[nodiscard]] std::string signal_name(int signal);

}  // namespace pardel::harness
