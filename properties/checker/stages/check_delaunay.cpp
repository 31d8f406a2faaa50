// Checks that edges are locally Delaunay. If all are, the triangulation is (constrained) Delaunay: Delaunay's lemma.
#include <algorithm>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {

void check_delaunay(const Subject& subject, const Adjacency& adjacency, const Chains& chains, const Scan& scan,
                    Findings& found) {
  const auto triangles = adjacency.triangles();
  const Numbering& names = subject.names;
  const bool trust_orientation = found.count(ViolationKind::degenerate_triangle) == 0;
  const std::vector<Index> open = scan.open_for(Test::delaunay);
  check_each(open.size(), found, [&](std::size_t i, Findings& mine) {
    const Index t = open[i];
    const Triangle& triangle = triangles[t];
    const Point a = subject.corner(triangle, 0), b = subject.corner(triangle, 1), c = subject.corner(triangle, 2);
    if (!trust_orientation && exactly::orientation(a, b, c) <= 0) return;
    for (int edge = 0; edge < 3; ++edge) {
      const Index other = triangle.n[edge];
      if (other == no_index || other < t || (chains.has(t, edge) && !subject.goal.conforming)) continue;
      const Triangle& across = triangles[other];
      const Index from = triangle.v[next(edge)], to = triangle.v[previous(edge)];
      const Index apex =
          *std::find_if(across.v.begin(), across.v.end() - 1, [=](Index v) { return v != from && v != to; });
      const Point d = subject.mesh.points[apex];
      if (exactly::in_circle(a, b, c, d) <= 0) continue;
      const ViolationKind kind = chains.has(t, edge) ? ViolationKind::not_conforming : ViolationKind::not_delaunay;
      if (mine.admit(kind))
        mine.keep({kind,
                   {names.vertex(from), names.vertex(to), names.triangle(t), names.triangle(other)},
                   {subject.mesh.points[from], subject.mesh.points[to]},
                   "edge " + names.edge_text(from, to) + " of triangles " + triangle_number(names.triangle(t)) +
                       " and " + triangle_number(names.triangle(other)) + " is not locally Delaunay: vertex " +
                       vertex_number(names.vertex(apex)) + " " + to_text(d) +
                       " lies inside the circumcircle, in-circle determinant " + exactly::in_circle_text(a, b, c, d)});
    }
  });
}

}  // namespace pardel::checker
