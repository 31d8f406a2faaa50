// pardel mesh: makes the mesh of a domain.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
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
#include "beside_mesh.hpp"
#include "command.hpp"
#include "findings_text.hpp"
#include "gaps_text.hpp"
#include "input.hpp"
#include "kept_segments.hpp"
#include "many_triangles.hpp"
#include "memory_watch.hpp"
#include "mesh_options.hpp"
#include "output.hpp"
#include "paranoid.hpp"
#include "plural.hpp"
#include "points_outside.hpp"
#include "refusal.hpp"
#include "renumber.hpp"
#include "report.hpp"
#include "verdict.hpp"
#include "with_progress.hpp"

namespace pardel::cli {
namespace {

struct MeshInput {
  Source source;  ///< with --refine a mesh, otherwise a domain
  GivenSizes sizes;
  std::vector<Warning> warnings{};
};

ValidateOptions how_to_validate(const MeshArguments& arguments) {
  return {.convex_hull = arguments.goal.convex_hull, .threads = arguments.options.threads};
}

/// Reads the input and the sizes, and validates a domain: the only validation of a run.
Result<MeshInput, Refusal> read(const MeshArguments& arguments, ProgressBar& bar, Seconds& seconds) {
  Stopwatch watch;
  bar.begin("reading " + arguments.input.string());
  const CrossingPolygons crossing = arguments.repair ? CrossingPolygons::repaired : CrossingPolygons::refused;
  if (arguments.refine) {
    Result<CoarseMesh> coarse = read_coarse_mesh(arguments.input);
    if (!coarse) return Refusal(coarse.error());
    note_beside_mesh(coarse->mesh, arguments.input, ", which the refined mesh does not have");
    if (!coarse->note_about_poly.empty()) warn(coarse->note_about_poly);
    if (const std::string note = note_about(coarse->followed); !note.empty())
      warn(fmt::format("{}: {}", coarse->domain.name, note));
    if (Status kept = check_kept_segments(*coarse, arguments.options.kept_markers); !kept)
      return Refusal(with_name(kept.error(), arguments.input.string()));
    Result<GivenSizes> sizes = read_given_sizes(arguments.goal, crossing);
    if (!sizes) return Refusal(sizes.error());
    seconds.read = watch.lap();
    return MeshInput{std::move(*coarse), std::move(*sizes)};
  }
  Result<Domain> domain = read_domain(arguments.input);
  if (!domain) return Refusal(domain.error());
  Result<GivenSizes> sizes = read_given_sizes(arguments.goal, crossing);
  if (!sizes) return Refusal(sizes.error());
  seconds.read = watch.lap();
  bar.begin("validating " + arguments.input.string());
  Result<MaybeRepaired, Refusal> valid =
      valid_domain(std::move(*domain), arguments.repair,
                   {.snap = arguments.snap, .convex_hull = arguments.goal.convex_hull}, arguments.options.threads);
  if (!valid) return valid.error();
  for (const std::string& line : valid->log) warn(line);
  if (Status kept = check_kept_segments(*valid, arguments.options.kept_markers); !kept)
    return Refusal(with_name(kept.error(), arguments.input.string()));
  if (Status fits = check_sizes_of(*valid, sizes->field); !fits) return Refusal(fits.error());
  std::vector<Warning> warnings = print_warnings(valid->domain, arguments.input.string());
  seconds.validate = watch.lap();
  return MeshInput{std::move(valid->domain), std::move(*sizes), std::move(warnings)};
}

/// With --refine only --sizes needs a valid domain: one that can be triangulated.
Result<Goal, Refusal> make_goal(const MeshArguments& arguments, const MeshInput& input) {
  const auto with_sizes = [&](const ValidPslg& domain, const NumbersInFile& numbers) -> Result<Goal, Refusal> {
    Result<Goal> goal = make_goal(arguments.goal, input.sizes, domain, numbers);
    if (!goal) return Refusal(goal.error());
    return std::move(*goal);
  };
  if (const auto* domain = std::get_if<ValidPslg>(&input.source)) return with_sizes(*domain, {});
  if (arguments.goal.sizes.empty()) return goal_without_sizes(arguments.goal);
  const CoarseMesh& coarse = std::get<CoarseMesh>(input.source);
  const Result<ValidPslg, Refusal> domain = validated(coarse.domain, how_to_validate(arguments));
  if (!domain) return domain.error();
  return with_sizes(*domain, coarse.domain.points);
}

/// Why there is no mesh. For a mesh that cannot be refined: the problems of its points and segments if there are any,
/// otherwise `error`. Holes and regions are made of the mesh, so their problems do not say what is wrong in the file.
Refusal why_not_meshed(const MeshArguments& arguments, const MeshInput& input, const Error& error) {
  const auto* coarse = std::get_if<CoarseMesh>(&input.source);
  if (coarse != nullptr && error.kind == ErrorKind::invalid_input && arguments.goal.sizes.empty()) {
    const std::vector<Problem> problems = find_problems(coarse->domain.pslg, how_to_validate(arguments));
    if (!problems.empty() && problems.front().kind < ProblemKind::unclosed_outline)
      return refusal_of(coarse->domain, problems);
  }
  return with_name(error, arguments.input.string());
}

/// The mesh of a domain by the mesher of --mesher. Describes in `run` what the mesher has done.
Result<Meshed> mesh_with(SubdomainMesher& mesher, const MesherArguments& arguments, const ValidPslg& domain,
                         const Goal& goal, const Options& options, MeshRun& run) {
  Result<MeshedWithMesher> made = mesh_with_mesher(domain, goal, mesher, arguments.how, options);
  if (!made) return made.error();
  run.mesher = MesherOfRun{arguments.name, arguments.how.scheme, made->mesher};
  return Meshed{std::move(made->mesh), std::move(made->report)};
}

/// `mesher`: that of --mesher, or null.
Result<Meshed> make_mesh(const MeshArguments& arguments, const MeshInput& input, SubdomainMesher* mesher,
                         const Goal& goal, const Options& options, MeshRun& run) {
  if (const auto* coarse = std::get_if<CoarseMesh>(&input.source)) {
    Result<Meshed> refined = refine(coarse->mesh, coarse->max_areas, goal, options);
    if (refined) refined->mesh.names = coarse->mesh.names;  // markers and regions stay the same
    return refined;
  }
  const ValidPslg& domain = std::get<ValidPslg>(input.source);
  if (mesher != nullptr) return mesh_with(*mesher, arguments.mesher, domain, goal, options, run);
  return mesh(domain, goal, options);
}

Certificate check_mesh(const MeshArguments& arguments, const MeshInput& input, const Meshed& meshed, const Goal& goal,
                       ProgressBar& bar) {
  bar.begin("checking");
  // A refined mesh has the region numbers of the coarse mesh, not those of the domain. Without the points outside, the
  // vertices do not have the numbers of the input.
  return check(pslg_of(input.source), meshed.mesh, goal,
               {.max_violations = most_kept(arguments.json), .foreign = arguments.refine || arguments.drop_unused});
}

/// Sets the options that check the mesh after every sweep (parallel/sweep.hpp). `checked` counts the sweeps.
void watch_sweeps(const MeshArguments& arguments, const Pslg& pslg, const Goal& goal, std::uint64_t& checked,
                  Options& options) {
  const SweepCheck how{.convex_hull = goal.convex_hull, .foreign = arguments.refine};
  options.after_sweep = [&pslg, &checked, how](const Mesh& mesh, const Sweep& sweep) {
    return check_sweep(pslg, mesh, ++checked, sweep, how);
  };
}

/// Says how many points are in no triangle, and leaves them out if the user wants it.
void note_and_drop_points_outside(const MeshArguments& arguments, Mesh& mesh, MeshRun& run) {
  const PointsOutside outside = points_outside(mesh);
  run.points_outside = outside.count;
  if (outside.count == 0) return;
  const char* then =
      arguments.drop_unused ? "the mesh is written without them" : "--drop-unused writes the mesh without them";
  warn(fmt::format("{}: {}", arguments.input.string(), note_about(outside, !arguments.refine, then)));
  if (arguments.drop_unused) remove_unused_vertices(mesh);
}

Result<ExitCode> verdict(const MeshArguments& arguments, const MeshRun& run, const Source& source) {
  const bool goal_met = run.report.goal_met();
  if (run.certificate && !run.certificate->valid)
    warn(run.name + check_message(*run.certificate, goal_met, pslg_of(source).first_id, arguments.outputs,
                                  arguments.format.of_stream));
  // A mesh that is refined has no gaps in its report.
  if (const auto* domain = std::get_if<ValidPslg>(&source); domain != nullptr && !run.report.gaps.empty())
    warn(gaps_text(run.report.gaps, run.name, *domain));
  if (!goal_met) warn(run.name + ": " + missed_bounds(run.exempt, "--max-vertices", "--json"));
  return code_of(run.certificate, goal_met);
}

Status write_outputs(const MeshArguments& arguments, const Mesh& mesh, const Pslg& pslg, ProgressBar& bar) {
  const std::optional<MeshFormat> of_stream = arguments.format.of_stream;
  for (const auto& output : arguments.outputs) {
    bar.begin("writing " + output.string());
    if (Status written = write_mesh(mesh, pslg, output, arguments.format.for_file(output)); !written) return written;
    note_losses(losses(mesh, format_of_output(output, of_stream), PointMarkers::mesher), output, of_stream);
  }
  return Done{};
}

/// Fills the report, except for the certificate and the times of other steps.
void describe(const MeshArguments& arguments, const Pslg& pslg, const Goal& goal, Meshed& meshed, MeshRun& run) {
  Stopwatch watch;
  run.name = arguments.input.string();
  count_input(pslg, run);
  run.refined = arguments.refine;
  describe_goal(goal, pslg.regions, arguments.goal.convex_hull, run);
  run.names = meshed.mesh.names;
  run.sizes = arguments.goal.sizes;
  run.sources = arguments.goal.sources;
  run.options = arguments.options;
  run.outputs = arguments.outputs;
  run.report = std::move(meshed.report);
  run.exempt = exempt_triangles(run.report, meshed.mesh);
  run.seconds.triangulate = run.report.triangulate_seconds;
  run.seconds.refine = run.report.refine_seconds;
  run.statistics = statistics(meshed.mesh);
  run.digest = digest(meshed.mesh);
  run.seconds.statistics = watch.lap();
}

Status print(const MeshArguments& arguments, const MeshRun& run) {
  if (!arguments.quiet && !has_standard_output(all_outputs(arguments))) fmt::print("{}", to_text(run));
  return arguments.json.empty() ? Status(Done{}) : write_text(to_json(run), arguments.json);
}

Result<ExitCode> run(MeshArguments& arguments) {
  const Stopwatch total;
  if (Status complete = complete_options(arguments); !complete) return complete.error();
  if (Status fine = check_outputs(arguments); !fine) return fine.error();
  std::unique_ptr<SubdomainMesher> mesher;
  if (!arguments.mesher.name.empty()) {
    Result<std::unique_ptr<SubdomainMesher>> found = find_mesher(arguments.mesher.name);
    if (!found) return found.error();
    mesher = std::move(*found);
  }
  const MemoryWatch memory_watch(arguments.options.max_memory);
  ProgressBar bar(arguments.progress);

  MeshRun run;
  const auto refuse = [&](const Refusal& why) { return refused(why, arguments.input, arguments.json); };
  const Result<MeshInput, Refusal> input = read(arguments, bar, run.seconds);
  if (!input) return refuse(input.error());
  const Pslg& pslg = pslg_of(input->source);
  Stopwatch watch;
  const Result<Goal, Refusal> goal = make_goal(arguments, *input);
  if (!goal) return refuse(goal.error());
  run.seconds.read += watch.lap();

  Options how = arguments.options;
  if (arguments.paranoid) watch_sweeps(arguments, pslg, *goal, run.sweeps_checked.emplace(0), how);
  warn_of_many_triangles({arguments.input.string(), "pardel", "--max-vertices limits their number"}, run.large, how);
  Result<Meshed> meshed = make_mesh(arguments, *input, mesher.get(), *goal, with_progress(how, bar), run);
  if (!meshed) return refuse(why_not_meshed(arguments, *input, meshed.error()));
  note_and_drop_points_outside(arguments, meshed->mesh, run);
  watch.lap();
  if (arguments.check) run.certificate = check_mesh(arguments, *input, *meshed, *goal, bar);
  run.seconds.check = watch.lap();
  if (Status written = write_outputs(arguments, meshed->mesh, pslg, bar); !written) return written.error();
  run.seconds.write = watch.lap();

  bar.begin("computing statistics");
  describe(arguments, pslg, *goal, *meshed, run);
  run.warnings = input->warnings;
  bar.finish();
  run.seconds.total = total.seconds();
  if (Status printed = print(arguments, run); !printed) return printed.error();
  return verdict(arguments, run, input->source);
}

}  // namespace

Run mesh_command(CLI::App& app) {
  const auto arguments = std::make_shared<MeshArguments>();
  add_mesh_options(app, *arguments);
  return [arguments] { return run(*arguments); };
}

}  // namespace pardel::cli
