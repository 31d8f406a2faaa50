#include "around_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "../parallel/mesher.hpp"
#include "faces.hpp"

namespace pardel::cli {

std::vector<Segment> boundary(const Mesh& mesh) {
  std::vector<Segment> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (t.n[i] == no_index) edges.push_back({side(t, i).from, side(t, i).to, 1});
    }
  }
  return edges;
}

Pslg part_of(const Mesh& mesh, const std::vector<Segment>& edges) {
  Pslg part;
  std::vector<Index> number(mesh.points.size(), no_index);
  const auto renumbered = [&](Index v) {
    if (number[v] == no_index) {
      number[v] = static_cast<Index>(part.points.size());
      part.points.push_back(mesh.points[v]);
    }
    return number[v];
  };
  for (const Segment& edge : edges) {
    const Index a = renumbered(edge.a);
    part.segments.push_back({a, renumbered(edge.b)});
  }
  return part;
}

Result<AroundMesh> around_mesh(const Pslg& pslg, std::size_t walls) {
  Result<Meshed> hull = triangulate(pslg, true);
  if (!hull) return hull.error();
  AroundMesh around{std::move(hull->mesh), {}, {}, {}, {}};
  std::vector<Segment> forwards(pslg.segments.begin(), pslg.segments.begin() + static_cast<std::ptrdiff_t>(walls));
  EdgeSet between{forwards};
  between.finish();
  around.face = faces(around.hull, between);
  around.best = largest(around.hull, around.face);
  around.is_out = open_faces(around.hull, between, around.face, around.best.size());
  around.is_bare.assign(around.best.size(), 0);
  const auto directed = [](const Segment& s, const Segment& t) { return std::pair(s.a, s.b) < std::pair(t.a, t.b); };
  std::sort(forwards.begin(), forwards.end(), directed);
  for (Index t = 0; t < around.face.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto [from, to] = side(around.hull.triangles[t], i);
      if (std::binary_search(forwards.begin(), forwards.end(), Segment{to, from}, directed))
        around.is_bare[around.face[t]] = 1;
    }
  }
  return around;
}

}  // namespace pardel::cli
