// The subcommands. Each has a file NAME_command.cpp with its options and with the function that runs it.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include "../core/result.hpp"
#include "exit_code.hpp"

namespace pardel::cli {

/// main() calls `run` when the command line contains the subcommand `app`. `run` owns the parsed arguments.
struct Command {
  CLI::App* app = nullptr;
  std::function<Result<ExitCode>()> run;
};

[[nodiscard]] Command add_mesh(CLI::App& program);
[[nodiscard]] Command add_check(CLI::App& program);
[[nodiscard]] Command add_convert(CLI::App& program);
[[nodiscard]] Command add_doctor(CLI::App& program);
[[nodiscard]] Command add_draw(CLI::App& program);
[[nodiscard]] Command add_generate(CLI::App& program);

/// `pardel triangle SWITCHES FILE` has Triangle's own syntax, so it parses its arguments itself.
[[nodiscard]] Result<ExitCode> run_triangle(const std::vector<std::string>& arguments);
inline constexpr const char* triangle_summary = "Run with Triangle's switches and file names";

}  // namespace pardel::cli
