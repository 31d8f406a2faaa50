#include "free_points.hpp"

#include "../../../core/support/same_attribute.hpp"

namespace pardel::checker {

bool FreePoints::is_settled(const Piece& piece, Index v) const {
  const std::uint64_t number = piece.number()[v];
  if (number >= pslg_.points.size()) return false;
  const auto point = static_cast<Index>(number);
  const Adjacency& adjacency = *piece.adjacency;
  if (!(piece.mesh().points[v] == pslg_.points[point]) || adjacency.on_boundary(v) ||
      !domain_.faces().incident(point).empty() || !has_data_of(piece.mesh(), v, point))
    return false;
  return adjacency.has_triangle(v) || !domain_.has_point(point);
}

/// As check_labels() demands it of a vertex on no segment.
bool FreePoints::has_data_of(const Mesh& mesh, Index v, Index point) const {
  if (!mesh.point_markers.empty()) {
    const int marker = point < pslg_.point_markers.size() ? pslg_.point_markers[point] : 0;
    if (v >= mesh.point_markers.size() || mesh.point_markers[v] != marker) return false;
  }
  if (!mesh.origin.empty() && (v >= mesh.origin.size() || mesh.origin[v] != input_vertex)) return false;
  const std::size_t k = mesh.attributes_per_point;
  if (pslg_.point_attributes.size() != k * pslg_.points.size()) return true;
  if (mesh.point_attributes.size() != k * mesh.points.size()) return false;
  return std::ranges::equal(mesh.point_attributes.span().subspan(k * v, k),
                            std::span(pslg_.point_attributes).subspan(k * point, k), is_same_attribute);
}

}  // namespace pardel::checker
