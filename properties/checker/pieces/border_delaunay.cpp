#include "border_delaunay.hpp"

#include "../arithmetic/exact.hpp"
#include "../arithmetic/filter.hpp"
#include "../arithmetic/text.hpp"

namespace pardel::checker {

EdgesOfChains::EdgesOfChains(const Judgement& judgement) {
  for (const NumberedChainEdge& edge : judgement.chains)
    ends_.push_back(std::minmax(static_cast<Index>(edge.from), static_cast<Index>(edge.to)));
  std::ranges::sort(ends_);
}

bool EdgesOfChains::contains(Index a, Index b) const {
  return std::ranges::binary_search(ends_, std::pair<Index, Index>(std::minmax(a, b)));
}

std::uint64_t check_border_delaunay(const KeptPart& part, Index first_triangle, std::span<const Across> across,
                                    const EdgesOfChains& chains, const Goal& goal, Findings& found) {
  std::vector<Index> open;
  for (std::size_t s = 0; s < part.sides.size(); ++s) {
    const KeptSide& side = part.sides[s];
    const Across& other = across[s];
    const Index t = first_triangle + side.triangle;
    if (!other.exists() || other.triangle < t) continue;
    const KeptVertex &from = part.vertices[side.from], &to = part.vertices[side.to];
    const Point a = part.vertices[side.apex].at, b = from.at, c = to.at;
    std::array<Point, 3> corners;  // in the order of the triangle, as in the scan
    corners[side.side] = a;
    corners[static_cast<std::size_t>(next(side.side))] = b;
    corners[static_cast<std::size_t>(previous(side.side))] = c;
    const filter::Shape shape(corners[0], corners[1], corners[2]);
    if (shape.is_tame() && filter::is_outside_circle(shape, side.side, b, c, other.at)) continue;
    if (!side.is_open) open.push_back(t);
    const bool on_chain = chains.contains(from.number, to.number);
    if ((on_chain && !goal.conforming) || exactly::orientation(a, b, c) <= 0 ||
        exactly::in_circle(a, b, c, other.at) <= 0)
      continue;
    const ViolationKind kind = on_chain ? ViolationKind::not_conforming : ViolationKind::not_delaunay;
    if (found.admit(kind))
      found.keep({kind,
                  {from.number, to.number, t, other.triangle},
                  {b, c},
                  "edge " + edge_text(from.number, to.number) + " of triangles " + triangle_number(t) + " and " +
                      triangle_number(other.triangle) + " is not locally Delaunay: vertex " +
                      vertex_number(other.apex) + " " + to_text(other.at) +
                      " lies inside the circumcircle, in-circle determinant " +
                      exactly::in_circle_text(a, b, c, other.at)});
  }
  std::ranges::sort(open);
  return static_cast<std::uint64_t>(std::unique(open.begin(), open.end()) - open.begin());
}

}  // namespace pardel::checker
