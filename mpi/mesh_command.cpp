#include "mesh_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "../cli/goal_options.hpp"
#include "../cli/memory.hpp"
#include "../cli/memory_watch.hpp"
#include "../cli/mesh_options.hpp"
#include "../cli/threads_option.hpp"
#include "../core/formats.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/distributed.hpp"
#include "../parallel/mesher.hpp"
#include "outputs.hpp"
#include "problem.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* mesh_footer =
    R"(The mesh is that of 'pardel mesh --interior refine' with the same options, on any number of ranks and threads.

Output:
  OUT.pvtu           a list of the pieces OUT_0000.vtu, OUT_0001.vtu, ..., one per rank, for ParaView
  OUT.msh            pieces for Gmsh: OUT_1.msh, OUT_2.msh, ..., one per rank, with ghost triangles
  OUT.node, OUT.ele  the files OUT.node, OUT.ele and OUT.poly of the whole mesh, as Triangle writes them; all ranks
                     write them together, and they do not depend on the number of ranks
Files appear under their names only when all ranks have finished. 'pardel check', 'draw' and 'convert' read OUT.pvtu
and OUT.node, and OUT.msh, which stands for all its pieces.

Example:
  mpirun -n 4 pardel-mpi mesh pipe.poly -o pipe.pvtu --max-area 1e-6)";

struct Arguments {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
  GoalOptions goal;
  Options options{.placement = Placement::automatic};  // the interior is refined
  std::vector<Index> cells;
  int threads = 0;
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
  app.add_option("--min-edge", arguments.options.min_edge,
                 "Insert no point that would make a shorter edge (default: the limit of double precision)")
      ->check(positive_number("a length"))
      ->type_name("LENGTH");
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

struct Seconds {
  double read = 0, mesh = 0, write = 0;
};

void print(const Arguments& arguments, const MeshPiece& piece, const Seconds& seconds, Job& job) {
  const Digest all = digest(piece, job.ranks());
  const Job::Range triangles = job.range_of(piece.mesh.triangles.size());
  const Job::Range memory = job.range_of(peak_memory());
  if (!job.is_first() || arguments.quiet) return;
  constexpr double mib = 0x1p20;
  fmt::print("ranks   {}, with {} threads each\n", job.ranks().count(), arguments.options.threads);
  fmt::print("mesh    {} vertices, {} triangles, {} constrained edges\n", piece.points, piece.triangles,
             piece.constrained_edges);
  fmt::print("pieces  {} to {} triangles, {:.0f} to {:.0f} MiB of memory\n", triangles.least, triangles.most,
             static_cast<double>(memory.least) / mib, static_cast<double>(memory.most) / mib);
  fmt::print("digest  {}\n", to_string(all));
  fmt::print("time    {:.3f} s (read {:.3f}, refine {:.3f}, pieces {:.3f}, write {:.3f})\n",
             seconds.read + seconds.mesh + seconds.write, seconds.read, piece.report.refine_seconds, piece.seconds,
             seconds.write);
  fmt::print("output  {}\n", names_of(arguments.outputs));
}

Status check_arguments(Arguments& arguments, int rank) {
  if (Status fine = check_outputs(arguments.outputs, arguments.input, arguments.goal.sizes, rank); !fine) return fine;
  return set_cells(arguments.cells, arguments.options);
}

Result<ExitCode> run(Arguments& arguments, Job& job) {
  Stopwatch watch;
  Seconds seconds;
  const MemoryWatch memory_watch(available_memory() / static_cast<std::uint64_t>(job.ranks_here()));
  if (Status fine = job.agree(check_arguments(arguments, job.ranks().rank())); !fine) return fine.error();
  arguments.options.threads = arguments.threads > 0 ? arguments.threads : job.threads_per_rank();
  use_threads(arguments.options.threads);
  const Result<Problem> input = read_problem(arguments.input, arguments.goal, arguments.options.threads);
  if (Status all = job.agree(input ? Status(Done{}) : input.error()); !all) return all.error();
  seconds.read = watch.lap();
  const Result<MeshPiece> piece = mesh(input->domain, input->goal, arguments.options, job.ranks());
  if (!piece) job.abort(piece.error());
  seconds.mesh = watch.lap();
  if (Status written = write(arguments, *piece, input->domain.pslg(), job); !written) return written.error();
  seconds.write = watch.lap();
  print(arguments, *piece, seconds, job);
  if (piece->missed == 0) return ExitCode::done;
  if (job.is_first())
    warn(fmt::format("{}: {} triangles miss a bound because of a limit or of rounding; 'pardel check' lists them",
                     arguments.input.string(), piece->missed));
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
