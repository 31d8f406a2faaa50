// The subcommands. Each has a file NAME_command.cpp with its options and with the function that runs it.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include "../core/result.hpp"
#include "exit_code.hpp"

namespace pardel::cli {

/// Runs a command. It owns the parsed arguments.
using Run = std::function<Result<ExitCode>()>;

/// A command that has been added to a program: `run` is called when the command line contains the subcommand `app`.
struct Command {
  CLI::App* app = nullptr;
  Run run;
};

// Each adds the options of its command to `app`.
[[nodiscard]] Run mesh_command(CLI::App& app);
[[nodiscard]] Run check_command(CLI::App& app);
[[nodiscard]] Run convert_command(CLI::App& app);
[[nodiscard]] Run doctor_command(CLI::App& app);
[[nodiscard]] Run draw_command(CLI::App& app);
[[nodiscard]] Run generate_command(CLI::App& app);

/// `pardel triangle SWITCHES FILE` has Triangle's own syntax, so it parses its arguments itself.
[[nodiscard]] Result<ExitCode> run_triangle(const std::vector<std::string>& arguments);
inline constexpr const char* triangle_summary = "Run with Triangle's switches and file names";

}  // namespace pardel::cli
