#include "measured_ranks.hpp"

#include <mpi.h>

#include "../core/support/stopwatch.hpp"
#include "../distributed/distributed.hpp"
#include "model/recording_ranks.hpp"
#include "warm_memory.hpp"

namespace pardel::bench {

std::vector<MeasuredRank> measure_ranks(const ValidPslg& domain, const Goal& goal, mpi::MpiRanks& ranks) {
  constexpr std::size_t usual_memory = std::size_t{1} << 30U;
  (void)workloads::touch_memory(usual_memory / static_cast<std::size_t>(ranks.count()));
  MPI_Barrier(MPI_COMM_WORLD);
  const Stopwatch watch;
  RecordingRanks recording(ranks);
  if (!mesh(domain, goal, {.threads = 1}, recording)) MPI_Abort(MPI_COMM_WORLD, 1);
  MeasuredRank mine{.processor_seconds = recording.seconds_after(), .seconds = watch.seconds()};
  for (const RecordedCall& call : recording.calls()) {
    ++(call.is_sum ? mine.sums : mine.exchanges);
    mine.bytes_out += call.bytes_out();
    mine.processor_seconds += call.seconds;
  }
  std::vector<MeasuredRank> all(ranks.rank() == 0 ? static_cast<std::size_t>(ranks.count()) : 0);
  MPI_Gather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, 0, MPI_COMM_WORLD);
  return all;
}

}  // namespace pardel::bench
