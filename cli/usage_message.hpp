// The message for a command line that is wrong.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace pardel::cli {

/// One line that names the command, the mistake and the place of the help. Suggests an option that resembles an unknown
/// one.
[[nodiscard]] std::string usage_message(const CLI::App* program, const CLI::Error& error);

/// The message for a word that names no command of the program. Suggests a command with a similar name.
[[nodiscard]] std::string unknown_command(const CLI::App& program, const std::string& word);

}  // namespace pardel::cli
