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
#include <vector>

#include "../cli/choice.hpp"
#include "../cli/goal_options.hpp"
#include "../cli/memory.hpp"
#include "../cli/memory_watch.hpp"
#include "../cli/mesh_options.hpp"
#include "../cli/names.hpp"
#include "../cli/threads_option.hpp"
#include "../core/formats.hpp"
#include "../core/support/agree.hpp"
#include "../core/support/collective.hpp"
#include "../core/support/enum_names.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/distributed.hpp"
#include "../parallel/mesher.hpp"
#include "made.hpp"
#include "outputs.hpp"
#include "points.hpp"
#include "problem.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* mesh_footer =
    R"(The mesh is that of 'pardel mesh' with the same options and the same --interior, on any number of ranks and
threads. By default the interior is refined. With --interior fill, --pieces lets a rank make several pieces one after
another, so that the mesh can be larger than the memory of all ranks.

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
  bool msh_ascii = false, quiet = false;
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("IN", arguments.input, "The domain: .poly or .node")->required()->type_name("");
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
                 "auto: see 'pardel mesh --help'")
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
  app.add_option("--min-edge", arguments.options.min_edge,
                 "Insert no point that would make a shorter edge (default: the limit of double precision)")
      ->check(positive_number("a length"))
      ->type_name("LENGTH");
  add_keep_option(app, arguments.options);
  add_threads_option(app, arguments.threads, "the mesh")
      ->description(
          "Number of threads of each rank; 0 or all (default): its share of the processors of its machine;\n"
          "the mesh does not depend on it");
  app.add_flag("--msh-ascii", arguments.msh_ascii, "Write .msh as text (default: binary)");
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing on standard output");
  app.footer(mesh_footer);
}

/// Collective.
Status write(const Arguments& arguments, const MeshPiece& piece, const Pslg& pslg, Job& job) {
  const MshEncoding msh = arguments.msh_ascii ? MshEncoding::ascii : MshEncoding::binary;
  for (const std::filesystem::path& output : arguments.outputs)
    if (Status written = write_pieces(piece, pslg, output, msh, job); !written) return written;
  return Done{};
}

/// Writes the only piece of this rank. Collective.
Result<Made> written(const Arguments& arguments, const MeshPiece& piece, const Pslg& pslg, Job& job) {
  Made made;
  made.add(piece);
  const Stopwatch watch;
  if (Status done = write(arguments, piece, pslg, job); !done) return done.error();
  made.seconds.write = watch.seconds();
  return made;
}

/// One piece per rank.
Result<Made> make_together(const Arguments& arguments, const Problem& input, Job& job) {
  const Result<MeshPiece> piece = mesh(input.domain, input.goal, arguments.options, job.ranks());
  if (!piece) job.abort(piece.error());
  return written(arguments, *piece, input.domain.pslg(), job);
}

