#include "small_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/between_ends.hpp"
#include "../arithmetic/box.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/expansion.hpp"
#include "../arithmetic/predicates.hpp"
#include "../arithmetic/projected.hpp"

namespace pardel::engine {
namespace {

double degrees(double cosine) { return std::acos(cosine) * 180 / std::numbers::pi; }

/// The power of two in [length/3, 2 length/3] that is nearest to the middle, as in Triangle.
double shell(double length) {
  const double radius = std::ldexp(1.0, std::ilogb(length));  // length / 2 < radius <= length
  return length < 1.5 * radius ? 0.5 * radius : radius;
}

/// The place of the line through a and b that has the x coordinate of p, rounded once. Precondition: a.x != b.x.
Point moved_along_y(Point p, Point a, Point b) {
  // The second step corrects the rounding of the first, which can be a long one.
  for (int step = 0; step < 2; ++step) p.y -= exact::twice_area(a, b, p) / (b.x - a.x);
  return p;
}

Point transposed(Point p) { return {p.y, p.x}; }

/// If the predicates are not exact for the x coordinate of p: the nearest place of the edge u-v where it is zero or
/// smallest_coordinate, if there is one. The edge is a part of the segment a-b.
std::optional<Point> with_usable_x(Point p, Point u, Point v, Point a, Point b) {
  if (is_usable(p.x)) return {};
  std::array candidates{0.0, std::copysign(smallest_coordinate, p.x)};
  if (std::abs(p.x) > smallest_coordinate / 2) std::swap(candidates[0], candidates[1]);
  for (const double x : candidates) {
    if (!(std::min(u.x, v.x) < x && x < std::max(u.x, v.x))) continue;
    const Point q = moved_along_y({x, p.y}, a, b);
    if (is_usable(q.y)) return q;
  }
  return {};
}

/// p, a point of the edge u-v, if the predicates are exact for it. Otherwise a point of the edge beside it for which
/// they are; u if there is none. The edge is a part of the segment a-b.
Point usable_on_edge(Point p, Point u, Point v, Point a, Point b) {
  if (is_usable(p)) return p;
  if (const auto q = with_usable_x(p, u, v, a, b)) return *q;
  if (const auto q = with_usable_x(transposed(p), transposed(u), transposed(v), transposed(a), transposed(b)))
    return transposed(*q);
  return u;
}

/// By how much the distances of two points from their apex may differ on one shell, by the rounding of coordinates.
/// `p` is one of the points.
double shell_width(Point apex, Point p) {
  const double largest = std::max({std::abs(apex.x), std::abs(apex.y), std::abs(p.x), std::abs(p.y)});
  return 1e-10 * distance(apex, p) + 0x1p-50 * largest;
}

/// True if u and v have the same distance from the apex, up to the rounding of coordinates.
bool same_shell(Point apex, Point u, Point v) {
  return std::abs(distance(apex, u) - distance(apex, v)) <= shell_width(apex, u);
}

/// The end of the edge a-b around which the edge is split at a shell; no_index if it is split in the middle. `widest`
/// is 1 minus the cosine of the largest angle that makes an end an apex.
VertexId centre_of_shell(const DomainSegment& segment, VertexId a, VertexId b, double widest) {
  const double at_a = 1 - segment.cosine_at(a), at_b = 1 - segment.cosine_at(b);  // these grow with the angles
  const double smaller = std::min(at_a, at_b), larger = std::max(at_a, at_b);
  if (smaller >= widest) return no_index;
  const bool two_similar_apexes = larger < widest && smaller >= 0.5 * larger;
  if (two_similar_apexes) return no_index;
  return at_a < at_b ? a : b;
}

/// The number in [low, high] with the fewest binary digits. Precondition: 0 < low < high.
double shortest_number(double low, double high) {
  for (double step = std::ldexp(1.0, std::ilogb(high));; step /= 2) {
    const double multiple = std::ceil(low / step) * step;
    if (multiple <= high) return multiple;
  }
}

/// The end of a segment with a narrow apex around which an edge not at an apex is split. Both ends can be apexes. Then
/// it is the one whose angle is narrower at the middle of the edge.
VertexId centre_of_wedge(const Triangulation& t, const DomainSegment& segment, Point a, Point b) {
  const VertexId other = segment.narrow_apex == segment.a ? segment.b : segment.a;
  const double squared_angle = 2 * (1 - segment.cosine_at(segment.narrow_apex));
  const double squared_other_angle = 2 * (1 - segment.cosine_at(other));
  constexpr double at_60_degrees = 1;
  if (squared_other_angle >= at_60_degrees) return segment.narrow_apex;
  const Point middle = middle_of(a, b);
  const double here = distance(t.points[segment.narrow_apex], middle), there = distance(t.points[other], middle);
  return here * here * squared_angle <= there * there * squared_other_angle ? segment.narrow_apex : other;
}

/// The fraction at which the edge a-b is split if its distance from the centre is a number with few binary digits. In
/// the middle if the edge is so short that distances from the centre do not resolve it.
double fraction_around(Point centre, Point a, Point b) {
  const double at_a = distance(centre, a), at_b = distance(centre, b);
  const double near = std::min(at_a, at_b), far = std::max(at_a, at_b);
  if (far - near < 0x1p-44 * far) return 0.5;
  return (shortest_number((2 * near + far) / 3, (near + 2 * far) / 3) - at_a) / (at_b - at_a);
}

/// A length that is 16 times as long as the shortest edge that doubles allow (Options::min_edge).
double resolution(Point p, Point q, Point r) {
  Box box = Box::around(p, q);
  box.cover(Box::around(r));
  return 0x1p-38 * box.largest_magnitude();
}

/// The fraction at which the edge a-b is split beside the end of a shorter segment, if there is such an end: the one
/// nearest to the middle. Not if an end of the edge is as near to this place as the other segment is, and not if an
/// edge shorter than `floor` would result. But a gap that doubles cannot resolve counts: no point can be inserted
/// there, and the edge stays as it is. Splits elsewhere would make edges down to the resolution of doubles.
std::optional<double> fraction_beside_end(const Triangulation& t, std::span<const PlaceBesideEnd> places, Point a,
                                          Point b, double floor) {
  std::optional<double> best;
  for (const PlaceBesideEnd& place : places) {
    const Point apex = t.points[place.apex];
    if (place.gap < floor && place.gap > resolution(apex, a, b)) continue;
    const double at_a = distance(apex, a), at_b = distance(apex, b);
    const double from_ends = std::min(place.distance - std::min(at_a, at_b), std::max(at_a, at_b) - place.distance);
    if (from_ends <= std::max({place.gap, floor, 2 * shell_width(apex, at_a < at_b ? b : a)})) continue;
    const double fraction = (place.distance - at_a) / (at_b - at_a);
    if (!best || std::abs(fraction - 0.5) < std::abs(*best - 0.5)) best = fraction;
  }
  return best;
}

/// The largest angle that makes an end of an edge an apex, as 1 minus its cosine. It is larger for edges that are much
/// shorter than their segment: these come from a cascade of splits on both sides of a corner.
double widest_apex(double length, double segment_length) {
  constexpr double at_60_degrees = 0.5, at_104_degrees = 1.25;
  return 32 * length < segment_length ? at_104_degrees : at_60_degrees;
}

/// The fraction at which the edge a-b is split if it consists of `count` equal pieces. If the count is odd, the shorter
/// part is at the end that comes first, whatever the direction of the edge.
double fraction_of_pieces(double count, Point a, Point b) {
  const double first = std::floor(count / 2) / count;
  return lexicographically_less(a, b) ? first : 1 - first;
}

/// The point at this fraction of the edge a-b, which is a part of the segment. If rounding moves it too far for
/// something beside the segment, the next place on both sides that rounding moves less.
Point point_at(double fraction, const Triangulation& t, const DomainSegments& segments, Index number, Point a,
               Point b) {
  const Point p{a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y)};
  const Constraint line = segments.line_at(t.points, number, p);
  const Point from = t.points[line.a], to = t.points[line.b];
  const auto on_line = [&](Point q) { return usable_on_edge(projected(q, from, to), a, b, from, to); };
  const Point first = on_line(p);
  if (segments.may_split(t.points, number, {a, b}, first)) return first;
  constexpr int most_places = 32;  // on each side
  const double few_roundings = 0x1p-51 * Box::around(a, b).largest_magnitude() / distance(a, b);
  for (int place = 1; place <= most_places; ++place)
    for (const double shift : {-place * few_roundings, place * few_roundings}) {
      const Point q = on_line({p.x + shift * (b.x - a.x), p.y + shift * (b.y - a.y)});
      if (q != a && q != b && segments.may_split(t.points, number, {a, b}, q)) return q;
    }
  return first;
}

double dot(Point o, Point p, Point q) { return (p.x - o.x) * (q.x - o.x) + (p.y - o.y) * (q.y - o.y); }

/// The tangent of the least angle across a shell: sin θ / (2 - cos θ), where the segments from the apex to `first` and
/// `second` meet at the angle θ. It is the angle of a triangle with a corner on the next shell, twice as far away.
double tangent_across_shell(Point apex, Point first, Point second) {
  const double lengths = distance(apex, first) * distance(apex, second);
  return std::abs(exact::twice_area(apex, first, second)) / (2 * lengths - dot(apex, first, second));
}

/// True if the angle at o between u and v has at least this tangent, up to the rounding of the shell on which u and v
/// lie around the apex. Precondition: the angle is less than 90 degrees.
bool has_tangent(Point o, Point u, Point v, Point apex, double tangent) {
  constexpr double relative = 1e-9;
  Box box = Box::around(apex);
  box.cover(Box::around(u, v));
  const double rounding = 0x1p-51 * box.largest_magnitude() * (distance(o, u) + distance(o, v));
  return std::abs(exact::twice_area(o, u, v)) + rounding >= (1 - relative) * tangent * dot(o, u, v);
}

/// The exemption of the angle at o opposite the edge from u to v, each inside or at the end of the segment that is
/// given, if the two segments meet at an angle with a larger cosine than `least`.
std::optional<SmallAngle> seditious(const Triangulation& t, const DomainSegments& segments, VertexId o, VertexId u,
                                    Index of_u, VertexId v, Index of_v, double least) {
  if (of_u == of_v) return {};
  const VertexId apex = segments.shared_end(of_u, of_v);
  if (apex == no_index || apex == u || apex == v) return {};
  const double cosine = segments.cosine_at(t.points, apex, of_u, of_v);
  if (cosine <= least || !same_shell(t.points[apex], t.points[u], t.points[v])) return {};
  const double least_tangent = tangent_across_shell(t.points[apex], t.points[segments.other_end(of_u, apex)],
                                                    t.points[segments.other_end(of_v, apex)]);
  if (!has_tangent(t.points[o], t.points[u], t.points[v], t.points[apex], least_tangent)) return {};
  return SmallAngle{ExemptReason::seditious, apex, degrees(cosine)};
}

/// The exemption of the angle at this corner.
std::optional<SmallAngle> small_angle_at(unsigned corner, const Triangulation& t, const DomainSegments& segments,
                                         const Slot& slot) {
  const VertexId o = slot.v[corner], u = slot.from(corner), v = slot.to(corner);
  if (slot.n[next_corner[corner]].constrained() && slot.n[previous_corner[corner]].constrained()) {
    const Index first = segments.segment_of(t, o, u), second = segments.segment_of(t, o, v);
    if (first != second && first != no_index && second != no_index)
      return SmallAngle{ExemptReason::nestled, o, degrees(segments.cosine_at(t.points, o, first, second))};
  }
  const Index segment_u = segment_of_origin(t.origin[u]), segment_v = segment_of_origin(t.origin[v]);
  const bool inside_u = segment_u < segments.size(), inside_v = segment_v < segments.size();
  constexpr double at_60_degrees = 0.5 * (1 + 1e-9);
  if (inside_u && inside_v) return seditious(t, segments, o, u, segment_u, v, segment_v, at_60_degrees);
  // A point that was put beside the end of a segment (edge_split_point()).
  const VertexId end = inside_u ? v : u, beside = inside_u ? u : v;
  if (inside_u == inside_v || t.origin[end] != input_vertex) return {};
  for (const Index of_end : segments.segments_at(end))
    if (const auto found =
            seditious(t, segments, o, end, of_end, beside, inside_u ? segment_u : segment_v, cosine_of_narrow_angle))
      return found;
  return {};
}

}  // namespace

