// paper_ranks: the MPI column of paper_tables, which starts it by mpirun. All ranks make one mesh, with one thread
// each, and begin with parts of the domain. With a sequential mesher, they begin with the whole domain. The first one
// prints "ranks SECONDS TRIANGLES"; the time is that of the slowest rank, from the domain to the pieces.
#include <fmt/format.h>
#include <mpi.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "../core/support/stopwatch.hpp"
#include "../distributed/mesh_with_mesher_in_ranks.hpp"
#include "../mpi/mpi_ranks.hpp"
#include "../properties/domains/dealt_domain.hpp"
#include "../properties/domains/domains.hpp"
#include "meshers/meshers.hpp"
#include "mpi_program.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

Result<MeshPiece> piece_with_mesher(const Pslg& pslg, const Goal& goal, const std::string& mesher,
                                    const std::string& scheme, Ranks& ranks) {
  const std::unique_ptr<SubdomainMesher> found = mesher_for(mesher, 1, goal);
  const std::optional<Scheme> how = scheme_named(scheme);
  if (found == nullptr || !how) return Error{ErrorKind::usage, "no such mesher or scheme"};
  Result<PieceWithMesher> made =
      mesh_with_mesher(*validate(pslg), goal, *found, {.scheme = *how}, {.threads = 1}, ranks);
  if (!made) return made.error();
  return std::move(made->piece);
}

int run(int argc, char** argv) {
  if (argc != 4 && argc != 6) {
    fmt::print(stderr, "usage: mpirun -n R paper_ranks DOMAIN MAX_AREA BYTES_TO_WARM [MESHER SCHEME]\n");
    return 2;
  }
  const std::string domain = argv[1];
  const double max_area = std::strtod(argv[2], nullptr);
  const std::size_t bytes_to_warm = std::strtoull(argv[3], nullptr, 10);
  mpi::MpiRanks ranks;
  (void)workloads::touch_memory(bytes_to_warm / static_cast<std::size_t>(ranks.count()));
  const Pslg pslg = *domains::generate(domain, 0, 1);
  MPI_Barrier(MPI_COMM_WORLD);
  const Stopwatch watch;
  const Goal goal{.max_area = max_area};
  const Result<MeshPiece> piece = argc == 4 ? mesh(domains::equal_part(pslg, ranks), goal, {.threads = 1}, ranks)
                                            : piece_with_mesher(pslg, goal, argv[4], argv[5], ranks);
  if (!piece) MPI_Abort(MPI_COMM_WORLD, 1);
  double seconds = watch.seconds();
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  if (ranks.rank() == 0) fmt::print("ranks {} {}\n", seconds, piece->triangles);
  return 0;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) { return pardel::bench::run_in_job(argc, argv, pardel::bench::run); }
