#include "mesh_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "../cli/exempt_triangles.hpp"
#include "../cli/findings_text.hpp"
#include "../cli/gaps_text.hpp"
#include "../cli/goal_options.hpp"
#include "../cli/input.hpp"
#include "../cli/kept_segments.hpp"
#include "../cli/many_triangles.hpp"
#include "../cli/memory.hpp"
#include "../cli/memory_watch.hpp"
#include "../cli/mesh_options.hpp"
#include "../cli/output.hpp"
#include "../cli/points_outside.hpp"
#include "../cli/refusal.hpp"
#include "../cli/report.hpp"
#include "../cli/threads_option.hpp"
#include "../cli/verdict.hpp"
#include "../core/formats.hpp"
#include "../core/support/agree.hpp"
#include "../core/support/collective.hpp"
#include "../core/support/exchange_lists.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/stopwatch.hpp"
#include "../distributed/distributed.hpp"
#include "../distributed/mesh_with_mesher_in_ranks.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check_pieces.hpp"
#include "made.hpp"
#include "mesh_options.hpp"
#include "outputs.hpp"
#include "parts_of_report.hpp"
#include "points.hpp"
#include "problem.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* program = "pardel-mpi";
constexpr std::uintmax_t small_input = 8 << 20;  // bytes; about 200,000 points

/// A run of the command, and what its report says.
struct Run {
  const MeshArguments& arguments;
  Job& job;
  MeshRun report{};
  FirstId first_id{};  ///< of a domain whose mesh is checked
  PartsOfReport parts{!arguments.json.empty()};
  SubdomainMesher* mesher = nullptr;  ///< that of --mesher
};

/// Collective.
Status write(const MeshArguments& arguments, const MeshPiece& piece, const Pslg& pslg, Job& job) {
  const MshEncoding msh = arguments.msh_ascii ? MshEncoding::ascii : MshEncoding::binary;
  for (const std::filesystem::path& output : arguments.outputs)
    if (Status written = write_pieces(piece, pslg, output, msh, job); !written) return written;
  return Done{};
}

/// Collective.
Status check_piece(MeshPiece& piece, const Problem& problem, Made& made, Run& run) {
  const Stopwatch watch;
  NumberedMesh held{std::move(piece.mesh), std::move(piece.number)};
  Result<Certificate> certificate = pardel::check(problem.domain.pslg(), held, problem.goal,
                                                  {.max_violations = most_kept(run.arguments.json)}, run.job.ranks());
  piece.mesh = std::move(held.mesh);
  piece.number = std::move(held.number);
  if (!certificate) return certificate.error();
  certificate->ranks = run.job.count();
  made.valid = certificate->valid;
  run.report.certificate = std::move(*certificate);
  run.first_id = problem.domain.pslg().first_id;
  made.seconds.check = watch.seconds();
  return Done{};
}

/// Collective. Adds the only piece of this rank, and writes it. `problem`: to check it with; null without --check.
Result<Made, Refusal> finished(MeshPiece& piece, const Pslg& pslg, const Problem* problem, Run& run) {
  Made made;
  made.add(piece);
  run.parts.add(piece);
  if (problem != nullptr)
    if (Status checked = check_piece(piece, *problem, made, run); !checked) return Refusal(checked.error());
  const Stopwatch watch;
  if (Status done = write(run.arguments, piece, pslg, run.job); !done) return Refusal(done.error());
  made.seconds.write = watch.seconds();
  return made;
}

/// The options of a run in which each rank has the whole domain. The first rank warns of very many triangles.
Options warning_options(Run& run) {
  Options options = run.arguments.options;
  const std::string advice = "--max-memory limits the memory of each rank";
  if (run.job.is_first())
    warn_of_many_triangles({run.arguments.input.string(), program, advice}, run.report.large, options);
  return options;
}

