// Random meshes whose largest circumradius is near the bound of T3 or T3-sharp, and others.
#pragma once

#include <iosfwd>

#include "../../../ref/definitions.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::properties {

enum class MeshKind : std::uint8_t {
  delaunay,           ///< the Delaunay triangulation of a random scene
  refined,            ///< a rectangle with isolated points, refined by Ruppert's algorithm
  with_thin_corners,  ///< the same, with isosceles triangles of the extremal shape of T3-sharp attached to its border
  equilateral         ///< a lattice of nearly equilateral triangles, the extremal shape of T3
};
[[nodiscard]] const char* name(MeshKind kind);

struct WholeMesh {
  MeshKind kind = MeshKind::delaunay;
  ref::PlainMesh mesh;
};
std::ostream& operator<<(std::ostream& out, const WholeMesh& whole);

[[nodiscard]] WholeMesh random_whole_mesh(generators::Random& random, int size);

}  // namespace pardel::properties
