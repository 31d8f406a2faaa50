#include "mesh_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "../cli/choice.hpp"
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
#include "../cli/names.hpp"
#include "../cli/output.hpp"
#include "../cli/points_outside.hpp"
#include "../cli/refusal.hpp"
#include "../cli/report.hpp"
#include "../cli/threads_option.hpp"
#include "../cli/verdict.hpp"
#include "../core/formats.hpp"
#include "../core/support/agree.hpp"
#include "../core/support/collective.hpp"
#include "../core/support/enum_names.hpp"
#include "../core/support/exchange_lists.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/stopwatch.hpp"
#include "../distributed/distributed.hpp"
#include "../parallel/mesher.hpp"
#include "../properties/checker/check_pieces.hpp"
#include "made.hpp"
#include "outputs.hpp"
#include "parts_of_report.hpp"
#include "points.hpp"
#include "problem.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* mesh_footer =
    R"(The mesh is that of 'pardel mesh' with the same options and the same --interior, on any number of ranks and
threads. With --interior fill, --pieces lets a rank make several pieces one after another, so that the mesh can be larger
than the memory of all ranks. The report of --json has the keys of that of 'pardel mesh', and 'ranks'.

Output:
  OUT.pvtu           a list of the pieces OUT_0000.vtu, OUT_0001.vtu, ..., one per rank, for ParaView
  OUT.msh            pieces for Gmsh: OUT_1.msh, OUT_2.msh, ..., one per rank, with ghost triangles
  OUT.node, OUT.ele  the files OUT.node, OUT.ele and OUT.poly of the whole mesh, as Triangle writes them; all ranks
                     write them together, and they do not depend on the number of ranks
Files appear under their names only when all ranks have finished. 'pardel check', 'draw' and 'convert' read OUT.pvtu
and OUT.node, and OUT.msh, which stands for all its pieces.

Examples:
  mpirun -n 4 pardel-mpi mesh pipe.poly -o pipe.pvtu --max-area 1e-6
  mpirun -n 2 pardel-mpi mesh pipe.poly -o large.pvtu --max-area 1e-8 --interior fill --pieces 32)";

constexpr const char* program = "pardel-mpi";
constexpr int most_pieces = 10'000;              // their numbers have four digits
constexpr std::uintmax_t small_input = 8 << 20;  // bytes; about 200,000 points

/// How the ranks read the input.
enum class Reading : std::uint8_t { automatic, whole, parts };
constexpr auto reading_names = enum_names<Reading>({
    {Reading::automatic, "auto"},
    {Reading::whole, "whole"},
    {Reading::parts, "parts"},
});

struct Arguments {
  std::filesystem::path input;
  Reading reading = Reading::automatic;
  std::vector<std::filesystem::path> outputs;
  GoalOptions goal;
  Options options{.placement = Placement::automatic};  // the interior is refined
  std::vector<Index> cells;
  int threads = 0, pieces = 0;  ///< pieces: 0 for one per rank
  std::optional<double> max_memory_gib;
  bool repair = false;
  std::optional<double> snap;
  bool check = false;
  std::filesystem::path json;
  bool msh_ascii = false, quiet = false;

  [[nodiscard]] HowToRead how_to_read() const {
    return {options.threads, repair, snap, repair ? CrossingPolygons::repaired : CrossingPolygons::refused,
            options.kept_markers};
  }
};

/// A run of the command, and what its report says.
struct Run {
  const Arguments& arguments;
  Job& job;
  MeshRun report{};
  FirstId first_id{};  ///< of a domain whose mesh is checked
  PartsOfReport parts{!arguments.json.empty()};
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("IN", arguments.input, "The domain: .poly, .node or .geojson")->required()->type_name("");
  app.add_option("-o,--output", arguments.outputs,
                 "The mesh to write (required); the suffix sets the format: .pvtu, .msh, .node;\n"
                 "may be repeated")
      ->required()
      ->allow_extra_args(false)
      ->type_name("OUT");
  add_goal_options(app, arguments.goal, largest_min_angle_deg);
  add_ways_to_work(app, arguments.options, arguments.cells);
  app.add_option("--interior", arguments.options.interior,
                 "What fills the interior where areas and edges have constant bounds: refine (default); fill and\n"
                 "auto (the default of 'pardel mesh'): see 'pardel mesh --help'")
      ->transform(choice(interior_names))
      ->type_name("WHAT");
  app.add_option("--read", arguments.reading,
                 "What each rank reads: a part of the input, or the whole; auto (default): a part of an input above\n"
                 "8 MiB, if no rank needs all of it. The mesh does not depend on it")
      ->transform(choice(reading_names))
      ->type_name("WHAT");
  app.add_option("--pieces", arguments.pieces,
                 "Number of pieces, at least one per rank (default: one per rank). A rank makes and writes its pieces\n"
                 "one after another. Only with --interior fill and for one OUT.pvtu")
      ->check(CLI::Range(1, most_pieces).description(""))
      ->type_name("N");
  add_min_edge_option(app, arguments.options);
  add_keep_option(app, arguments.options);
  add_memory_option(app, arguments.max_memory_gib)
      ->description("Stop if a rank needs more memory than this, in GiB (default: its share of the memory available)");
  add_threads_option(app, arguments.threads, "the mesh")
      ->description(
          "Number of threads of each rank; 0 or all (default): its share of the processors of its machine;\n"
          "the mesh does not depend on it")
      ->group("Limits");
  add_repair_options(app, arguments.repair, arguments.snap)
      ->description(
          "Repair the domain before meshing: merge points, split segments, close tiny gaps; each rank reads\n"
          "the whole input then");
  add_check_option(app, arguments.check);
  app.add_flag("--msh-ascii", arguments.msh_ascii, "Write .msh as text (default: binary)");
  add_report_option(app, arguments.json);
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing on standard output except the report of --json -");
  app.footer(mesh_footer);
}

