// Changes of a mesh that no list of defects foresees.
#pragma once

#include "../../core/mesh.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace pardel::fuzz {

/// Moves a vertex, flips an edge, removes or adds a triangle, or gives it another corner; or changes a neighbour, a
/// region, a marker, an origin, an attribute or an entry of the list of constrained edges. Precondition: the mesh has a
/// triangle, and arrays of the right lengths.
void damage(Mesh& mesh, generators::Random& random);

/// Moves one of the last vertices by up to three doubles in each coordinate, and sometimes also by up to 2e-9 of its
/// distance from another vertex. Precondition: the mesh has a vertex.
void nudge(Mesh& mesh, generators::Random& random);

/// Gives a triangle a region, also in a mesh without regions; or changes an attribute of one of the last vertices, by a
/// little or much. Precondition: the mesh has a triangle.
void damage_values(Mesh& mesh, generators::Random& random);

}  // namespace pardel::fuzz
