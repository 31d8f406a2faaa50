// pardel: the program. Runs the subcommand and turns an error into a message and an exit code.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "exit_code.hpp"
#include "failure_watch.hpp"
#include "help.hpp"
#include "interrupt_watch.hpp"
#include "processors.hpp"
#include "usage_message.hpp"

namespace pardel::cli {
namespace {

constexpr const char* description =
    "pardel: guaranteed-quality Delaunay meshes of planar domains, with an independent exact check.";

constexpr const char* examples = R"(Examples:
  pardel generate key -o key.poly                       a domain to try
  pardel mesh key.poly -o key.vtu --min-angle 30        a mesh without angles below 30 degrees
  pardel mesh key.poly -o m.node --max-area 0.001       Triangle's files m.node, m.ele and m.poly
  pardel check key.poly key.vtu --min-angle 30          checks that mesh with exact arithmetic
  pardel doctor survey.poly --repair fixed.poly         lists the problems of a domain and repairs it
  pardel convert key.vtu key.msh                        the same mesh in another format
  pardel draw key.vtu key.png --by quality              a picture
  pardel triangle -pq30a0.1 key.poly                    like Triangle: writes key.1.node, key.1.ele, key.1.poly

Exit status:
  0    done; every bound holds, except at triangles that a small input angle exempts (they are reported)
  1    the check found violations
  2    the command line is wrong
  3    the input is invalid; the message names the place
  4    a bound could not be met because of a limit or of rounding; the mesh is written and the triangles are listed
  5    out of memory, or a file cannot be opened, read or written
  6    internal error: a self-check failed; nothing is written
  130  interrupted

Every command has its own help: pardel help COMMAND, or pardel COMMAND --help.)";

constexpr std::array<AbsentOption, 2> options_of_pardel_mpi = {{
    {"mesh", "--read", "one process reads the whole input; 'pardel-mpi mesh' lets each rank read a part"},
    {"mesh", "--pieces", "one process makes a mesh as a whole; 'pardel-mpi mesh --interior fill' makes it in pieces"},
}};

struct NamedCommand {
  const char *name, *summary;
  Run (*add_options)(CLI::App&);
};

constexpr std::array<NamedCommand, 6> commands = {{
    {"mesh", "Make a guaranteed-quality mesh of a domain", mesh_command},
    {"check", "Prove that a mesh is right for its domain, or list what is wrong", check_command},
    {"convert", "Write a mesh or a domain in another format, without changing it", convert_command},
    {"doctor", "List what is wrong with a domain, and repair it", doctor_command},
    {"draw", "Draw a domain or a mesh as SVG or PNG", draw_command},
    {"generate", "Write a named domain as a .poly file", generate_command},
}};

/// Adds all commands, for --help, and the options of the command that is called: those of all commands would take as
/// long as a small mesh.
Run add_commands(CLI::App& program, const std::string& called) {
  Run run;
  for (const NamedCommand& command : commands) {
    CLI::App* app = program.add_subcommand(command.name, command.summary);
    if (called == command.name) run = command.add_options(*app);
  }
  program.add_subcommand("triangle", triangle_summary);  // run() handles it before
  program.add_subcommand("help", "Print the help of a command: pardel help COMMAND");
  return run;
}

Result<ExitCode> run(std::vector<std::string> arguments) {
  expand_help(arguments);
  const std::string first = arguments.empty() ? std::string() : arguments.front();
  if (first == "triangle") {
    arguments.erase(arguments.begin());
    return run_triangle(arguments);
  }
  CLI::App program(description, "pardel");
  program.set_version_flag("-V,--version", "pardel " PARDEL_VERSION);
  program.footer(examples);
  program.formatter(std::make_shared<HelpFormatter>());  // subcommands inherit it
  program.failure_message(
      [](const CLI::App* app, const CLI::Error& error) { return usage_message(app, error, options_of_pardel_mpi); });
  program.require_subcommand(1);
  const Run run_command = add_commands(program, first);

  const auto is_named = [&](const CLI::App* command) { return command->check_name(first); };
  if (!first.empty() && first[0] != '-' && program.get_subcommands(is_named).empty())
    return Error{ErrorKind::usage, unknown_command(program, first)};
  std::ranges::reverse(arguments);  // CLI11 takes the last argument first
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& stop) {  // also --help and --version
    return program.exit(stop) == 0 ? ExitCode::done : ExitCode::usage;
  }
  return run_command ? run_command() : ExitCode::usage;
}

/// An error of standard output, such as a full disk, becomes visible only when the buffer is flushed.
ExitCode flushed(ExitCode code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return report({ErrorKind::io, fmt::format("standard output: {}", std::strerror(errno))});
}

ExitCode guarded(int argc, char** argv) {
  const FailureWatch failure_watch;
  try {
    const InterruptWatch interrupt_watch;
    keep_to_processor_quota();
    const Result<ExitCode> result = run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
    return flushed(result ? *result : report(result.error()));
  } catch (const Error& thrown) {  // by a function of sizes
    return report(thrown);
  } catch (const std::bad_alloc&) {
    return report({ErrorKind::resources, "out of memory"});
  } catch (const std::exception& unexpected) {
    return report({ErrorKind::resources, unexpected.what()});
  }
}

}  // namespace
}  // namespace pardel::cli

int main(int argc, char** argv) { return static_cast<int>(pardel::cli::guarded(argc, argv)); }
