// Random values for files. They need not be sensible domains or meshes, because files store anything.
#pragma once

#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace pardel::fuzz {

/// A finite number: a small integer, one in (-1, 1), or any bits.
[[nodiscard]] double any_number(generators::Random& random);
/// A finite number greater than 0.
[[nodiscard]] double any_positive_number(generators::Random& random);

/// A polygon of three to six random points with attributes, markers, holes and regions. It may cross itself.
[[nodiscard]] Pslg any_pslg(generators::Random& random);
/// The points of any_pslg() as a fan of triangles; its segments are constrained edges.
[[nodiscard]] Mesh any_fan(generators::Random& random);
/// A fan, or triangles that share nothing but points.
[[nodiscard]] Mesh any_mesh(generators::Random& random);
/// Adds fields, first those at points, and names of markers and regions.
void add_fields_and_names(Mesh& mesh, generators::Random& random);

}  // namespace pardel::fuzz
