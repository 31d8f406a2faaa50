// Work that one rank does in an excerpt of a mesh that is divided among ranks.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "../scheduling/partners.hpp"
#include "rings.hpp"

namespace pardel::engine {

/// What is done in an excerpt.
struct ExcerptWork {
  std::uint32_t creator;        ///< of what it inserts: no rank
  std::span<const Name> names;  ///< of the triangles with which the work starts
  /// Returns the changed triangles, with repetitions. Throws NotHeld if the excerpt is too small.
  Partners::RefineExcerpt refine;
  std::function<bool(int rank, const Triangulation& t, TriangleId id)> is_held_by;
  /// Called when the work has succeeded, with the vertices that it has inserted, ascending.
  std::function<void(const HeldPart& part, const Triangulation& t, std::span<const VertexId> inserted)> finish;
};

/// The first rank does the work in an excerpt: in the triangles with the names and in rings around them. If these were
/// too few, it does it again in an excerpt with more rings. Then the parts of all ranks get the changes. Throws NotHeld
/// if all triangles that are connected with those with the names are too few. Collective. `t`: that of the part;
/// `rings`: they begin with the triangles with the names.
void work_in_excerpts(const ExcerptWork& work, HeldPart& part, const Triangulation& t, Rings& rings, Ranks& ranks);

}  // namespace pardel::engine