/// One piece per rank, by the mesher of --mesher. Describes in `run` what the mesher has done.
Result<MeshPiece> mesh_with(SubdomainMesher& mesher, const Problem& input, const Options& options, Run& run) {
  const MesherArguments& arguments = run.arguments.mesher;
  Result<PieceWithMesher> made =
      mesh_with_mesher(input.domain, input.goal, mesher, arguments.how, options, run.job.ranks());
  if (!made) return made.error();
  run.report.mesher = MesherOfRun{arguments.name, arguments.how.scheme, made->mesher};
  return std::move(made->piece);
}

/// One piece per rank.
Result<Made, Refusal> make_together(const Problem& input, Run& run) {
  const Options options = warning_options(run);
  Result<MeshPiece> piece = run.mesher != nullptr ? mesh_with(*run.mesher, input, options, run)
                                                  : mesh(input.domain, input.goal, options, run.job.ranks());
  if (!piece && piece.error().kind == ErrorKind::usage) return Refusal(piece.error());  // the same on all ranks
  if (!piece) run.job.abort(piece.error());
  return finished(*piece, input.domain.pslg(), run.arguments.check ? &input : nullptr, run);
}

/// True if each rank can as well make the initial mesh and the coarse levels for itself: one rank that makes them for
/// all lets the others wait. The points of a .poly can be in a .node.
bool is_small(const std::filesystem::path& input) {
  std::error_code error;
  std::uintmax_t bytes = std::filesystem::file_size(input, error);
  if (error) return false;
  if (input.extension() == ".poly") {
    const std::filesystem::path node = std::filesystem::path(input).replace_extension(".node");
    const std::uintmax_t more = std::filesystem::file_size(node, error);
    if (!error) bytes += more;
  }
  return bytes <= small_input;
}

/// Collective. True if each rank is to read a part of the input.
bool is_divided(const MeshArguments& arguments, Job& job) {
  if (job.count() == 1 || arguments.reading == Reading::whole || !may_divide(arguments)) return false;
  // All ranks do the same, even if a machine does not see yet that a file is complete.
  return arguments.reading == Reading::parts || sum_of(is_small(arguments.input) ? 0U : 1U, job.ranks()) > 0;
}

/// Collective. The error of a domain that was read in parts. An invalid one is read again, by one rank, to list all its
/// problems with the advice of 'pardel mesh'. Other errors end the job.
Refusal fault_of_domain(const Error& error, const Run& run) {
  if (error.kind != ErrorKind::invalid_input) run.job.abort(error);
  std::optional<Refusal> found;
  if (run.job.is_first())
    if (const auto whole = read_problem(run.arguments.input, run.arguments.goal, run.arguments.how_to_read()); !whole)
      found = whole.error();
  if (Status all = agree_on_input(found ? Status(found->error) : Done{}, run.job.ranks()); !all)
    return found ? *found : Refusal(all.error());
  return Error{error.kind, run.arguments.input.string() + ": " + error.message};
}

/// Collective. Sums of what the ranks have read.
void count_input(const PartOfPslg& input, Run& run) {
  run.report.points = sum_of(input.points.points.size(), run.job.ranks());
  run.report.segments = sum_of(input.segments.segments.size(), run.job.ranks());
  run.report.holes = input.rest.holes.size();
  run.report.regions = input.rest.regions.size();
}

/// Collective. As check_kept_segments(), before the domain is validated.
Status check_kept_segments(const PartOfPslg& input, bool has_only_points, const Run& run) {
  for (const int marker : run.arguments.options.kept_markers) {
    if (marker == 1 && (has_only_points || run.arguments.goal.convex_hull)) continue;
    if (sum_of(has_segment_with(input.segments.segments, marker) ? 1U : 0U, run.job.ranks()) == 0)
      return no_kept_segment(marker);
  }
  return Done{};
}

