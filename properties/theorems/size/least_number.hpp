// A number of triangles that no mesh of a domain undercuts if it meets a bound on angles. Statement and proof:
// THEORY.md, LeastNumber.
#pragma once

#include <functional>

#include "../../../core/mesh.hpp"

namespace pardel::properties {

/// The larger of two numbers: the triangles of `domain`, and the integral over the domain of 1 / min(area bound, K ρ²),
/// bounded from below by a sum over `cells`.
/// - `domain` is a triangulation of the input without further vertices. Its vertices and constrained edges are the
///   features of the domain.
/// - `cells` is any mesh of the domain. Smaller cells give a larger, more accurate number.
/// - `min_angle_deg` is the bound on angles, > 0 and at most 60.
/// - `largest_area(t)` is the bound on the areas of triangles in the cell t; infinity if there is none.
/// Up to rounding, the number is a lower bound for every choice of cells.
[[nodiscard]] double least_number_of_triangles(const Mesh& domain, const Mesh& cells, double min_angle_deg,
                                               const std::function<double(std::size_t)>& largest_area);

}  // namespace pardel::properties
