#include "mesh_options.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "../cli/choice.hpp"
#include "../cli/mesh_options.hpp"
#include "../cli/names.hpp"
#include "../cli/report.hpp"
#include "../cli/threads_option.hpp"
#include "../core/support/enum_names.hpp"
#include "../distributed/distributed.hpp"
#include "outputs.hpp"

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

constexpr int most_pieces = 10'000;  // their numbers have four digits

constexpr auto reading_names = enum_names<Reading>({
    {Reading::automatic, "auto"},
    {Reading::whole, "whole"},
    {Reading::parts, "parts"},
});

Status check_number_of_pieces(const MeshArguments& arguments, int ranks) {
  if (arguments.pieces == 0) return Done{};
  if (!arguments.mesher.name.empty()) return Error{ErrorKind::usage, "--mesher cannot be used with --pieces"};
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

}  // namespace

void add_mesh_options(CLI::App& app, MeshArguments& arguments) {
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
  add_mesher_options(app, arguments.mesher);
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

bool may_divide(const MeshArguments& arguments) {
  const std::filesystem::path suffix = arguments.input.extension();
  return (suffix == ".node" || suffix == ".poly") && arguments.pieces == 0 && !arguments.repair &&
         arguments.goal.sizes.empty() && arguments.mesher.name.empty() &&
         can_divide_points(goal_without_sizes(arguments.goal), arguments.options);
}

Status check_arguments(MeshArguments& arguments, const Ranks& ranks) {
  if (Status fine = check_inputs(std::array{arguments.input, arguments.goal.sizes, arguments.goal.sources}, ranks);
      !fine)
    return fine;
  if (arguments.reading == Reading::parts && arguments.repair)
    return Error{
        ErrorKind::usage,
        "--repair needs the whole input on each rank, and --read parts divides it; use --read whole, or 'pardel "
        "doctor --repair' first"};
  if (arguments.reading == Reading::parts && !may_divide(arguments))
    return Error{
        ErrorKind::usage,
        "--read parts needs a .poly or .node, an interior that is refined on a lattice, bounds that do not vary "
        "from place to place, except --regions, and no --mesher"};
  if (Status fine = check_use(arguments.mesher, arguments.options, !arguments.cells.empty()); !fine) return fine;
  if (Status fine = check_number_of_pieces(arguments, ranks.count()); !fine) return fine;
  if (Status fine = check_interior(arguments.options.interior, arguments.goal); !fine) return fine;
  const ExpectedOutputs expected{arguments.outputs, std::max(arguments.pieces, ranks.count()), arguments.json};
  if (Status fine = check_outputs(expected, arguments.input, arguments.goal, ranks); !fine) return fine;
  return set_cells(arguments.cells, arguments.options);
}

}  // namespace pardel::mpi
