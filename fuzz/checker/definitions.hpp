// What the definitions find in a mesh: the same rules as in properties/checker/violation.hpp, computed in exact
// arithmetic from coordinates and corners, by comparing everything with everything.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../../ref/definitions.hpp"
#include "input_faces.hpp"

namespace pardel::fuzz {

/// Triangles by their index.
using Triangles = std::set<Index>;
using Edges = std::set<ref::Edge>;

/// A mesh with the maps that the definitions need. Precondition: all corners are points that are finite, and no
/// triangle has two equal corners.
struct ExactMesh {
  explicit ExactMesh(const Mesh& mesh);

  const Mesh& given;
  ref::PlainMesh plain;
  std::map<ref::Edge, std::vector<Index>> triangles_at;
  std::vector<bool> has_triangle;  ///< per point
};

[[nodiscard]] Triangles not_counter_clockwise(const ExactMesh& mesh);
[[nodiscard]] Triangles with_equal_twins(const ExactMesh& mesh);
/// The triangles at edges that have two triangles on one side.
[[nodiscard]] Triangles at_edges_with_too_many(const ExactMesh& mesh);
/// The edges at which a triangle does not list the one on the other side. Precondition: no edge has two triangles on
/// one side.
[[nodiscard]] Edges with_wrong_neighbours(const ExactMesh& mesh);

// Preconditions of the following: all triangles are counter-clockwise.
[[nodiscard]] Triangles with_small_angles(const ExactMesh& mesh, double min_angle_deg);
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
/// Points of the input with other attributes, and other vertices with an attribute that is not between those of the
/// points of the input.
[[nodiscard]] std::set<Index> with_wrong_attributes(const ExactMesh& mesh, const Pslg& pslg);

/// True if every used vertex lies exactly on a wall or far from it, compared with rounding, so that tolerances do not
/// matter. Precondition: no input is missing.
[[nodiscard]] bool is_far_or_on_walls(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces);

/// The edges of a mesh that lie on walls of the domain. Preconditions: the mesh is conformal, no input is missing,
/// is_far_or_on_walls().
struct Walls {
  std::map<ref::Edge, const Wall*> wall_of;
  std::vector<const Wall*> wall_of_vertex;  ///< per point: a wall in whose interior it lies, or null
  std::set<Index> broken;                   ///< the segments that no chain of edges covers
  bool are_whole = true;                    ///< no segment and no side of the hull is broken
};
[[nodiscard]] Walls walls_of(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces);

// Preconditions of the following: Walls::are_whole.
/// Per triangle, the face of the input that contains its centroid.
[[nodiscard]] std::vector<InputFaces::Face> faces_of_triangles(const ExactMesh& mesh, const InputFaces& faces);
/// Does the mesh cover the domain, and nothing else? `face`: the faces of the triangles, here and below.
[[nodiscard]] bool covers_domain(const ExactMesh& mesh, const InputFaces& faces,
                                 const std::vector<InputFaces::Face>& face);
[[nodiscard]] std::set<Index> with_wrong_origin(const ExactMesh& mesh, const Pslg& pslg, const Walls& walls);
[[nodiscard]] std::set<Index> with_wrong_marker(const ExactMesh& mesh, const Pslg& pslg, const Walls& walls);
/// What is wrong in the list of constrained edges, by position in the list, and what is missing.
struct ListFaults {
  std::set<Index> wrong, wrong_marker;
  Edges missing;
};
[[nodiscard]] ListFaults faults_of_list(const ExactMesh& mesh, const Walls& walls);
// Precondition of the following: covers_domain().
[[nodiscard]] Triangles with_wrong_region(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                                          const std::vector<InputFaces::Face>& face);
[[nodiscard]] Triangles larger_than_caps(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces,
                                         const std::vector<InputFaces::Face>& face);

}  // namespace pardel::fuzz
