// Puts verified answers back into the mesh.
#pragma once

#include <span>
#include <vector>

#include "../../parallel/threads/threads.hpp"
#include "part.hpp"
#include "verify.hpp"

namespace pardel::engine {

/// A part and the answer that takes its place.
struct Replacement {
  Part part;
  VerifiedSubdomain answer;
};

/// Replaces parts of the mesh, and flips edges until it is constrained Delaunay again. New vertices and triangles get
/// the next numbers, in the order of the parts. Returns how many edges on borders of parts were not Delaunay: none if
/// each part had all triangles whose circumdisks contain a new point. The number of threads does not change the result.
/// Precondition: no triangle belongs to two parts. O(n) for n triangles of the answers, and the flips.
std::uint64_t glue(MeshInWork& mesh, std::span<const Replacement> replacements, const Threads& threads);

}  // namespace pardel::engine
