// Cuts a mesh into pieces.
#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "../../../core/join_pieces.hpp"
#include "../../../core/neighbours.hpp"

namespace pardel::testing {

/// One piece of a mesh, vertex by vertex.
class PieceOf {
 public:
  /// `again()`: true if a vertex of the piece is to be listed once more; may be empty.
  explicit PieceOf(const Mesh& whole, std::function<bool()> again = {})
      : whole_(whole), again_(std::move(again)), place_(whole.points.size(), no_index) {
    piece_.mesh.attributes_per_point = whole.attributes_per_point;
    piece_.mesh.region_attributes = whole.region_attributes;
  }
  [[nodiscard]] bool has(Index vertex) const { return place_[vertex] != no_index; }
  Index vertex(Index v) {
    if (has(v) && !(again_ && again_())) return place_[v];
    Mesh& mesh = piece_.mesh;
    place_[v] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back(whole_.points[v]);
    piece_.number.push_back(v);
    if (!whole_.origin.empty()) mesh.origin.push_back(whole_.origin[v]);
    if (!whole_.point_markers.empty()) mesh.point_markers.push_back(whole_.point_markers[v]);
    for (std::size_t i = 0; i < whole_.attributes_per_point; ++i)
      mesh.point_attributes.push_back(whole_.point_attributes[v * whole_.attributes_per_point + i]);
    return place_[v];
  }
  void add_triangle(Index t) {
    const auto& v = whole_.triangles[t].v;
    piece_.mesh.triangles.push_back({{vertex(v[0]), vertex(v[1]), vertex(v[2])}});
    if (!whole_.region.empty()) piece_.mesh.region.push_back(whole_.region[t]);
  }
  void add_edge(const ConstrainedEdge& edge) {
    piece_.mesh.constrained_edges.push_back({vertex(edge.a), vertex(edge.b), edge.segment, edge.marker});
  }
  [[nodiscard]] NumberedMesh take() {
    rebuild_neighbours(piece_.mesh.triangles, piece_.mesh.points.size());
    return std::move(piece_);
  }

 private:
  const Mesh& whole_;
  std::function<bool()> again_;
  NumberedMesh piece_;
  std::vector<Index> place_;
};

/// owner: per triangle, the piece that gets it. A constrained edge goes to the first piece that has both ends; an edge
/// that is in no piece, and a vertex without triangles, go to the first one. `again`: decides for each corner and each
/// end whether a vertex that the piece has already is listed once more. Precondition: ids are in range, and the arrays
/// have their lengths.
inline std::vector<NumberedMesh> cut_mesh(const Mesh& whole, const std::vector<std::size_t>& owner, std::size_t count,
                                          const std::function<bool()>& again = {}) {
  std::vector<PieceOf> pieces(count, PieceOf(whole, again));
  for (Index t = 0; t < whole.triangles.size(); ++t) pieces[owner[t]].add_triangle(t);
  for (const ConstrainedEdge& edge : whole.constrained_edges) {
    const auto with_both =
        std::ranges::find_if(pieces, [&](const PieceOf& piece) { return piece.has(edge.a) && piece.has(edge.b); });
    (with_both == pieces.end() ? pieces.front() : *with_both).add_edge(edge);
  }
  for (Index v = 0; v < whole.points.size(); ++v)
    if (std::ranges::none_of(pieces, [&](const PieceOf& piece) { return piece.has(v); })) pieces.front().vertex(v);
  std::vector<NumberedMesh> numbered;
  for (PieceOf& piece : pieces) numbered.push_back(piece.take());
  return numbered;
}

}  // namespace pardel::testing
