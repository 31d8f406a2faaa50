// What the definitions find in the shapes and in the structure of a mesh: the same rules as in
// properties/checker/violation.hpp, computed in exact arithmetic from coordinates and corners, by comparing everything
// with everything. Of the other rules: chains.hpp, correspondence.hpp, labels.hpp, causes.hpp.
#pragma once

#include <functional>
#include <set>

#include "exact_mesh.hpp"
#include "input_faces.hpp"

namespace pardel::fuzz {

[[nodiscard]] Triangles not_counter_clockwise(const ExactMesh& mesh);
[[nodiscard]] Triangles with_equal_twins(const ExactMesh& mesh);
/// The triangles at edges that have two triangles on one side.
[[nodiscard]] Triangles at_edges_with_too_many(const ExactMesh& mesh);
/// The edges at which a triangle does not list the one on the other side. Precondition: no edge has two triangles on
/// one side.
[[nodiscard]] Edges with_wrong_neighbours(const ExactMesh& mesh);

// Preconditions of the following: all triangles are counter-clockwise.
[[nodiscard]] Triangles larger_than(const ExactMesh& mesh, double max_area);
[[nodiscard]] Triangles with_larger_circumradius_than(const ExactMesh& mesh, double radius);
[[nodiscard]] Triangles longer_than_sizes(const ExactMesh& mesh, const std::function<double(Point)>& size);
[[nodiscard]] Edges longer_than(const ExactMesh& mesh, double max_edge);
/// The edges in the circumdisk of whose triangle the apex of the other triangle lies. Precondition: the mesh is
/// conformal.
[[nodiscard]] Edges not_locally_delaunay(const ExactMesh& mesh);

/// Points of the input that are no vertices, by their number.
[[nodiscard]] std::set<Index> missing_inputs(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces);
/// Points without triangles that are no points of the input.
[[nodiscard]] std::set<Index> unused_points(const ExactMesh& mesh, const Pslg& pslg);

/// Does the mesh cover the domain, and nothing else? Precondition: the mesh is conformal.
[[nodiscard]] bool covers_domain(const ExactMesh& mesh, const InputFaces& faces);
/// The vertices at which the border of the mesh does not meet itself as that of the domain does: at a point of the
/// input as many edges of the border meet as sides of the domain, and at other vertices none or two.
[[nodiscard]] std::set<Index> with_another_border(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces);

}  // namespace pardel::fuzz
