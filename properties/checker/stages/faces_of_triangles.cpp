#include "faces_of_triangles.hpp"

namespace pardel::checker {

std::vector<Index> paint_faces(const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                               StopSignal* stop) {
  const auto triangles = adjacency.triangles();
  std::vector<Index> face(triangles.size(), no_index);
  std::vector<Index> stack;
  const auto paint = [&](Index t, Index colour) {
    if (face[t] != no_index) return;
    face[t] = colour;
    stack.push_back(t);
  };
  for (const ChainEdge& edge : chains.edges) {
    if (edge.left.exists()) paint(edge.left.triangle, domain.faces().face(edge.segment, Side::left));
    if (edge.right.exists()) paint(edge.right.triangle, domain.faces().face(edge.segment, Side::right));
  }
  SparseAsk ask(stop);
  while (!stack.empty()) {
    ask();
    const Index t = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Index n = triangles[t].n[i];
      if (n != no_index && !chains.has(t, i)) paint(n, face[t]);
    }
  }
  return face;
}

}  // namespace pardel::checker
