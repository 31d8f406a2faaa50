// What the program's exit status says, and how an error becomes one.
#pragma once

#include "../core/result.hpp"

namespace pardel::cli {

enum class ExitCode : int {
  done = 0,           ///< every bound holds, but for exemptions that a small input angle justifies
  violations = 1,     ///< the check found violations
  usage = 2,          ///< the command line asks for something that has no meaning
  invalid_input = 3,  ///< the input is not what it should be
  goal_missed = 4,    ///< a bound could not be met for another reason; the mesh is written all the same
  failure = 5,        ///< memory, or a file that cannot be opened, read or written
  internal = 6,       ///< the program noticed that it is wrong itself; nothing is written
  interrupted = 130,  ///< SIGINT
};

[[nodiscard]] ExitCode exit_code(ErrorKind kind);

/// Puts the error on stderr, as `pardel: message`, and gives its exit code.
ExitCode report(const Error& error);

/// A line on stderr about something that does not stop the program.
void warn(const std::string& message);

}  // namespace pardel::cli
