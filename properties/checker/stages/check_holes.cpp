// Checks that no triangle contains the seed of a hole.
#include <algorithm>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

/// True if a chain passes a corner of triangle t, and p is so near to its segment that the rounding of the chain may
/// have moved the chain across p.
bool within_rounding(Point p, Index t, const Subject& subject, const Domain& domain, const Chains& chains) {
  const auto& corners = subject.mesh.triangles[t].v;
  const auto is_near = [&](Index segment) {
    const Segment& ends = domain.segments()[segment];
    return !exactly::line_offset_exceeds(p, subject.pslg.points[ends.a], subject.pslg.points[ends.b],
                                         domain.tolerance(segment));
  };
  // In a piece, the edges of the chain at a corner may belong to another piece.
  for (const Index v : corners)
    if (chains.segment_of[v] != no_index && is_near(chains.segment_of[v])) return true;
  return std::ranges::any_of(chains.edges, [&](const ChainEdge& edge) {
    return std::ranges::count(corners, edge.from) + std::ranges::count(corners, edge.to) > 0 && is_near(edge.segment);
  });
}

}  // namespace

void check_holes(const Subject& subject, const Domain& domain, const Chains& chains, std::span<const Index> suspects,
                 Findings& found) {
  const auto& holes = subject.pslg.holes;
  std::vector<Index> by_x;
  for (const Index h : suspects)
    if (domain.faces().face_at(holes[h]) != no_index) by_x.push_back(h);
  if (by_x.empty()) return;
  std::sort(by_x.begin(), by_x.end(), [&](Index g, Index h) { return holes[g].x < holes[h].x; });
  check_each(subject.mesh.triangles.size(), found, [&](std::size_t t, Findings& mine) {
    const Triangle& triangle = subject.mesh.triangles[t];
    const Point a = subject.corner(triangle, 0), b = subject.corner(triangle, 1), c = subject.corner(triangle, 2);
    auto hole = std::lower_bound(by_x.begin(), by_x.end(), std::min({a.x, b.x, c.x}),
                                 [&](Index h, double x) { return holes[h].x < x; });
    for (; hole != by_x.end() && holes[*hole].x <= std::max({a.x, b.x, c.x}); ++hole) {
      const Point p = holes[*hole];
      if (p.y < std::min({a.y, b.y, c.y}) || p.y > std::max({a.y, b.y, c.y})) continue;
      if (exactly::orientation(a, b, p) < 0 || exactly::orientation(b, c, p) < 0 || exactly::orientation(c, a, p) < 0)
        continue;
      if (within_rounding(p, static_cast<Index>(t), subject, domain, chains)) continue;
      const Index name = subject.names.triangle(static_cast<Index>(t));
      mine.add(ViolationKind::covered_exterior, {name, *hole}, {p},
               "triangle " + triangle_number(name) + " contains the seed of hole " + domain_number(*hole));
    }
  });
}

}  // namespace pardel::checker
