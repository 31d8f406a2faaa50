// Runs the program in a temporary folder and examines the files there.
#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sanitized.hpp"

namespace pardel::testing {

struct Ran {
  int exit_code = 0;  ///< 128 + signal number where a signal ended the program
  std::string out;
  std::string err;
  std::uint64_t peak_memory = 0;  ///< bytes
};

/// True if this machine has pseudo-terminals.
[[nodiscard]] bool terminals_exist();

struct RunOptions {
  std::string in_file = {};                           ///< if not empty, standard input is this file
  std::string out_file = {};                          ///< if not empty, standard output is written to this file
  std::optional<std::uint64_t> file_size_limit = {};  ///< in bytes; a larger file gives the error "File too large"
  bool file_size_signal = false;                      ///< it also gives the signal SIGXFSZ
  std::optional<std::uint64_t> address_space = {};    ///< bytes
  std::optional<std::uint64_t> stack_size = {};       ///< bytes; also of each new thread
  std::optional<std::uint64_t> processor_time = {};   ///< seconds; then SIGXCPU
  std::string interrupt_when = {};                    ///< a signal is sent when standard error contains this text
  std::optional<double> interrupt_after = {};         ///< seconds; a signal is sent then
  int signal = SIGINT;                                ///< that signal
  int ignored_signal = 0;                             ///< the program starts with this signal ignored
  bool terminal = false;                              ///< standard error is a terminal
};

/// A temporary folder in which the program runs. The destructor removes it.
class Workshop : public ::testing::Test {
 protected:
  Workshop();
  ~Workshop() override;

  Ran pardel(const std::vector<std::string>& arguments, const RunOptions& options = {}) const;
  /// Runs another program, given by its path, or by its name as in a shell. Exit code 127 if it does not exist.
  Ran run(const std::string& program, const std::vector<std::string>& arguments, const RunOptions& options = {}) const;

  /// The report of `pardel mesh` with these arguments, which ends with `code`.
  [[nodiscard]] nlohmann::json report(std::vector<std::string> arguments, int code = 0) const;

  void write(const std::string& name, std::string_view text) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] bool exists(const std::string& name) const;
  /// The names of all files and folders in the temporary folder.
  [[nodiscard]] std::set<std::string> files() const;
  /// The numbers of a text file line by line, without comments and blank lines.
  [[nodiscard]] std::vector<std::vector<double>> table(const std::string& name) const;

  std::filesystem::path folder_;
};

using Files = std::set<std::string>;

/// The unit square as a .poly: points 1 to 4; each segment has its own marker.
inline constexpr const char* square_poly = R"(# the unit square
4 2 0 0
1 0 0
2 1 0
3 1 1
4 0 1
4 1
1 1 2 5
2 2 3 6
3 3 4 7
4 4 1 8
0
)";

/// Prints the output of the program when an assertion fails.
std::ostream& operator<<(std::ostream& out, const Ran& ran);

/// True if `text` contains all strings of `parts`.
::testing::AssertionResult holds(const std::string& text, const std::vector<std::string>& parts);

}  // namespace pardel::testing
