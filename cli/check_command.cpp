// pardel check: checks whether a mesh is valid for a domain and meets a goal.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../core/formats.hpp"
#include "../core/support/open_file.hpp"
#include "../properties/checker/check.hpp"
#include "beside_mesh.hpp"
#include "certificate_report.hpp"
#include "command.hpp"
#include "distinct_files.hpp"
#include "goal_options.hpp"
#include "input.hpp"
#include "numbers_in_findings.hpp"
#include "output.hpp"
#include "progress_option.hpp"
#include "rounded_points.hpp"
#include "threads_option.hpp"
#include "verdict.hpp"

namespace pardel::cli {
namespace {

struct CheckArguments {
  std::filesystem::path domain;
  std::filesystem::path mesh;
  GoalOptions goal;
  double max_circumradius = 0;
  std::filesystem::path json;
  int threads = 0;
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
};

struct CheckInput {
  ValidPslg domain;
  Mesh mesh;
  MeshFormat format;
  Goal goal;
};

/// What a format has no place for cannot be compared with the domain. A .2dm and a .gr3 have one attribute, a height or
/// depth, also if the domain has none or several. The boundaries of a .gr3 have kinds instead of markers, and segments
/// inside the domain are missing.
void leave_out_what_means_something_else(MeshFormat format, const Pslg& domain, Mesh& mesh) {
  const bool has_heights = format == MeshFormat::two_dm || format == MeshFormat::gr3;
  if (has_heights && domain.attributes_per_point != 1) {
    mesh.attributes_per_point = 0;
    mesh.point_attributes.clear();
  }
  if (format == MeshFormat::gr3) mesh.constrained_edges.clear();
}

Result<CheckInput, Refusal> read(const CheckArguments& arguments, ProgressBar& bar) {
  bar.begin("reading " + arguments.domain.string());
  Result<Domain> read = read_domain(arguments.domain);
  if (!read) return Refusal(read.error());
  bar.begin("validating " + arguments.domain.string());
  Result<ValidPslg, Refusal> domain = validated(std::move(*read), {.convex_hull = arguments.goal.convex_hull});
  if (!domain) return domain.error();
  bar.begin("reading " + arguments.mesh.string());
  Result<MeshOfFile> of_file = read_mesh_and_format(arguments.mesh);
  if (!of_file) return Refusal(of_file.error());
  auto& [mesh, format] = *of_file;
  note_beside_mesh(mesh, arguments.mesh, ", which the check does not use");
  leave_out_what_means_something_else(format, domain->pslg(), mesh);
  // Lengths that were repaired for the mesh have to be the same here.
  const Result<GivenSizes> sizes = read_given_sizes(arguments.goal, CrossingPolygons::repaired);
  if (!sizes) return Refusal(sizes.error());
  Result<Goal> goal = make_goal(arguments.goal, *sizes, *domain);
  if (!goal) return Refusal(goal.error());
  return CheckInput{std::move(*domain), std::move(mesh), format, std::move(*goal)};
}

/// The file with the coordinates of the mesh.
std::filesystem::path file_of_points(std::filesystem::path mesh) {
  return mesh.extension() == ".ele" ? mesh.replace_extension(".node") : mesh;
}

void print(const CheckArguments& arguments, const CheckInput& input, const Certificate& certificate) {
  const NumbersInWitnesses numbers = numbers_of_files(input.domain.pslg().first_id, input.mesh);
  print_certificate(certificate, arguments.json, numbers, arguments.max_circumradius);
  if (are_input_points_rounded(certificate, input.mesh)) {
    fmt::print("hint    vertices differ from input points by rounding only: {} has too few digits{}\n",
               file_of_points(arguments.mesh).string(),
               input.format == MeshFormat::msh ? ". Gmsh writes exact coordinates with -bin -format msh41" : "");
  }
}

Status check_output_of(const CheckArguments& arguments) {
  const std::array outputs = {NamedFile{"--json", arguments.json}};
  const std::array inputs = {domain_input(arguments.domain), NamedFile{{}, arguments.mesh},
                             NamedFile{{}, arguments.goal.sizes, false}, NamedFile{{}, arguments.goal.sources, false}};
  if (Status fine = check_distinct(outputs, inputs); !fine) return fine;
  return check_folder(arguments.json);
}

Result<ExitCode> run(const CheckArguments& arguments) {
  const std::array inputs = {arguments.domain, arguments.mesh, arguments.goal.sizes, arguments.goal.sources};
  if (Status fine = check_standard_input(inputs); !fine) return fine.error();
  if (Status fine = check_output_of(arguments); !fine) return fine.error();
  use_threads(arguments.threads);
  ProgressBar bar(arguments.progress);
  const Result<CheckInput, Refusal> input = read(arguments, bar);
  if (!input) return refused(input.error(), arguments.domain, arguments.json);

  // Mesh files do not contain the origin of each vertex.
  const CheckOptions options{
      .max_violations = most_kept(arguments.json), .max_circumradius = arguments.max_circumradius, .foreign = true};
  bar.begin("checking");
  const Certificate certificate = check(input->domain.pslg(), input->mesh, input->goal, options);
  bar.finish();
  if (Status sized = require_sizes(input->mesh, input->goal, certificate); !sized) return sized.error();
  if (!arguments.quiet && !is_standard_output(arguments.json)) print(arguments, *input, certificate);
  if (!arguments.json.empty()) {
    if (Status written = write_text(to_json(certificate) + "\n", arguments.json); !written) return written.error();
  }
  return certificate.valid ? ExitCode::done : ExitCode::violations;
}

}  // namespace

Run check_command(CLI::App& app) {
  const auto arguments = std::make_shared<CheckArguments>();
  app.add_option("IN.poly", arguments->domain, "The domain: .poly, .node or .geojson; - is standard input")
      ->required()
      ->type_name("");
  app.add_option("MESH", arguments->mesh,
                 "The mesh, made by any program: .node, .ele, .msh, .vtu, .pvtu, .off, .vtk, .2dm,\n.gr3, .14; - is "
                 "standard input "
                 "(.msh, .vtu, .off, .vtk, .2dm)")
      ->required()
      ->type_name("");
  add_goal_options(app, arguments->goal, largest_angle_to_check);
  app.add_option("--max-circumradius", arguments->max_circumradius, "No circumradius above this, compared exactly")
      ->check(positive_number("a radius"))
      ->type_name("LENGTH")
      ->group("Goal");
  app.add_option("--json", arguments->json, "Write the certificate as JSON, with all violations; - is standard output")
      ->type_name("FILE|-");
  add_threads_option(app, arguments->threads, "the certificate");
  add_progress_option(app, arguments->progress);
  app.add_flag("-q,--quiet", arguments->quiet, "Print nothing on standard output except the certificate of --json -");
  app.footer(
      "Exit status 0: the mesh is right; 1: it is wrong, and the violations are listed with their places.\n\n"
      "Example:\n  pardel check key.poly key.msh --min-angle 30 --max-area 0.001 --json certificate.json");
  return [arguments] { return run(*arguments); };
}

}  // namespace pardel::cli
