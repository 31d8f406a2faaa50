#include "exact_mesh.hpp"

#include <algorithm>

#include "../../ref/faces.hpp"

namespace pardel::fuzz {

ExactMesh::ExactMesh(const Mesh& mesh) : given(mesh), plain(ref::to_plain_mesh(mesh)) {
  has_triangle.resize(mesh.points.size());
  for (Index t = 0; t < plain.triangles.size(); ++t) {
    const ref::Corners& c = plain.triangles[t];
    for (int i = 0; i < 3; ++i) triangles_at[ref::edge_of(c, i)].push_back(t);
    for (const Index v : c) has_triangle[v] = true;
  }
}

bool ExactMesh::has_triangle_left_of(Index a, Index b) const {
  const auto at = triangles_at.find(ref::edge(a, b));
  return at != triangles_at.end() &&
         std::ranges::any_of(at->second, [&](Index t) { return is_left_of(plain.triangles[t], a, b); });
}

bool is_left_of(const ref::Corners& triangle, Index a, Index b) {
  for (int i = 0; i < 3; ++i)
    if (triangle[i] == a) return triangle[(i + 1) % 3] == b;
  return false;
}

}  // namespace pardel::fuzz
