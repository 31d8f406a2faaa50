// The exit status of the program.
#pragma once

#include <string>
#include <string_view>

#include "../core/result.hpp"

namespace pardel::cli {

enum class ExitCode : int {
  done = 0,           ///< every bound holds, except in triangles that a small input angle exempts
  violations = 1,     ///< the check found violations
  usage = 2,          ///< the command line is wrong
  invalid_input = 3,  ///< the input is invalid
  goal_missed = 4,    ///< a bound could not be met for another reason; the mesh is written anyway
  failure = 5,        ///< out of memory or of time, or a file cannot be opened, read or written
  internal = 6,       ///< internal error: a self-check failed; nothing is written
  interrupted = 130,  ///< stopped by SIGINT, SIGTERM or SIGHUP
};

[[nodiscard]] ExitCode exit_code(ErrorKind kind);

/// Prints `program: message` on stderr and returns the exit code of the error.
ExitCode report(const Error& error, std::string_view program = "pardel");

/// The characters that erase a progress line if stderr is a terminal; otherwise none.
[[nodiscard]] const char* erase_progress_line();

/// Prints `program: message` on stderr. The program continues.
void warn(const std::string& message, std::string_view program = "pardel");

/// Prints the text as it is. Ignores failures, for example because stderr is on a full disk: nothing could tell them.
void print_on_stderr(std::string_view text);

}  // namespace pardel::cli
