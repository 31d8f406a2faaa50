#include "faces.hpp"

#include <algorithm>
#include <utility>

#include "../core/support/doubled_area.hpp"

namespace pardel::cli {
namespace {

bool before(const Segment& s, const Segment& t) { return std::minmax(s.a, s.b) < std::minmax(t.a, t.b); }
bool same(const Segment& s, const Segment& t) { return std::minmax(s.a, s.b) == std::minmax(t.a, t.b); }

}  // namespace

void EdgeSet::finish() {
  std::stable_sort(edges.begin(), edges.end(), before);
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
}

bool EdgeSet::contains(Index a, Index b) const {
  return std::binary_search(edges.begin(), edges.end(), Segment{a, b}, before);
}

EdgeSet to_edge_set(const std::vector<ConstrainedEdge>& edges) {
  EdgeSet set;
  for (const ConstrainedEdge& edge : edges) set.edges.push_back({edge.a, edge.b, edge.marker});
  return set;
}

std::vector<Index> faces(const Mesh& mesh, const EdgeSet& walls) {
  std::vector<Index> face(mesh.triangles.size(), no_index);
  Index count = 0;
  std::vector<Index> front;
  for (Index start = 0; start < face.size(); ++start) {
    if (face[start] != no_index) continue;
    face[start] = count;
    front.push_back(start);
    while (!front.empty()) {
      const Triangle& t = mesh.triangles[front.back()];
      front.pop_back();
      for (int i = 0; i < 3; ++i) {
        if (t.n[i] == no_index || face[t.n[i]] != no_index || walls.contains(side(t, i).from, side(t, i).to)) continue;
        face[t.n[i]] = count;
        front.push_back(t.n[i]);
      }
    }
    ++count;
  }
  return face;
}

std::vector<char> open_faces(const Mesh& mesh, const EdgeSet& walls, const std::vector<Index>& face,
                             std::size_t count) {
  std::vector<char> is_open(count, 0);
  for (Index t = 0; t < face.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto [from, to] = side(mesh.triangles[t], i);
      if (mesh.triangles[t].n[i] == no_index && !walls.contains(from, to)) is_open[face[t]] = 1;
    }
  return is_open;
}

std::vector<Index> largest(const Mesh& mesh, const std::vector<Index>& face) {
  const Index count = face.empty() ? 0 : *std::max_element(face.begin(), face.end()) + 1;
  std::vector<Index> best(count, no_index);
  const auto area = [&](Index t) {
    const auto [a, b, c] = mesh.triangles[t].v;
    return doubled_area(mesh.points[a], mesh.points[b], mesh.points[c]);
  };
  for (Index t = 0; t < face.size(); ++t) {
    Index& b = best[face[t]];
    if (b == no_index || area(t) > area(b)) b = t;
  }
  return best;
}

}  // namespace pardel::cli
