// pardel mesh: makes the mesh of a domain.
#include <fmt/core.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../core/formats.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "choice.hpp"
#include "command.hpp"
#include "findings_text.hpp"
#include "goal_options.hpp"
#include "input.hpp"
#include "memory.hpp"
#include "names.hpp"
#include "output.hpp"
#include "paranoid.hpp"
#include "progress_option.hpp"
#include "refusal.hpp"
#include "report.hpp"
#include "snap_option.hpp"
#include "supervise.hpp"
#include "verdict.hpp"

namespace pardel::cli {
namespace {

constexpr Index most_cells_along = 4096;

struct Arguments {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
  GoalOptions goal;
  Options options;
  int threads = 0;  ///< 0: all cores
  std::vector<Index> cells;
  std::optional<double> max_memory_gib;
  bool refine = false;
  bool repair = false;
  std::optional<double> snap;
  bool check = false;
  bool paranoid = false;
  bool msh_ascii = false;
  std::optional<MeshFormat> format;  ///< of the output -
  std::filesystem::path json;
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
};

struct Input {
  Source source;              ///< with --refine a mesh, otherwise a domain
  std::vector<double> sizes;  ///< as read_sizes_of() returns them
};

/// Accepts 0 to 4096, and `all`, which is 0.
CLI::Validator number_of_threads() {
  return {[](std::string& text) -> std::string {
            if (text == "all") text = "0";
            return CLI::Range(0, 4096)(text);
          },
          ""};
}

ValidateOptions how_to_validate(const Arguments& arguments) {
  return {.convex_hull = arguments.goal.convex_hull, .threads = arguments.options.threads};
}

Result<ValidPslg, Refusal> repair_domain(const Arguments& arguments, Domain domain) {
  Result<MaybeRepaired, Refusal> repaired =
      validated_or_repaired(std::move(domain), {.snap = arguments.snap, .convex_hull = arguments.goal.convex_hull},
                            arguments.options.threads);
  if (!repaired) return repaired.error();
  for (const std::string& line : repaired->log) warn(line);
  if (repaired->original && !arguments.goal.sizes.empty()) {
    return Refusal({ErrorKind::usage,
                    "--sizes refers to the points of the input, which --repair changed; write the repaired "
                    "domain with 'pardel doctor' and give sizes for its points"});
  }
  return std::move(repaired->domain);
}

/// Reads the input and the sizes, and validates a domain: the only validation of a run.
Result<Input, Refusal> read(const Arguments& arguments, ProgressBar& bar, Seconds& seconds) {
  Stopwatch watch;
  bar.begin("reading " + arguments.input.string());
  if (arguments.refine) {
    Result<CoarseMesh> coarse = read_coarse_mesh(arguments.input);
    if (!coarse) return Refusal(coarse.error());
    Result<std::vector<double>> sizes = read_sizes_of(arguments.goal);
    if (!sizes) return Refusal(sizes.error());
    seconds.read = watch.lap();
    return Input{std::move(*coarse), std::move(*sizes)};
  }
  Result<Domain> domain = read_domain(arguments.input);
  if (!domain) return Refusal(domain.error());
  Result<std::vector<double>> sizes = read_sizes_of(arguments.goal);
  if (!sizes) return Refusal(sizes.error());
  seconds.read = watch.lap();
  bar.begin("validating " + arguments.input.string());
  Result<ValidPslg, Refusal> valid = arguments.repair ? repair_domain(arguments, std::move(*domain))
                                                      : validated(std::move(*domain), how_to_validate(arguments));
  if (!valid) return valid.error();
  print_warnings(*valid, arguments.input.string());
  seconds.validate = watch.lap();
  return Input{std::move(*valid), std::move(*sizes)};
}

/// With --refine only --sizes needs a valid domain, because it triangulates the domain.
Result<Goal, Refusal> make_goal(const Arguments& arguments, const Input& input) {
  const auto with_sizes = [&](const ValidPslg& domain) -> Result<Goal, Refusal> {
    Result<Goal> goal = make_goal(arguments.goal, input.sizes, domain);
    if (!goal) return Refusal(goal.error());
    return std::move(*goal);
  };
  if (const auto* domain = std::get_if<ValidPslg>(&input.source)) return with_sizes(*domain);
  if (arguments.goal.sizes.empty()) return goal_without_sizes(arguments.goal);
  const Result<ValidPslg, Refusal> domain =
      validated(std::get<CoarseMesh>(input.source).domain, how_to_validate(arguments));
  if (!domain) return domain.error();
  return with_sizes(*domain);
}

/// Why there is no mesh. For a mesh that cannot be refined: the problems of its domain if there are any, otherwise
/// `error`.
Refusal why_not_meshed(const Arguments& arguments, const Input& input, const Error& error) {
  const auto* coarse = std::get_if<CoarseMesh>(&input.source);
  if (coarse != nullptr && error.kind == ErrorKind::invalid_input && arguments.goal.sizes.empty()) {
    std::vector<Problem> problems = find_problems(coarse->domain.pslg, how_to_validate(arguments));
    if (!problems.empty()) return refusal_of(coarse->domain, std::move(problems));
  }
  return with_name(error, arguments.input.string());
}

Result<Meshed> make_mesh(const Input& input, const Goal& goal, const Options& options) {
  if (const auto* coarse = std::get_if<CoarseMesh>(&input.source))
    return refine(coarse->mesh, coarse->max_areas, goal, options);
  return mesh(std::get<ValidPslg>(input.source), goal, options);
}

Certificate check_mesh(const Arguments& arguments, const Input& input, const Meshed& meshed, const Goal& goal,
                       ProgressBar& bar) {
  bar.begin("checking");
  // A refined mesh has the region numbers of the coarse mesh, not those of the domain.
  return check(pslg_of(input.source), meshed.mesh, goal,
               {.max_violations = most_kept(arguments.json), .foreign = arguments.refine});
}

/// Sets the options that check the mesh after every sweep (one pass of the refinement over all cells of a lattice).
/// `checked` counts the sweeps.
void watch_sweeps(const Arguments& arguments, const Pslg& pslg, const Goal& goal, std::uint64_t& checked,
                  Options& options) {
  const SweepCheck how{.convex_hull = goal.convex_hull, .foreign = arguments.refine};
  options.after_sweep = [&pslg, &checked, how](const Mesh& mesh, const Sweep& sweep) {
    return check_sweep(pslg, mesh, ++checked, sweep, how);
  };
}

Result<ExitCode> verdict(const MeshRun& run, const Mesh& mesh) {
  bool broken = false;
  if (run.certificate && !run.certificate->valid) {
    broken = !only_bounds_missed(*run.certificate);
    const bool expected = !broken && !run.report.goal_met();
    warn(run.name + (expected ? ": the check found missed bounds only\n" : ": the check found violations\n") +
         findings_text(*run.certificate, "the report of --json"));
  }
  if (!run.report.goal_met()) warn(run.name + ": " + missed_bounds(run.report, mesh, most_listed, "--json"));
  if (broken) return ExitCode::violations;
  if (!run.report.goal_met()) return ExitCode::goal_missed;
  return run.certificate && !run.certificate->valid ? ExitCode::violations : ExitCode::done;
}

/// Sets the options whose values depend on several arguments.
Status complete_options(Arguments& arguments) {
  Options& options = arguments.options;
  if (arguments.threads > 0) omp_set_num_threads(arguments.threads);  // for reading, writing and checking, too
  options.threads = omp_get_max_threads();
  options.max_memory =
      arguments.max_memory_gib ? static_cast<std::uint64_t>(*arguments.max_memory_gib * 0x1p30) : available_memory();
  if (arguments.cells.empty()) return Done{};
  if (options.decomposition == Decomposition::none)
    return Error{ErrorKind::usage, "--cells cannot be used with --decomposition none"};
  options.cells = {arguments.cells[0], arguments.cells[1]};
  return Done{};
}

/// The meshes and the report.
std::vector<std::filesystem::path> all_outputs(const Arguments& arguments) {
  std::vector<std::filesystem::path> outputs = arguments.outputs;
  outputs.push_back(arguments.json);
  return outputs;
}

Status check_outputs(const Arguments& arguments) {
  const std::vector<std::filesystem::path> inputs = {arguments.input};
  if (Status fine = check_standard_input(std::array{arguments.input, arguments.goal.sizes}); !fine) return fine;
  if (Status fine = check_stream_format(arguments.outputs, arguments.format); !fine) return fine;
  if (Status fine = check_standard_output(all_outputs(arguments)); !fine) return fine;
  if (Status fine = check_mesh_outputs(arguments.outputs, inputs); !fine) return fine;
  return check_folder(arguments.json);
}

Status write_outputs(const Arguments& arguments, const Mesh& mesh, const Pslg& pslg, ProgressBar& bar,
                     const Interrupt& interrupt) {
  const MshEncoding msh = arguments.msh_ascii ? MshEncoding::ascii : MshEncoding::binary;
  for (const auto& output : arguments.outputs) {
    if (interrupt.requested()) return interrupted();
    bar.begin("writing " + output.string());
    const std::optional<MeshFormat> format = output == "-" ? arguments.format : std::nullopt;
    if (Status written = write_mesh(mesh, pslg, output, msh, format); !written) return written;
  }
  return Done{};
}

/// Fills the report, except for the certificate and the times of other steps.
void describe(const Arguments& arguments, const Pslg& pslg, const Goal& goal, Meshed& meshed, MeshRun& run) {
  Stopwatch watch;
  run.name = arguments.input.string();
  run.points = pslg.points.size();
  run.segments = pslg.segments.size();
  run.holes = pslg.holes.size();
  run.regions = pslg.regions.size();
  run.goal = goal;
  const auto has_cap = [](const Region& region) { return std::isfinite(region.max_area); };
  run.region_caps_unused = !goal.region_caps && std::ranges::any_of(pslg.regions, has_cap);
  run.hull_by_default = !arguments.refine && !arguments.goal.convex_hull && pslg.segments.empty();
  run.sizes = arguments.goal.sizes;
  run.options = arguments.options;
  run.outputs = arguments.outputs;
  run.report = std::move(meshed.report);
  run.seconds.triangulate = run.report.triangulate_seconds;
  run.seconds.refine = run.report.refine_seconds;
  run.statistics = statistics(meshed.mesh);
  run.digest = digest(meshed.mesh);
  run.seconds.statistics = watch.lap();
}

Status print(const Arguments& arguments, const MeshRun& run) {
  if (!arguments.quiet && !has_standard_output(all_outputs(arguments))) fmt::print("{}", to_text(run));
  return arguments.json.empty() ? Status(Done{}) : write_text(to_json(run), arguments.json);
}

Result<ExitCode> run(Arguments& arguments) {
  const Stopwatch total;
  if (Status complete = complete_options(arguments); !complete) return complete.error();
  if (Status fine = check_outputs(arguments); !fine) return fine.error();
  const Interrupt interrupt;
  ProgressBar bar(arguments.progress);

  MeshRun run;
  const auto refuse = [&](const Refusal& why) { return refused(why, arguments.input, arguments.json); };
  const Result<Input, Refusal> input = read(arguments, bar, run.seconds);
  if (!input) return refuse(input.error());
  const Pslg& pslg = pslg_of(input->source);
  Stopwatch watch;
  const Result<Goal, Refusal> goal = make_goal(arguments, *input);
  if (!goal) return refuse(goal.error());
  run.seconds.read += watch.lap();
  if (interrupt.requested()) return interrupted();

  Options how = arguments.options;
  if (arguments.paranoid) watch_sweeps(arguments, pslg, *goal, run.sweeps_checked.emplace(0), how);
  Result<Meshed> meshed =
      supervise(interrupt, bar, how, [&](const Options& options) { return make_mesh(*input, *goal, options); });
  if (!meshed) return refuse(why_not_meshed(arguments, *input, meshed.error()));
  watch.lap();
  if (arguments.check) run.certificate = check_mesh(arguments, *input, *meshed, *goal, bar);
  run.seconds.check = watch.lap();
  if (Status written = write_outputs(arguments, meshed->mesh, pslg, bar, interrupt); !written) return written.error();
  run.seconds.write = watch.lap();

  bar.begin("computing statistics");
  describe(arguments, pslg, *goal, *meshed, run);
  bar.finish();
  run.seconds.total = total.seconds();
  if (Status printed = print(arguments, run); !printed) return printed.error();
  return verdict(run, meshed->mesh);
}

constexpr const char* footer =
    R"(The suffix of OUT sets the format: .node or .ele for Triangle's .node, .ele and .poly; .vtu for ParaView;
.msh for Gmsh; .off; .svg. An output file appears under its name only when it is complete.
The report of --json numbers vertices and triangles from 0, also where IN numbers from 1.
Exit status: as 'pardel --help' lists. With status 4 (a bound could not be met) the mesh is written all the same.

Examples:
  pardel mesh key.poly -o key.vtu                                   20.7 degrees, no size bound
  pardel mesh key.poly -o mesh.node -o mesh.svg --min-angle 30 --max-area 0.001 --check
  pardel mesh bay.poly -o bay.msh --regions --sizes bay.sizes --json - | jq .mesh
  pardel mesh mesh.node --refine -o finer.node --max-area 0.0001    refines a mesh; mesh.area, if any, gives caps)";

}  // namespace

