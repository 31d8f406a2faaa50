// The parts of a report on a mesh that ranks have made together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../cli/report.hpp"
#include "../core/ranks.hpp"
#include "../distributed/distributed.hpp"
#include "made.hpp"

namespace pardel::mpi {

/// What a rank contributes: the statistics and the exemptions of its pieces. The rest is in Made.
class PartsOfReport {
 public:
  /// `has_lists`: keeps what only the report of --json has, lists that can be as long as a piece or longer.
  explicit PartsOfReport(bool has_lists) : has_lists_(has_lists) {}

  void add(const MeshPiece& piece);

  /// The gaps of the domain, after add().
  [[nodiscard]] std::span<const Gap> gaps() const { return report_.gaps; }

  /// Collective. Fills in what belongs to the mesh: on all ranks the statistics, the digest and the numbers of exempt
  /// triangles; on the first one also the report and the ranks. Without lists, the report has no exemptions, and the
  /// tiling is that of this rank. Otherwise Exemption::triangle becomes the number of the triangle in the joined mesh;
  /// no_index if it does not fit an Index.
  void join(const Made& made, cli::MeshRun& run, Ranks& ranks);

 private:
  void keep_list(const MeshPiece& piece);
  void join_lists(Ranks& ranks);
  void join_tiling(Ranks& ranks);
  [[nodiscard]] cli::ExemptTriangles join_exempt(Ranks& ranks);

  bool has_lists_;
  MeshStatistics statistics_;
  cli::ExemptTriangles exempt_;
  std::vector<Exemption> list_;  ///< with the numbers of the joined mesh
  Report report_;                ///< without exemptions
  std::uint64_t pieces_ = 0;
};

}  // namespace pardel::mpi
