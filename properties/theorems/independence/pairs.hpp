// What the theorems about the independence of points speak of.
#pragma once

#include <string>
#include <vector>

#include "../framework/scenes.hpp"

namespace pardel::properties {

[[nodiscard]] std::vector<ref::ExactPoint> insertions_of(const Scene& scene);

/// How the cavities of two points meet, in the mesh without either.
enum class Contact : std::uint8_t { none, vertex, edge, triangle };

[[nodiscard]] Contact contact(const ref::PlainMesh& mesh, const ref::ExactPoint& p, const ref::ExactPoint& q);
[[nodiscard]] std::string name(Contact contact);

/// |pq| / r̄ of a scene's first two insertions.
[[nodiscard]] double separation(const MeshedScene& meshed);

/// By definition, of all of its triangles: is it a constrained Delaunay mesh?
[[nodiscard]] bool is_conformal_and_delaunay(const ref::PlainMesh& mesh);

/// What independent insertion and insertion one after the other, in either order, make of the points.
struct Outcomes {
  ref::PlainMesh at_once, in_order, in_reverse;

  [[nodiscard]] bool are_one_mesh() const;
};
[[nodiscard]] Outcomes outcomes(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& points);

/// May every two of the points be inserted independently?
[[nodiscard]] bool are_pairwise_independent(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& points);

}  // namespace pardel::properties
