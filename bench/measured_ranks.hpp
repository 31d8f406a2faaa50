// A run of the ranks of an MPI job, recorded, to compare it with the model.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "../core/goal.hpp"
#include "../mpi/mpi_ranks.hpp"
#include "../parallel/validate.hpp"

namespace pardel::bench {

/// Of one rank.
struct MeasuredRank {
  std::uint64_t exchanges = 0, sums = 0;
  std::uint64_t bytes_out = 0;   ///< in exchanges
  double processor_seconds = 0;  ///< between the calls
  double seconds = 0;            ///< from start to end
};

/// Makes a mesh with one thread per rank. Collective. Returns the ranks' results on the first rank, and an empty list
/// on the others. If the mesh cannot be made, the job ends.
[[nodiscard]] std::vector<MeasuredRank> measure_ranks(const ValidPslg& domain, const Goal& goal, mpi::MpiRanks& ranks);

}  // namespace pardel::bench