/// Collective.
Status write(const Arguments& arguments, const MeshPiece& piece, const Pslg& pslg, Job& job) {
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

/// One piece per rank.
Result<Made, Refusal> make_together(const Problem& input, Run& run) {
  Result<MeshPiece> piece = mesh(input.domain, input.goal, warning_options(run), run.job.ranks());
  if (!piece) run.job.abort(piece.error());
  return finished(*piece, input.domain.pslg(), run.arguments.check ? &input : nullptr, run);
}

/// True if no rank needs the whole domain.
bool may_divide(const Arguments& arguments) {
  const std::filesystem::path suffix = arguments.input.extension();
  return (suffix == ".node" || suffix == ".poly") && arguments.pieces == 0 && !arguments.repair &&
         arguments.goal.sizes.empty() && can_divide_points(goal_without_sizes(arguments.goal), arguments.options);
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
bool is_divided(const Arguments& arguments, Job& job) {
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
  const Arguments& arguments = run.arguments;
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
  const Arguments& arguments = run.arguments;
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

Status check_number_of_pieces(const Arguments& arguments, int ranks) {
  if (arguments.pieces == 0) return Done{};
  if (arguments.check)
    return Error{ErrorKind::usage,
                 "--check needs all pieces of a rank in memory, and --pieces makes them one after another; use "
                 "'pardel-mpi check' afterwards"};
  if (arguments.outputs.size() != 1 || arguments.outputs.front().extension() != ".pvtu")
    return Error{ErrorKind::usage, "--pieces needs one output, OUT.pvtu"};
  if (arguments.pieces < ranks)
    return Error{ErrorKind::usage, fmt::format("--pieces {}: there are {} ranks, and each makes at least one piece",
                                               arguments.pieces, ranks)};
  const GoalOptions& goal = arguments.goal;
  const bool is_graded = !goal.sizes.empty() || goal.grading || goal.feature_size;
  const bool has_bound = goal.max_area || goal.max_edge || goal.regions;
  if (arguments.pieces > ranks && (arguments.options.interior == Interior::refine || is_graded || !has_bound))
    return Error{ErrorKind::usage, fmt::format("--pieces {}: more pieces than ranks need --interior fill, and the same "
                                               "bound on areas or edges everywhere",
                                               arguments.pieces)};
  return Done{};
}

Status check_arguments(Arguments& arguments, const Ranks& ranks) {
  if (Status fine = check_inputs(std::array{arguments.input, arguments.goal.sizes, arguments.goal.sources}, ranks);
      !fine)
    return fine;
  if (arguments.reading == Reading::parts && arguments.repair)
    return Error{
        ErrorKind::usage,
        "--repair needs the whole input on each rank, and --read parts divides it; use --read whole, or 'pardel "
        "doctor --repair' first"};
  if (arguments.reading == Reading::parts && !may_divide(arguments))
    return Error{ErrorKind::usage,
                 "--read parts needs a .poly or .node, an interior that is refined on a lattice, and bounds that do "
                 "not vary from place to place, except --regions"};
  if (Status fine = check_number_of_pieces(arguments, ranks.count()); !fine) return fine;
  if (Status fine = check_interior(arguments.options.interior, arguments.goal); !fine) return fine;
  const ExpectedOutputs expected{arguments.outputs, std::max(arguments.pieces, ranks.count()), arguments.json};
  if (Status fine = check_outputs(expected, arguments.input, arguments.goal, ranks); !fine) return fine;
  return set_cells(arguments.cells, arguments.options);
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

Result<ExitCode> run_mesh(Arguments& arguments, Job& job) {
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
  Run run{arguments, job};
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
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = program.add_subcommand(
      "mesh",
      "Make a guaranteed-quality mesh of a domain, in pieces; by default that of 'pardel mesh --interior refine'");
  add_options(*app, *arguments);
  return {app, [arguments, &job] { return run_mesh(*arguments, job); }};
}

}  // namespace pardel::mpi
