#include "border_delaunay.hpp"

#include "../arithmetic/exact.hpp"
#include "../arithmetic/filter.hpp"
#include "../arithmetic/text.hpp"

namespace pardel::checker {
namespace {

bool has_open_test(const Scan& scan, Index t) {
  const auto at = std::ranges::lower_bound(scan.open, t, {}, &OpenTriangle::triangle);
  return at != scan.open.end() && at->triangle == t;
}

}  // namespace

std::uint64_t check_border_delaunay(const Piece& piece, std::span<const BorderSide> border, const Chains& chains,
                                    const Scan& scan, Findings& found) {
  const Numbering& names = piece.subject.names;
  std::vector<Index> open;
  for (const auto& [edge, across] : border) {
    const auto [t, side] = edge.left;
    if (!across.exists() || across.triangle < names.triangle(t)) continue;
    const Triangle& triangle = piece.adjacency.triangles()[t];
    const Point a = piece.subject.corner(triangle, side), b = piece.subject.corner(triangle, next(side)),
                c = piece.subject.corner(triangle, previous(side));
    const filter::Shape shape(a, b, c);
    if (shape.is_tame() && filter::is_outside_circle(shape, 0, b, c, across.at)) continue;
    if (!has_open_test(scan, t)) open.push_back(t);
    const bool on_chain = chains.has(t, side);
    if ((on_chain && !piece.subject.goal.conforming) || exactly::orientation(a, b, c) <= 0 ||
        exactly::in_circle(a, b, c, across.at) <= 0)
      continue;
    const ViolationKind kind = on_chain ? ViolationKind::not_conforming : ViolationKind::not_delaunay;
    if (found.admit(kind))
      found.keep({kind,
                  {names.vertex(edge.from), names.vertex(edge.to), names.triangle(t), across.triangle},
                  {b, c},
                  "edge " + names.edge_text(edge.from, edge.to) + " of triangles " + to_text(names.triangle(t)) +
                      " and " + to_text(across.triangle) + " is not locally Delaunay: vertex " + to_text(across.apex) +
                      " " + to_text(across.at) + " lies inside the circumcircle, in-circle determinant " +
                      exactly::in_circle_text(a, b, c, across.at)});
  }
  std::ranges::sort(open);
  return static_cast<std::uint64_t>(std::unique(open.begin(), open.end()) - open.begin());
}

}  // namespace pardel::checker
