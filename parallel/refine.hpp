// Delaunay refinement over tiles: every triangle that breaks the criteria is split, or its encroached
// edges are, until none is left that may be (Ruppert 1995; Chew 1993; the exemptions of small_angles.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "../core/result.hpp"
#include "constraints.hpp"
#include "criteria.hpp"
#include "mesher.hpp"
#include "triangulation.hpp"

namespace pardel {

/// One pass over all tiles of one lattice.
struct Sweep {
  Index cells = 0;
  std::uint64_t inserted = 0;   ///< vertices
  std::uint64_t handed_on = 0;  ///< triangles left to the task of another cell
  double seconds = 0;
};

struct RefineCounts {
  std::uint64_t inserted = 0, segment_splits = 0, refused = 0;
  bool budget_reached = false;
  bool left_alone = false;  ///< there may be exemptions; otherwise there are none
  std::vector<Sweep> sweeps;
};

/// Refines in place. The triangulation is a constrained Delaunay triangulation without ghosts, whose
/// boundary edges are all constrained. Deterministic. Fails only with `cancelled` or `resources`.
[[nodiscard]] Result<RefineCounts> refine(Triangulation& t, const Lines& lines, const Criteria& criteria,
                                          const Options& options);

/// The triangles that break the criteria and why each was left alone, ascending.
[[nodiscard]] std::vector<Exemption> exemptions(Triangulation& t, const Lines& lines, const Criteria& criteria,
                                                const Options& options, bool budget_reached);

}  // namespace pardel
