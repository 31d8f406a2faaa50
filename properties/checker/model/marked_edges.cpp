#include "marked_edges.hpp"

#include <algorithm>
#include <functional>

#include "../arithmetic/exact.hpp"

namespace pardel::checker {
namespace {

/// True if a, b, c and b, a, d are triangles, and one of them has the other's third corner inside its circumcircle.
bool is_not_delaunay(Point a, Point b, Point c, Point d) {
  return exactly::orientation(a, b, c) > 0 && exactly::orientation(b, a, d) > 0 && exactly::in_circle(a, b, c, d) > 0;
}

}  // namespace

MarkedEdges::MarkedEdges(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, StopSignal* stop) {
  if (mesh.constrained_edges.empty()) infer(mesh, adjacency, scan, stop);
  for (const ConstrainedEdge& edge : mesh.constrained_edges) ends_.push_back(std::minmax(edge.a, edge.b));
  stoppable_sort(ends_.begin(), ends_.end(), std::less<>(), stop);
}

void MarkedEdges::infer(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, StopSignal* stop) {
  SparseAsk ask(stop);
  const auto triangles = adjacency.triangles();
  for (const BoundaryEdge& edge : adjacency.boundary()) ends_.push_back(std::minmax(edge.from, edge.to));
  // An edge whose test is not open is locally Delaunay.
  for (const Index t : scan.open_for(Test::delaunay)) {
    ask();
    for (int edge = 0; edge < 3; ++edge) {
      const auto& [v, n] = triangles[t];
      const Index a = v[next(edge)], b = v[previous(edge)];
      if (n[edge] == no_index || n[edge] < t) continue;
      const auto& across = triangles[n[edge]].v;
      const Index apex = *std::find_if(across.begin(), across.end() - 1, [=](Index u) { return u != a && u != b; });
      if (is_not_delaunay(mesh.points[a], mesh.points[b], mesh.points[v[edge]], mesh.points[apex]))
        ends_.push_back(std::minmax(a, b));
    }
  }
}

bool MarkedEdges::contains(Index a, Index b) const {
  return std::binary_search(ends_.begin(), ends_.end(), std::pair<Index, Index>(std::minmax(a, b)));
}

}  // namespace pardel::checker
