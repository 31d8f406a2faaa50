// Work that one rank does in an excerpt of a mesh that is divided among ranks.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "../../parallel/scheduling/partners.hpp"
#include "rings.hpp"

namespace pardel::engine {

/// What is done in an excerpt.
struct ExcerptWork {
  std::uint32_t creator;        ///< of what it inserts: no rank
  std::span<const Name> names;  ///< of the triangles with which the work starts
  /// Returns the changed triangles, with repetitions. If the excerpt is too small: see Partners::Excerpt.
  Partners::RefineExcerpt refine;
  std::function<bool(int rank, const Triangulation& t, TriangleId id)> is_held_by;
  /// Called when the work has succeeded, with the vertices that it has inserted, ascending.
  std::function<void(const HeldPart& part, const Triangulation& t, std::span<const VertexId> inserted)> finish;
};

/// Collective. The first rank does the work in an excerpt: the triangles that `work` names, and rings around them. If
/// it needs a triangle beyond the excerpt, it gets more triangles around that place, or around all if the place is
/// unknown, and starts again. Then all ranks take over the changes. Throws NotHeld on all ranks if no larger excerpt is
/// possible. `t`: the triangulation of `part`; `rings`: they begin with the named triangles.
void work_in_excerpts(const ExcerptWork& work, HeldPart& part, const Triangulation& t, Rings& rings, Ranks& ranks);

}  // namespace pardel::engine