/// One piece per rank, of a domain of which each rank has a part.
Result<Made, Refusal> make_of_parts(PartOfPslg&& input, Run& run) {
  const MeshArguments& arguments = run.arguments;
  Job& job = run.job;
  const bool has_only_points = is_point_set(input, job.ranks());
  if (Status kept = check_kept_segments(input, has_only_points, run); !kept) return fault_of_domain(kept.error(), run);
  Pslg for_writers;  // they write holes and regions again
  for_writers.holes = input.rest.holes;
  for_writers.regions = input.rest.regions;
  for_writers.first_id = input.points.first_id;
  describe_goal(goal_without_sizes(arguments.goal), input.rest.regions, arguments.goal.convex_hull, run.report);
  Result<MeshPiece> piece = mesh(std::move(input), run.report.goal, arguments.options, job.ranks());
  if (!piece && has_only_points)
    return Refusal(fault_of_points(piece.error(), arguments.input, arguments.options.threads, job));
  if (!piece) return fault_of_domain(piece.error(), run);
  if (!arguments.check) return finished(*piece, for_writers, nullptr, run);
  const auto whole = read_problem(arguments.input, arguments.goal, arguments.how_to_read());
  if (const auto refusal = common_refusal(whole, job)) return *refusal;
  return finished(*piece, for_writers, &*whole, run);
}

/// Each piece is written before the rank makes the next one.
Result<Made, Refusal> make_in_turn(const Problem& input, Run& run) {
  const MeshArguments& arguments = run.arguments;
  PvtuFiles files(arguments.outputs.front());
  Made made;
  Status written = Done{};
  const Status ended = mesh_in_pieces(input.domain, input.goal, warning_options(run), run.job.ranks(), arguments.pieces,
                                      [&](MeshPiece&& piece, int number) {
                                        made.add(piece);
                                        run.parts.add(piece);
                                        const Stopwatch watch;
                                        written = files.add(piece, number);
                                        made.seconds.write += watch.seconds();
                                        return written;
                                      });
  if (!ended && written) run.job.abort(ended.error());
  if (Status placed = files.commit(written, arguments.pieces, run.job); !placed) return Refusal(placed.error());
  return made;
}

/// What one rank says about the whole domain.
void describe(const Problem& input, Run& run) {
  count_input(input.domain.pslg(), run.report);
  describe_goal(input.goal, input.domain.pslg().regions, run.arguments.goal.convex_hull, run.report);
  run.report.seconds.validate = input.validate_seconds;
  if (!run.job.is_first()) return;
  for (const std::string& line : input.log) warn(line, program);
  run.report.warnings = print_warnings(input.domain, run.arguments.input.string(), program);
}

/// On the first rank.
void warn_of_gaps(const ValidPslg& domain, const Run& run) {
  if (run.parts.gaps().empty() || !run.job.is_first()) return;
  warn(gaps_text(run.parts.gaps(), run.arguments.input.string(), domain), program);
}

/// Collective.
Result<Made, Refusal> make(Run& run) {
  const Stopwatch watch;
  if (is_divided(run.arguments, run.job)) {
    Result<PartOfPslg> input = read_part_of_pslg(run.arguments.input, run.job.ranks());
    if (!input) return Refusal(input.error());
    count_input(*input, run);
    const double read_seconds = watch.seconds();
    Result<Made, Refusal> made = make_of_parts(std::move(*input), run);
    if (!made) return made;
    made->seconds.read = read_seconds;
    made->divided = true;
    return made;
  }
  const auto input = read_problem(run.arguments.input, run.arguments.goal, run.arguments.how_to_read());
  if (const auto refusal = common_refusal(input, run.job)) return *refusal;
  describe(*input, run);
  const double read_seconds = watch.seconds();
  Result<Made, Refusal> made = run.arguments.pieces > 0 ? make_in_turn(*input, run) : make_together(*input, run);
  if (!made) return made;
  made->seconds.read = read_seconds;
  warn_of_gaps(input->domain, run);
  return made;
}