Point edge_split_point(const Triangulation& t, const DomainSegments& segments, Index number, VertexId a, VertexId b,
                       double floor, double pieces) {
  const DomainSegment& segment = segments[number];
  const Point pa = t.points[a], pb = t.points[b];
  const double length = distance(pa, pb);
  const double widest = widest_apex(length, distance(t.points[segment.a], t.points[segment.b]));
  const VertexId centre = centre_of_shell(segment, a, b, widest);
  double fraction = 0.5;
  const auto places = segments.places_beside_ends(number);
  if (const std::optional<double> beside = fraction_beside_end(t, places, pa, pb, floor)) {
    fraction = *beside;
  } else if (centre != no_index) {
    fraction = shell(length) / length;
    if (centre == b) fraction = 1 - fraction;
  } else if (segment.narrow_apex != no_index) {
    fraction = fraction_around(t.points[centre_of_wedge(t, segment, pa, pb)], pa, pb);
  } else if (length > 1.5 * pieces) {
    fraction = fraction_of_pieces(std::round(length / pieces), pa, pb);
  }
  return point_at(fraction, t, segments, number, pa, pb);
}

std::vector<Point> other_edge_split_points(const Triangulation& t, const DomainSegments& segments, Index number,
                                           VertexId a, VertexId b) {
  if (lexicographically_less(t.points[b], t.points[a])) std::swap(a, b);
  const auto at = [&](double fraction) { return point_at(fraction, t, segments, number, t.points[a], t.points[b]); };
  return {at(0.375), at(0.625), at(0.3125), at(0.6875)};
}

std::optional<SmallAngle> small_angle(const Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                      const Slot& slot, const Measure& measure) {
  const unsigned smallest = measure.shortest_side();
  // Most triangles: no side is constrained, and an end of the shortest side lies inside a face.
  const bool is_apart =
      t.origin[slot.from(smallest)] == interior_vertex || t.origin[slot.to(smallest)] == interior_vertex;
  if (is_apart && !slot.any_constrained()) return {};
  const std::optional<SmallAngle> found = small_angle_at(smallest, t, segments, slot);
  if (!found) return {};
  for (const unsigned corner : {next_corner[smallest], previous_corner[smallest]}) {
    const Point at = t.points[slot.v[corner]], from = t.points[slot.from(corner)], to = t.points[slot.to(corner)];
    const bool is_small = criteria.is_small(measure.twice_area, at, from, to);
    if (is_small && !small_angle_at(corner, t, segments, slot)) return {};
  }
  return found;
}

}  // namespace pardel::engine
