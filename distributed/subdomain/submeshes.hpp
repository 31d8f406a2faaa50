// Work that one rank does in a submesh of a mesh that is divided among ranks.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "../../parallel/scheduling/communicator.hpp"
#include "rings.hpp"

namespace pardel::engine {

/// What is done in a submesh.
struct SubmeshWork {
  std::uint32_t creator;        ///< of what it inserts: no rank
  std::span<const Name> names;  ///< of the triangles with which the work starts
  /// Returns the changed triangles, with repetitions. If the submesh is too small: see Communicator::GatheredSubmesh.
  Communicator::RefineSubmesh refine;
  std::function<bool(int rank, const Triangulation& t, TriangleId id)> is_held_by;
  /// Called when the work has succeeded, with the vertices that it has inserted, ascending.
  std::function<void(const Subdomain& part, const Triangulation& t, std::span<const VertexId> inserted)> finish;
};

/// Collective. The first rank does the work in a submesh: the triangles that `work` names, and rings around them. If
/// it needs a triangle beyond the submesh, it gets more triangles around that place, or around all if the place is
/// unknown, and starts again. Then all ranks take over the changes. Throws NotHeld on all ranks if no larger submesh is
/// possible. `t`: the triangulation of `part`; `rings`: they begin with the named triangles.
void work_in_submeshes(const SubmeshWork& work, Subdomain& part, const Triangulation& t, Rings& rings, Ranks& ranks);

}  // namespace pardel::engine
