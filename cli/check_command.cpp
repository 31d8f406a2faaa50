// pardel check: checks whether a mesh is valid for a domain and meets a goal.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "../core/formats.hpp"
#include "../properties/checker/check.hpp"
#include "command.hpp"
#include "goal_options.hpp"
#include "input.hpp"
#include "output.hpp"

namespace pardel::cli {
namespace {

struct Arguments {
  std::filesystem::path domain;
  std::filesystem::path mesh;
  GoalOptions goal;
  double max_circumradius = 0;
  std::filesystem::path json;
  bool quiet = false;
};

Result<ExitCode> run(const Arguments& arguments) {
  if (Status folder = check_folder(arguments.json); !folder) return folder.error();
  Result<Domain> read = read_domain(arguments.domain);
  if (!read) return read.error();
  const Result<ValidPslg> domain = validated(std::move(*read), {.convex_hull = arguments.goal.convex_hull});
  if (!domain) return domain.error();
  const Result<Mesh> mesh = read_mesh(arguments.mesh);
  if (!mesh) return mesh.error();
  const Result<std::vector<double>> sizes = read_sizes_of(arguments.goal);
  if (!sizes) return sizes.error();
  const Result<Goal> goal = make_goal(arguments.goal, *sizes, *domain);
  if (!goal) return goal.error();

  // Mesh files do not contain the origin of each vertex.
  const CheckOptions options{.max_circumradius = arguments.max_circumradius, .foreign = true};
  const Certificate certificate = check(domain->pslg(), *mesh, *goal, options);
  if (!arguments.quiet && arguments.json != "-") fmt::print("{}\n", to_text(certificate));
  if (!arguments.json.empty()) {
    if (Status written = write_text(to_json(certificate) + "\n", arguments.json); !written) return written.error();
  }
  return certificate.valid ? ExitCode::done : ExitCode::violations;
}

}  // namespace

Command add_check(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = program.add_subcommand("check", "Prove that a mesh is right for its domain, or list what is wrong");
  app->add_option("IN.poly", arguments->domain, "The domain: .poly or .node")->required()->type_name("");
  app->add_option("MESH", arguments->mesh, "The mesh, made by any program: .node, .ele, .msh, .vtu, .off")
      ->required()
      ->type_name("");
  add_goal_options(*app, arguments->goal, largest_angle_to_check);
  app->add_option("--max-circumradius", arguments->max_circumradius, "No circumradius above this, compared exactly")
      ->check(positive_number("a radius"))
      ->type_name("LENGTH")
      ->group("Goal");
  app->add_option("--json", arguments->json, "Write the certificate as JSON; - is standard output")
      ->type_name("FILE|-");
  app->add_flag("-q,--quiet", arguments->quiet, "Print nothing on standard output except the certificate of --json -");
  app->footer(
      "Exit status 0: the mesh is right; 1: it is wrong, and every violation is listed with its place.\n\n"
      "Example:\n  pardel check key.poly key.msh --min-angle 30 --max-area 0.001 --json certificate.json");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace pardel::cli
