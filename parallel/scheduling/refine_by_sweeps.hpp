// Delaunay refinement over tiles: every triangle that breaks the criteria is split, or its encroached
// edges are, until none is left that may be (Ruppert 1995; Chew 1993; the exemptions of small_angles.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/result.hpp"
#include "../options.hpp"
#include "../refinement/criteria.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"
#include "snapshot.hpp"

namespace pardel::engine {

struct RefineCounts {
  std::uint64_t inserted = 0, segment_splits = 0, refused = 0;
  bool budget_reached = false;
  bool left_alone = false;  ///< there may be exemptions; otherwise there are none
  Tiling tiling;
};

/// How the tasks of a phase take turns. None of it shows in the result, which is what it is there to prove.
struct Schedule {
  /// Permutes the order in which the tasks are started (it comes largest first).
  std::function<void(std::vector<std::size_t>&)> order{};
  /// Called by the thread that is about to start a task.
  std::function<void(std::size_t task)> before_task{};
  std::function<void()> after_phase{};
  /// If set, one thread runs all tasks of a phase at once, one insertion at a time: which of n unfinished ones goes on.
  std::function<std::size_t(std::size_t n)> next{};
};

/// Refines in place. The triangulation is a constrained Delaunay triangulation without ghosts, whose
/// boundary edges are all constrained. Deterministic. Fails only with `cancelled`, `resources` or `internal`, or with
/// the watcher's error.
[[nodiscard]] Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments,
                                                    const Criteria& criteria, const Options& options,
                                                    const Schedule& schedule = {}, const Watcher& watcher = {});

/// The triangles that break the criteria and why each was left alone, ascending.
[[nodiscard]] std::vector<Exemption> exemptions(Triangulation& t, const DomainSegments& segments,
                                                const Criteria& criteria, const Options& options, bool budget_reached);

}  // namespace pardel::engine
