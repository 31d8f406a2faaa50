// Writes the triangles of a patch, or some of them, with the numbers that they and their corners have in the mesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../threads/threads.hpp"
#include "find_patches.hpp"

namespace pardel::engine {

/// Where the points and triangles of a patch are in the mesh: the numbers of the first ones.
struct PlacesOfPatch {
  Index first_border;  ///< the points on the border
  Index first_inner;   ///< the points inside
  Index first_triangle;
};

/// The places of the patches, one patch after the other. `first_border`: the first point on a border. `points`,
/// `triangles`: the numbers of those around the patches, which come first. Precondition: all numbers fit an Index.
[[nodiscard]] std::vector<PlacesOfPatch> places_of(std::span<const RegionPatch> patches, Index first_border,
                                                   std::size_t points, std::size_t triangles);

/// Triangles of a mesh with consecutive numbers.
struct TriangleRange {
  std::span<Triangle> triangles;
  Index first = 0;  ///< the number of the first one
  /// The triangle with this number.
  [[nodiscard]] Triangle& operator[](Index number) const { return triangles[number - first]; }
};

/// Writes the triangles of some strips of the patch. Corners and neighbours have their numbers in the whole mesh, also
/// those that belong to other strips. Sides on the border of the patch get no neighbours. The number of threads does
/// not change the result.
void write_strips(const Patch& patch, const PlacesOfPatch& places, std::span<const Strip> strips,
                  const TriangleRange& to, const Threads& threads);

}  // namespace pardel::engine
