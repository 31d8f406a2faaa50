// Compares meshes by everything that they say. A digest covers neither markers nor attributes of points.
#pragma once

#include <string>

#include "../../core/mesh.hpp"

namespace pardel::properties {

/// How the meshes differ, apart from the order of points, triangles and edges: the first point, triangle and
/// constrained edge that only one of them has, as a sentence. Empty if they do not differ. Compared are
/// - points: coordinates, marker, origin, attributes;
/// - triangles: coordinates of the corners from the least one on, region;
/// - constrained edges: coordinates of the ends, segment, marker;
/// - the attributes of the regions.
/// Numbers are equal if their bits are.
[[nodiscard]] std::string difference(const Mesh& one, const Mesh& other);

/// What a piece of a mesh has, and the whole mesh has not, in the same words. Empty if there is nothing.
[[nodiscard]] std::string excess(const Mesh& piece, const Mesh& whole);

}  // namespace pardel::properties
