// The message for a command line that is wrong.
#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <string_view>

namespace pardel::cli {

/// An option that a command does not have, although the same command of the other program has it (pardel, pardel-mpi).
struct AbsentOption {
  std::string_view command;
  std::string_view names;  ///< of the option, as CLI11 takes them: "-j,--drop-unused"
  std::string_view why;    ///< why not, and what to do instead: the end of a sentence
};

/// One line that names the command, the mistake and the place of the help. Of an option of the other program it says
/// why it is absent. For another unknown option it suggests one that resembles it.
[[nodiscard]] std::string usage_message(const CLI::App* program, const CLI::Error& error,
                                        std::span<const AbsentOption> absent);

/// The message for a word that names no command of the program. Suggests a command with a similar name.
[[nodiscard]] std::string unknown_command(const CLI::App& program, const std::string& word);

}  // namespace pardel::cli