/// True if no rank needs the whole domain.
bool may_divide(const Arguments& arguments) {
  const std::filesystem::path suffix = arguments.input.extension();
  return (suffix == ".node" || suffix == ".poly") && arguments.pieces == 0 && arguments.goal.sizes.empty() &&
         can_divide_points(goal_without_sizes(arguments.goal), arguments.options);
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
Error fault_of_domain(const Error& error, const Arguments& arguments, Job& job) {
  if (error.kind != ErrorKind::invalid_input) job.abort(error);
  Status valid = Done{};
  if (job.is_first())
    if (const Result<Problem> whole = read_problem(arguments.input, arguments.goal, arguments.options.threads); !whole)
      valid = whole.error();
  if (Status all = agree_on_input(valid, job.ranks()); !all) return all.error();
  return {error.kind, arguments.input.string() + ": " + error.message};
}

/// One piece per rank, of a domain of which each rank has a part.
Result<Made> make_of_parts(const Arguments& arguments, PartOfPslg&& input, Job& job) {
  const bool has_only_points = is_point_set(input, job.ranks());
  Pslg for_writers;  // they write holes and regions again
  for_writers.holes = input.rest.holes;
  for_writers.regions = input.rest.regions;
  for_writers.first_id = input.points.first_id;
  const Result<MeshPiece> piece =
      mesh(std::move(input), goal_without_sizes(arguments.goal), arguments.options, job.ranks());
  if (piece) return written(arguments, *piece, for_writers, job);
  if (has_only_points) return fault_of_points(piece.error(), arguments.input, arguments.options.threads, job);
  return fault_of_domain(piece.error(), arguments, job);
}

/// Each piece is written before the rank makes the next one.
Result<Made> make_in_turn(const Arguments& arguments, const Problem& input, Job& job) {
  PvtuFiles files(arguments.outputs.front());
  Made made;
  Status written = Done{};
  const Status ended = mesh_in_pieces(input.domain, input.goal, arguments.options, job.ranks(), arguments.pieces,
                                      [&](MeshPiece&& piece, int number) {
                                        made.add(piece);
                                        const Stopwatch watch;
                                        written = files.add(piece, number);
                                        made.seconds.write += watch.seconds();
                                        return written;
                                      });
  if (!ended && written) job.abort(ended.error());
  if (Status placed = files.commit(written, arguments.pieces, job); !placed) return placed.error();
  return made;
}

Status check_number_of_pieces(const Arguments& arguments, int ranks) {
  if (arguments.pieces == 0) return Done{};
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
  if (arguments.reading == Reading::parts && !may_divide(arguments))
    return Error{ErrorKind::usage,
                 "--read parts needs a .poly or .node, an interior that is refined on a lattice, and bounds that do "
                 "not vary from place to place, except --regions"};
  if (Status fine = check_number_of_pieces(arguments, ranks.count()); !fine) return fine;
  if (Status fine = check_interior(arguments.options.interior, arguments.goal); !fine) return fine;
  const ExpectedOutputs expected{arguments.outputs, std::max(arguments.pieces, ranks.count())};
  if (Status fine = check_outputs(expected, arguments.input, arguments.goal, ranks); !fine) return fine;
  return set_cells(arguments.cells, arguments.options);
}

Result<Made> make(const Arguments& arguments, Job& job) {
  const Stopwatch watch;
  if (is_divided(arguments, job)) {
    Result<PartOfPslg> input = read_part_of_pslg(arguments.input, job.ranks());
    if (!input) return input.error();
    const double read_seconds = watch.seconds();
    Result<Made> made = make_of_parts(arguments, std::move(*input), job);
    if (!made) return made;
    made->seconds.read = read_seconds;
    made->divided = true;
    return made;
  }
  const Result<Problem> input = read_problem(arguments.input, arguments.goal, arguments.options.threads);
  if (Status all = job.agree(input ? Status(Done{}) : input.error()); !all) return all.error();
  const double read_seconds = watch.seconds();
  Result<Made> made =
      arguments.pieces > 0 ? make_in_turn(arguments, *input, job) : make_together(arguments, *input, job);
  if (made) made->seconds.read = read_seconds;
  return made;
}

Result<ExitCode> run(Arguments& arguments, Job& job) {
  Stopwatch watch;
  const MemoryWatch memory_watch(available_memory(job.ranks_here()));
  if (Status fine = job.agree(check_arguments(arguments, job.ranks())); !fine) return fine.error();
  if (Status common = check_common_folders(arguments.outputs, job); !common) return common.error();
  arguments.options.threads = arguments.threads > 0 ? arguments.threads : job.threads_per_rank();
  use_threads(arguments.options.threads);
  Result<Made> made = make(arguments, job);
  if (!made) return made.error();
  made->seconds.all = watch.seconds();
  print(*made, "refine", arguments.options.threads, arguments.outputs, arguments.quiet, job);
  if (made->missed == 0) return ExitCode::done;
  // Only pardel-mpi checks pieces without joining them, which may take more memory than there is.
  const bool has_pieces = arguments.outputs.front().extension() == ".pvtu";
  const char* checker = has_pieces ? "pardel-mpi" : "pardel";
  if (job.is_first())
    warn(fmt::format("{}: {} triangles miss a bound because of a limit or of rounding; '{} check' lists them",
                     arguments.input.string(), made->missed, checker),
         "pardel-mpi");
  return ExitCode::goal_missed;
}

}  // namespace

Command add_mesh(CLI::App& program, Job& job) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = program.add_subcommand("mesh", "Make a guaranteed-quality mesh of a domain, in pieces");
  add_options(*app, *arguments);
  return {app, [arguments, &job] { return run(*arguments, job); }};
}

}  // namespace pardel::mpi
