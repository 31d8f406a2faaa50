// paper_ranks: the MPI column of paper_tables, which starts it by mpirun. All ranks make one mesh, with one thread
// each, and begin with parts of the domain. The first one prints "ranks SECONDS TRIANGLES"; the time is that of the
// slowest rank, from the domain to the pieces.
#include <fmt/format.h>
#include <mpi.h>

#include <cstdlib>
#include <string>

#include "../core/support/stopwatch.hpp"
#include "../distributed/distributed.hpp"
#include "../mpi/mpi_ranks.hpp"
#include "../properties/domains/dealt_domain.hpp"
#include "../properties/domains/domains.hpp"
#include "mpi_program.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {
namespace {

int run(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: mpirun -n R paper_ranks DOMAIN MAX_AREA BYTES_TO_WARM\n");
    return 2;
  }
  const std::string domain = argv[1];
  const double max_area = std::strtod(argv[2], nullptr);
  const std::size_t bytes_to_warm = std::strtoull(argv[3], nullptr, 10);
  mpi::MpiRanks ranks;
  (void)touch_memory(bytes_to_warm / static_cast<std::size_t>(ranks.count()));
  const Pslg pslg = *domains::generate(domain, 0, 1);
  MPI_Barrier(MPI_COMM_WORLD);
  const Stopwatch watch;
  const Result<MeshPiece> piece = mesh(domains::equal_part(pslg, ranks), {.max_area = max_area}, {.threads = 1}, ranks);
  if (!piece) MPI_Abort(MPI_COMM_WORLD, 1);
  double seconds = watch.seconds();
  MPI_Allreduce(MPI_IN_PLACE, &seconds, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  if (ranks.rank() == 0) fmt::print("ranks {} {}\n", seconds, piece->triangles);
  return 0;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) { return pardel::bench::run_in_job(argc, argv, pardel::bench::run); }
