// The parts of a report on a mesh that ranks have made together.
#pragma once

#include <cstdint>

#include "../cli/report.hpp"
#include "../core/ranks.hpp"
#include "../distributed/distributed.hpp"
#include "made.hpp"

namespace pardel::mpi {

/// What a rank contributes: the statistics and the exemptions of its pieces. The rest is in Made.
class PartsOfReport {
 public:
  void add(const MeshPiece& piece);

  /// Collective. Fills in what belongs to the mesh, on the first rank: statistics, digest, report and ranks.
  /// Exemption::triangle becomes the number of the triangle in the joined mesh; no_index if it does not fit an Index.
  void join(const Made& made, cli::MeshRun& run, Ranks& ranks);

 private:
  void join_tiling(Ranks& ranks);

  MeshStatistics statistics_;
  Report report_;
  std::uint64_t pieces_ = 0;
};

}  // namespace pardel::mpi
