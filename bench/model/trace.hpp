// The trace of a run by one process and one thread, from which the runs of many ranks are predicted.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "../../core/goal.hpp"
#include "../../parallel/options.hpp"
#include "../../parallel/validate.hpp"
#include "lone_rank.hpp"
#include "replay.hpp"

namespace pardel::bench {

/// The task of a cell in one phase.
struct TaskRecord {
  Index cell = 0;
  double seconds = 0;  ///< of processor time
  std::uint64_t inserted = 0;
};
using PhaseRecord = std::vector<TaskRecord>;

/// What is predicted for a number of ranks.
struct ForRanks {
  Replay replay;
  LoneRank alone;
};

struct Trace {
  double before_seconds = 0;           ///< processor time of triangulation, planning and coarse levels
  std::uint64_t coarse_triangles = 0;  ///< when the mesh is divided
  std::vector<double> promised;        ///< per cell of the finest tiles: the work by which the mesh is divided
  std::shared_ptr<const engine::Tiles> tiles;
  MessageCosts messages;
  std::vector<ForRanks> for_ranks;
  // Of the whole run:
  std::vector<PhaseRecord> phases;
  std::uint64_t rest = 0;       ///< triangles that the first rank refines in a submesh
  double piece_seconds = 0;     ///< processor time to make the pieces
  std::uint64_t triangles = 0;  ///< of the mesh

  /// What each of the ranks has to do. `read_seconds`: to read and to validate the input.
  [[nodiscard]] RankCosts costs(const LoneRank& alone, double read_seconds) const {
    return {before_seconds + read_seconds, alone.divide_seconds, alone.phase_seconds, messages.write_byte,
            messages.read_byte};
  }
};

enum class Extent : std::uint8_t {
  whole,   ///< the whole mesh
  coarse,  ///< until the mesh is divided
};

/// Makes the mesh as one rank of one thread would, and replays the run for each number of ranks. Errors: as those of
/// mesh(). Memory: as for the mesh in one rank. The replays take much longer than the mesh.
[[nodiscard]] Result<Trace> trace(const ValidPslg& domain, const Goal& goal, const Options& options,
                                  const std::vector<int>& ranks, Extent extent = Extent::whole);

}  // namespace pardel::bench
