#include "mesher_options.hpp"

#include <CLI/CLI.hpp>
#include <utility>

#include "../off_the_shelf/own_mesher.hpp"
#include "../off_the_shelf/program_mesher.hpp"
#include "choice.hpp"
#include "goal_options.hpp"
#include "names.hpp"

namespace pardel::cli {

void add_mesher_options(CLI::App& app, MesherArguments& arguments) {
  constexpr const char* group = "Sequential meshers";
  CLI::Option* mesher =
      app.add_option("--mesher", arguments.name,
                     "Let a sequential mesher refine the mesh part by part, on all threads: own,\n"
                     "triangle, pardel-triangle, or a command with {mesh} or {poly}; every answer is\n"
                     "verified (docs/off-the-shelf.md)")
          ->check(CLI::Validator([](const std::string& name) { return name.empty() ? "it is empty" : ""; }, ""))
          ->type_name("NAME|COMMAND")
          ->group(group);
  app.add_option("--scheme", arguments.how.scheme,
                 "How --mesher divides the work: frozen (default): parts whose borders stay, in sweeps;\n"
                 "cells: the cells of the paper, in four colours; decoupled: parts whose borders are split before")
      ->transform(choice(scheme_names))
      ->type_name("WHICH")
      ->needs(mesher)
      ->group(group);
  app.add_option("--triangles-per-task", arguments.how.triangles_per_task,
                 "About this number of triangles in a task of --mesher (default 20000); another number gives\n"
                 "another mesh")
      ->check(positive_number("a number of triangles"))
      ->type_name("N")
      ->needs(mesher)
      ->group(group);
  app.add_option("--seconds-per-task", arguments.how.seconds_per_task,
                 "End the program of --mesher after this time (default 60); pardel then does its task")
      ->check(positive_number("a number of seconds"))
      ->type_name("S")
      ->needs(mesher)
      ->group(group);
}

Status check_use(const MesherArguments& arguments, const Options& options, bool has_cells) {
  if (arguments.name.empty()) return Done{};
  for (const auto& [name, given] :
       {std::pair{"--interior fill", options.interior == Interior::fill},
        std::pair{"--decomposition", options.decomposition != Decomposition::automatic},
        std::pair{"--placement", options.placement != Placement::automatic}, std::pair{"--cells", has_cells}})
    if (given) return Error{ErrorKind::usage, std::string("--mesher cannot be used with ") + name};
  return Done{};
}

Result<std::unique_ptr<SubdomainMesher>> find_mesher(const std::string& name) {
  if (name == "own") return own_mesher();
  std::optional<MesherProgram> program = named_program(name);
  if (!program) program = MesherProgram{name};
  Result<std::unique_ptr<SubdomainMesher>> mesher = program_mesher(*program);
  if (!mesher) return Error{mesher.error().kind, "--mesher: " + mesher.error().message};
  return mesher;
}

}  // namespace pardel::cli