/// Collective. Fills in the report, and prints its lines.
void summarize(const Made& made, Run& run) {
  const Stopwatch joining;
  MeshRun& report = run.report;
  report.name = run.arguments.input.string();
  report.sizes = run.arguments.goal.sizes;
  report.sources = run.arguments.goal.sources;
  report.options = run.arguments.options;
  report.outputs = run.arguments.outputs;
  run.parts.join(made, report, run.job.ranks());
  const double validate = report.seconds.validate;  // 0 for an input in parts
  report.seconds = {.read = made.seconds.read - validate,
                    .validate = validate,
                    .triangulate = report.report.triangulate_seconds,
                    .refine = made.seconds.refine + made.seconds.pieces,
                    .check = made.seconds.check,
                    .write = made.seconds.write,
                    .statistics = joining.seconds(),
                    .total = made.seconds.all};
  std::string lines = text_of_mesh(report);
  lines += fmt::format("edges   {} constrained\n", made.constrained_edges);
  const bool is_quiet = run.arguments.quiet || is_standard_output(run.arguments.json);
  print(made, lines, "refine", run.arguments.options.threads, run.arguments.outputs, is_quiet, run.job);
}

/// Collective. The first rank writes it.
Status write_report(Run& run) {
  if (run.arguments.json.empty()) return Done{};
  return run.job.agree(run.job.is_first() ? write_text(to_json(run.report), run.arguments.json) : Done{});
}

/// The messages of the first rank, and the exit code of all. Only pardel-mpi checks pieces without joining them, which
/// may take more memory than there is.
ExitCode verdict(const Run& run) {
  const std::string name = run.arguments.input.string();
  const auto& certificate = run.report.certificate;
  const bool goal_met = run.report.exempt.missed() == 0;
  if (certificate && !certificate->valid && run.job.is_first())
    warn(name + check_message(*certificate, goal_met, run.first_id, run.arguments.outputs, {}, true), program);
  if (!goal_met && run.job.is_first())
    warn(name + ": " + missed_bounds(run.report.exempt, "one rank", "--json"), program);
  return code_of(certificate, goal_met);
}

Result<ExitCode> run_mesh(MeshArguments& arguments, Job& job) {
  Stopwatch watch;
  const std::uint64_t limit = memory_limit(arguments.max_memory_gib, available_memory(job.ranks_here()));
  const MemoryWatch memory_watch(limit);
  if (Status fine = job.agree(check_arguments(arguments, job.ranks())); !fine) return fine.error();
  if (Status common = check_common_folders(arguments.outputs, job); !common) return common.error();
  arguments.options.threads = arguments.threads > 0 ? arguments.threads : job.threads_per_rank();
  use_threads(arguments.options.threads);
  // The same on all ranks, because they decide alike. Where the interior is filled, a rank never has a whole mesh.
  if (arguments.options.interior == Interior::refine)
    arguments.options.max_memory = least_and_most_of(limit, job.ranks()).least;
  Result<std::unique_ptr<SubdomainMesher>> mesher = std::unique_ptr<SubdomainMesher>();
  if (!arguments.mesher.name.empty()) mesher = find_mesher(arguments.mesher.name);
  if (Status found = job.agree(mesher ? Done{} : Status(mesher.error())); !found) return found.error();
  Run run{arguments, job};
  run.mesher = mesher->get();
  Result<Made, Refusal> made = make(run);
  if (!made) return job.is_first() ? refused(made.error(), arguments.input, arguments.json) : made.error().error;
  made->seconds.all = watch.seconds();
  PointsOutside outside;
  for (const auto& of_rank : concatenated(lists_of_all(std::vector{made->outside}, job.ranks()))) outside.add(of_rank);
  run.report.points_outside = outside.count;
  summarize(*made, run);
  if (const std::string note = note_about(outside, true, "'pardel convert --drop-unused' writes the mesh without them");
      !note.empty() && job.is_first())
    warn(arguments.input.string() + ": " + note, program);
  if (Status reported = write_report(run); !reported) return reported.error();
  return verdict(run);
}

}  // namespace

Command add_mesh(CLI::App& program, Job& job) {
  const auto arguments = std::make_shared<MeshArguments>();
  CLI::App* app = program.add_subcommand(
      "mesh",
      "Make a guaranteed-quality mesh of a domain, in pieces; by default that of 'pardel mesh --interior refine'");
  add_mesh_options(*app, *arguments);
  return {app, [arguments, &job] { return run_mesh(*arguments, job); }};
}

}  // namespace pardel::mpi
