#include "locate_regions.hpp"

#include <array>
#include <vector>

#include "../../core/support/mesh_edges.hpp"
#include "../sizing/background.hpp"

namespace pardel::engine {

bool regions_mix(const Mesh& mesh) {
  if (mesh.region.size() != mesh.triangles.size()) return false;
  const ConstrainedEdgeIndex constrained(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    for (unsigned i = 0; i < 3; ++i) {
      const Index other = triangle.n[i];
      if (other == no_index || mesh.region[other] == mesh.region[t]) continue;
      if (constrained.find(triangle.v[(i + 1) % 3], triangle.v[(i + 2) % 3]) == nullptr) return true;
    }
  }
  return false;
}

void locate_regions(const Mesh& coarse, Mesh& fine, const Threads& threads) {
  SparseAsk ask(threads.stop);
  std::vector<std::array<Index, 3>> corners;
  corners.reserve(coarse.triangles.size());
  for (const Triangle& triangle : coarse.triangles) corners.push_back(triangle.v);
  const Background background(coarse.points.span(), std::move(corners));
  LocationHint hint;
  for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
    ask();
    const auto& v = fine.triangles[t].v;
    const Point a = fine.points[v[0]], b = fine.points[v[1]], c = fine.points[v[2]];
    fine.region[t] = coarse.region[background.locate({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}, hint).triangle];
  }
}

}  // namespace pardel::engine
