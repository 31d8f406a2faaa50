// Hairlines: gaps outside the domain that are so narrow that rounding could move the boundary across them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// A triangle outside the domain, so flat that its sides may belong to a hairline.
struct FlatTriangle {
  std::array<std::uint64_t, 3> v;  ///< the positions of its corners, counter-clockwise
  std::array<Point, 3> at;
  std::array<std::uint64_t, 3> is_segment;  ///< 1 if the side opposite the corner is constrained, else 0
};

/// The end of a segment that is very close to another segment, or to the end of another one (then a == b).
struct Hairline {
  std::uint64_t tip, a, b;  ///< positions
  Point tip_at, a_at, b_at;
  double slope = 0;  ///< as slope_at_tip() says
};

/// True if two of the corners are closer than rounding can separate, or one is so close to the opposite side.
[[nodiscard]] bool is_flat(Point a, Point b, Point c);

/// Appends the triangle if it is flat. `position_of(v)`: the position of a vertex. Precondition: it is no ghost.
template <class PositionOf>
void add_if_flat(const Triangulation& t, const Slot& slot, const PositionOf& position_of,
                 std::vector<FlatTriangle>& flat) {
  if (!is_flat(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]])) return;
  FlatTriangle triangle;
  for (unsigned i = 0; i < 3; ++i) {
    triangle.v[i] = position_of(slot.v[i]);
    triangle.at[i] = t.points[slot.v[i]];
    triangle.is_segment[i] = slot.n[i].constrained() ? 1 : 0;
  }
  flat.push_back(triangle);
}

/// The hairlines between segments that only flat triangles separate. O(n log n) for n triangles.
[[nodiscard]] std::vector<Hairline> hairlines_among(std::span<const FlatTriangle> flat);

/// The distance between the tip and segment ab.
[[nodiscard]] double gap_of(const Hairline& line);

/// The least sine of an angle between a segment that ends at the tip and segment ab; 0 if a == b, or if no segment ends
/// there. `tip`: the vertex, of which all segments are known.
[[nodiscard]] double slope_at_tip(const Hairline& line, VertexId tip, const DomainSegments& segments,
                                  const Array<Point>& points);

/// Makes both segments of a hairline stay clear of each other (clearance.hpp). `beside`: the segment ab. Nothing
/// happens to a segment that is not known: the tip or the segment is no_index.
void keep_clear(const Hairline& line, VertexId tip, Index beside, DomainSegments& segments, const Array<Point>& points);

/// The same for hairlines whose positions are vertices of a triangulation that has all segments. A tip may also lie
/// inside a segment of a mesh, where subsegments meet; then this segment may lie anywhere beside segment ab. A tip at
/// which no segment ends or passes is in the way of none.
void keep_clear(std::vector<Hairline> all, const Triangulation& t, DomainSegments& segments);

}  // namespace pardel::engine
