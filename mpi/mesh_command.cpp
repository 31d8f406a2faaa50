#include "mesh_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../cli/goal_options.hpp"
#include "../cli/input.hpp"
#include "../cli/memory.hpp"
#include "../cli/memory_watch.hpp"
#include "../cli/mesh_options.hpp"
#include "../cli/output.hpp"
#include "../cli/refusal.hpp"
#include "../cli/threads_option.hpp"
#include "../core/formats.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/distributed.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* mesh_footer =
    R"(The mesh is that of 'pardel mesh --interior refine' with the same options, on any number of ranks and threads.
Every rank writes a file OUT_RANK.vtu beside OUT.pvtu, which ParaView opens. Files appear under their names only
when all pieces are complete. 'pardel convert OUT.pvtu FILE' makes one file of the pieces; 'pardel check' and
'pardel draw' read OUT.pvtu, too.

Example:
  mpirun -n 4 pardel-mpi mesh pipe.poly -o pipe.pvtu --max-area 1e-6)";

struct Arguments {
  std::filesystem::path input, output;
  GoalOptions goal;
  Options options{.placement = Placement::automatic};  // the interior is refined
  std::vector<Index> cells;
  int threads = 0;
  bool quiet = false;
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("IN", arguments.input, "The domain: .poly or .node")->required()->type_name("");
  app.add_option("-o,--output", arguments.output, "The file to write (required)")->required()->type_name("OUT.pvtu");
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
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing on standard output");
  app.footer(mesh_footer);
}

/// The file of a piece, in the folder of the .pvtu.
std::filesystem::path file_of_piece(const std::filesystem::path& pvtu, int rank) {
  std::filesystem::path file = pvtu;
  file.replace_filename(fmt::format("{}_{:04}.vtu", pvtu.stem().string(), rank));
  return file;
}

struct Input {
  ValidPslg domain;
  Goal goal;
};

/// Reads and validates the domain, as every rank does for itself.
Result<Input> read(const Arguments& arguments) {
  Result<Domain> domain = read_domain(arguments.input);
  if (!domain) return domain.error();
  const Result<SizeField> sizes = read_size_field(arguments.goal.sizes);
  if (!sizes) return sizes.error();
  Result<ValidPslg, Refusal> valid =
      validated(std::move(*domain), {.convex_hull = arguments.goal.convex_hull, .threads = arguments.options.threads});
  if (!valid) return valid.error().error;
  Result<Goal> goal = make_goal(arguments.goal, *sizes, *valid);
  if (!goal) return goal.error();
  return Input{std::move(*valid), std::move(*goal)};
}

/// Collective. An earlier .pvtu must not name pieces of two meshes, also if a rank is killed while they get their
/// names.
Status remove_index(const std::filesystem::path& pvtu, Job& job) {
  std::error_code failure;
  const auto status = std::filesystem::symlink_status(pvtu, failure);
  if (job.is_first() && std::filesystem::is_regular_file(status)) std::filesystem::remove(pvtu, failure);
  if (!job.is_first() || !std::filesystem::exists(status)) failure.clear();
  return job.agree(failure ? Status(Error{ErrorKind::io, fmt::format("{}: {}", pvtu.string(), failure.message())})
                           : Status(Done{}));
}

Status write(const Arguments& arguments, const MeshPiece& piece, Job& job) {
  // A rank without triangles has no regions either.
  const bool have_regions = job.range_of(piece.mesh.region.empty() ? 0 : 1).most > 0;
  const auto agree = [&](const Status& here) {
    const Status all = job.agree(here);
    return all ? remove_index(arguments.output, job) : all;
  };
  const Status written =
      write_vtu_piece(piece.mesh, piece.number.span(), file_of_piece(arguments.output, job.ranks().rank()), agree);
  if (Status all = job.agree(written); !all) return all;
  Status index = Done{};
  if (job.is_first()) {
    PiecesOfMesh pieces{{}, have_regions, piece.mesh.attributes_per_point};
    for (int rank = 0; rank < job.ranks().count(); ++rank)
      pieces.files.push_back(file_of_piece(arguments.output, rank).filename().string());
    index = write_pvtu(pieces, arguments.output);
  }
  return job.agree(index);
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
  fmt::print("output  {}\n", arguments.output.string());
}

Status check_arguments(Arguments& arguments, int rank) {
  if (arguments.output.extension() != ".pvtu")
    return Error{ErrorKind::usage, fmt::format("the output {} must end in .pvtu", arguments.output.string())};
  if (arguments.output.filename().string().find_first_of("<>&\"") != std::string::npos)
    return Error{ErrorKind::usage,
                 fmt::format("the name of the output {} must not contain <, >, & or \"", arguments.output.string())};
  if (Status fine = check_folder(arguments.output); !fine) return fine;
  if (Status fine = check_folder(file_of_piece(arguments.output, rank)); !fine) return fine;
  return set_cells(arguments.cells, arguments.options);
}

Result<ExitCode> run(Arguments& arguments, Job& job) {
  Stopwatch watch;
  Seconds seconds;
  const MemoryWatch memory_watch(available_memory() / static_cast<std::uint64_t>(job.ranks_here()));
  if (Status fine = job.agree(check_arguments(arguments, job.ranks().rank())); !fine) return fine.error();
  arguments.options.threads = arguments.threads > 0 ? arguments.threads : job.threads_per_rank();
  use_threads(arguments.options.threads);
  const Result<Input> input = read(arguments);
  if (Status all = job.agree(input ? Status(Done{}) : input.error()); !all) return all.error();
  seconds.read = watch.lap();
  const Result<MeshPiece> piece = mesh(input->domain, input->goal, arguments.options, job.ranks());
  if (!piece) job.abort(piece.error());
  seconds.mesh = watch.lap();
  if (Status written = write(arguments, *piece, job); !written) return written.error();
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
