// Terms of the theorems about independent points.
#pragma once

#include <string>
#include <vector>

#include "../framework/scenes.hpp"

namespace pardel::properties {

[[nodiscard]] std::vector<ref::ExactPoint> insertions_of(const Scene& scene);

/// The largest common part of the cavities of two points. Both cavities are in the mesh before the insertions.
enum class Contact : std::uint8_t { none, vertex, edge, triangle };

[[nodiscard]] Contact contact(const ref::PlainMesh& mesh, const ref::ExactPoint& p, const ref::ExactPoint& q);
[[nodiscard]] std::string name(Contact contact);

/// |pq| / r̄ of a scene's first two insertions.
[[nodiscard]] double separation(const MeshedScene& meshed);

/// Is the mesh conformal and constrained Delaunay? The definitions are tested on all triangles.
[[nodiscard]] bool is_conformal_and_delaunay(const ref::PlainMesh& mesh);

/// The results of independent insertion, and of sequential insertion in two orders.
struct Outcomes {
  ref::PlainMesh at_once;               ///< independent insertion
  ref::PlainMesh in_order, in_reverse;  ///< sequential insertion

  [[nodiscard]] bool are_one_mesh() const;
};
[[nodiscard]] Outcomes outcomes(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& points);

/// Are every two of the points independent?
[[nodiscard]] bool are_pairwise_independent(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& points);

}  // namespace pardel::properties
