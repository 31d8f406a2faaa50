#include "triangulate_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../cli/memory.hpp"
#include "../cli/memory_watch.hpp"
#include "../cli/threads_option.hpp"
#include "../core/formats.hpp"
#include "../core/support/agree.hpp"
#include "../core/support/stopwatch.hpp"
#include "../distributed/distributed.hpp"
#include "made.hpp"
#include "outputs.hpp"
#include "points.hpp"
#include "problem.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* triangulate_footer =
    R"(The triangulation is that of 'pardel triangle -c' for the same points, on any number of ranks and threads. (Equal
points are refused here, and merged there.) No rank has all points: each reads a part of IN, triangulates the points
that it owns, and asks the others about the triangles at its border. The edges of the convex hull are constrained edges.

Output: as for 'pardel-mpi mesh'.

Example:
  mpirun -n 4 pardel-mpi triangulate survey.node -o survey.pvtu)";

struct TriangulateArguments {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
  int threads = 0;
  bool msh_ascii = false, quiet = false;
};

void add_triangulate_options(CLI::App& app, TriangulateArguments& arguments) {
  app.add_option("IN", arguments.input,
                 "The points: .node, or .poly without segments, holes and regions; all ranks see the file")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments.outputs,
                 "The triangles to write (required); the suffix sets the format: .pvtu, .msh, .node;\n"
                 "may be repeated")
      ->required()
      ->allow_extra_args(false)
      ->type_name("OUT");
  add_threads_option(app, arguments.threads, "the triangulation")
      ->description(
          "Number of threads of each rank; 0 or all (default): its share of the processors of its machine;\n"
          "the triangulation does not depend on it");
  app.add_flag("--msh-ascii", arguments.msh_ascii, "Write .msh as text (default: binary)");
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing on standard output");
  app.footer(triangulate_footer);
}

/// The error for a .poly with other sections than points. What is wrong with it counts first.
Error not_only_points(const std::filesystem::path& input, Job& job) {
  const Result<Pslg> whole = job.is_first() ? read_pslg(input) : Pslg{};
  if (Status read = agree_on_input(whole ? Status(Done{}) : whole.error(), job.ranks()); !read) return read.error();
  return {ErrorKind::usage, input.string() + ": it has segments, holes or regions; 'pardel-mpi mesh' reads it"};
}

Status check_files(const TriangulateArguments& arguments, const Ranks& ranks) {
  if (Status fine = check_inputs({&arguments.input, 1}, ranks); !fine) return fine;
  return check_outputs({arguments.outputs, ranks.count()}, arguments.input, {}, ranks);
}

Result<ExitCode> run_triangulate(const TriangulateArguments& arguments, Job& job) {
  Stopwatch watch;
  const MemoryWatch memory_watch(available_memory(job.ranks_here()));
  if (Status fine = job.agree(check_files(arguments, job.ranks())); !fine) return fine.error();
  if (Status common = check_common_folders(arguments.outputs, job); !common) return common.error();
  const int threads = arguments.threads > 0 ? arguments.threads : job.threads_per_rank();
  use_threads(threads);
  Result<PartOfPslg> input = read_part_of_pslg(arguments.input, job.ranks());
  if (!input) return input.error();
  if (!is_point_set(*input, job.ranks())) return not_only_points(arguments.input, job);
  Made made;
  made.divided = job.count() > 1;
  made.seconds.read = watch.seconds();
  const Result<MeshPiece> piece = triangulate(std::move(input->points), {.threads = threads}, job.ranks());
  if (!piece) return fault_of_points(piece.error(), arguments.input, threads, job);
  made.add(*piece);
  made.seconds.refine = piece->report.triangulate_seconds;
  const Stopwatch writing;
  const MshEncoding msh = arguments.msh_ascii ? MshEncoding::ascii : MshEncoding::binary;
  for (const std::filesystem::path& output : arguments.outputs)
    if (Status written = write_pieces(*piece, {}, output, msh, job); !written) return written.error();
  made.seconds.write = writing.seconds();
  made.seconds.all = watch.seconds();
  const std::string lines = fmt::format("mesh    {} vertices, {} triangles, {} constrained edges\n", made.points,
                                        made.triangles, made.constrained_edges);
  print(made, lines, "triangulate", threads, arguments.outputs, arguments.quiet, job);
  return ExitCode::done;
}

}  // namespace

Command add_triangulate(CLI::App& program, Job& job) {
  const auto arguments = std::make_shared<TriangulateArguments>();
  CLI::App* app = program.add_subcommand("triangulate", "Make the Delaunay triangulation of points, in pieces");
  add_triangulate_options(*app, *arguments);
  return {app, [arguments, &job] { return run_triangulate(*arguments, job); }};
}

}  // namespace pardel::mpi
