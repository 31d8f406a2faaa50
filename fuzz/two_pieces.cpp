#include "two_pieces.hpp"

#include <algorithm>

#include "../core/neighbours.hpp"

namespace pardel::fuzz {
namespace {

bool has_equal_corners(const Triangle& t) { return t.v[0] == t.v[1] || t.v[1] == t.v[2] || t.v[2] == t.v[0]; }

/// Fills the piece of the triangles [begin, end), without constrained edges. Returns the point of the piece for each
/// point of the whole mesh, or no_index.
std::vector<Index> take(const Mesh& whole, std::size_t begin, std::size_t end, Mesh& piece,
                        std::vector<std::uint64_t>& number) {
  std::vector<Index> local(whole.points.size(), no_index);
  for (std::size_t t = begin; t < end; ++t)
    for (const Index v : whole.triangles[t].v) local[v] = 0;
  const std::size_t attributes = whole.attributes_per_point;
  piece.attributes_per_point = attributes;
  for (std::size_t v = 0; v < local.size(); ++v) {
    if (local[v] == no_index) continue;
    local[v] = static_cast<Index>(number.size());
    number.push_back(v);
    piece.points.push_back(whole.points[v]);
    piece.point_markers.push_back(whole.point_markers.empty() ? 0 : whole.point_markers[v]);
    for (std::size_t k = 0; k < attributes; ++k)
      piece.point_attributes.push_back(whole.point_attributes[v * attributes + k]);
  }
  piece.region_attributes = whole.region_attributes;
  for (std::size_t t = begin; t < end; ++t) {
    Triangle triangle = whole.triangles[t];
    for (Index& v : triangle.v) v = local[v];
    piece.triangles.push_back(triangle);
    if (!whole.region.empty()) piece.region.push_back(whole.region[t]);
  }
  rebuild_neighbours(piece.triangles, piece.points.size());
  return local;
}

}  // namespace

std::optional<TwoPieces> in_two_pieces(const Mesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  if (n < 2 || std::any_of(mesh.triangles.begin(), mesh.triangles.end(), has_equal_corners)) return {};
  TwoPieces made;
  made.points = mesh.points.size();
  const std::array locals = {take(mesh, 0, n / 2, made.mesh[0], made.number[0]),
                             take(mesh, n / 2, n, made.mesh[1], made.number[1])};
  std::array<SharedVertices, 2> common = {SharedVertices{1, {}}, SharedVertices{0, {}}};
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (locals[0][v] == no_index && locals[1][v] == no_index) return {};
    if (locals[0][v] == no_index || locals[1][v] == no_index) continue;
    for (std::size_t rank = 0; rank < 2; ++rank) common[rank].vertices.push_back(locals[rank][v]);
  }
  for (std::size_t rank = 0; rank < 2; ++rank)
    if (!common[rank].vertices.empty()) made.shared[rank] = {common[rank]};
  for (ConstrainedEdge edge : mesh.constrained_edges) {
    const auto has_ends = [&](const auto& local) { return local[edge.a] != no_index && local[edge.b] != no_index; };
    const auto* const local = std::ranges::find_if(locals, has_ends);
    if (local == locals.end()) return {};
    edge.a = (*local)[edge.a];
    edge.b = (*local)[edge.b];
    made.mesh[static_cast<std::size_t>(local - locals.begin())].constrained_edges.push_back(edge);
  }
  return made;
}

}  // namespace pardel::fuzz