Command add_mesh(CLI::App& program) {
  const auto arguments = std::make_shared<Arguments>();
  Options& options = arguments->options;
  CLI::App* app = program.add_subcommand("mesh", "Make a guaranteed-quality mesh of a domain");
  app->add_option("IN", arguments->input,
                  "The domain: .poly or .node; with --refine a mesh: .node, .ele, .msh, .vtu, .off")
      ->required()
      ->type_name("");
  app->add_option("-o,--output", arguments->outputs, "The file to write (required; may be given several times)")
      ->required()
      ->type_name("OUT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_goal_options(*app, arguments->goal, largest_min_angle_deg);

  app->add_option("--max-vertices", options.max_vertices, "Stop at this many vertices")
      ->type_name("N")
      ->check(positive_number("a number of vertices"))
      ->group("Limits");
  app->add_option("--min-edge", options.min_edge,
                  "Insert no point that would make a shorter edge (default: the limit of double precision)")
      ->check(positive_number("a length"))
      ->type_name("LENGTH")
      ->group("Limits");
  app->add_option("--max-memory", arguments->max_memory_gib,
                  "Refuse a mesh that needs more memory than this, in GiB (default: the memory available)")
      ->check(positive_number("an amount of memory"))
      ->type_name("GIB")
      ->group("Limits");
  app->add_option("--threads", arguments->threads,
                  "Number of threads; 0 or all (default): one per core; the mesh does not depend on it")
      ->type_name("N|all")
      ->transform(number_of_threads())
      ->group("Limits");

  app->add_option("--placement", options.placement, "Where new points are placed: circumcentre or off-centre (default)")
      ->transform(choice(placement_names))
      ->type_name("WHERE");
  app->add_option(
         "--decomposition", options.decomposition,
         "How the plane is cut into cells: auto (by work; the default), paper (sides of four circumradii) or none")
      ->transform(choice(decomposition_names))
      ->type_name("HOW");
  app->add_option(
         "--cells", arguments->cells,
         "Number of columns and rows of cells (default: by work); another number gives a slightly different mesh")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1U, most_cells_along).description(""))
      ->type_name("NX,NY");
  app->add_flag("--refine", arguments->refine, "Refine the mesh IN; its vertices stay");
  CLI::Option* repair = app->add_flag("--repair", arguments->repair,
                                      "Repair the domain before meshing: merge points, split segments, close tiny gaps")
                            ->excludes("--refine");
  add_snap_option(*app, arguments->snap, repair);
  app->add_flag("--check", arguments->check, "Check the mesh with exact arithmetic");
  app->add_flag("--paranoid", arguments->paranoid,
                "Also check the mesh, except for its bounds, after every sweep; stop at the first violation (slow)");
  app->add_flag("--msh-ascii", arguments->msh_ascii, "Write .msh as text (default: binary)");
  app->add_option("--format", arguments->format, "Format of the output - (standard output): msh, off, svg or vtu")
      ->transform(choice(stream_format_names))
      ->type_name("FORMAT");
  app->add_option("--json", arguments->json, "Write a report as JSON, also for invalid input; - is standard output")
      ->type_name("FILE|-");
  add_progress_option(*app, arguments->progress);
  app->add_flag("-q,--quiet", arguments->quiet, "Print nothing on standard output except the report of --json -");
  app->footer(footer);
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace pardel::cli
