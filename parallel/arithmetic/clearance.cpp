#include "clearance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "distance.hpp"
#include "predicates.hpp"

namespace pardel::engine {
namespace {

/// The part of the distance to another segment by which a split point may lie off its line. The other segment has the
/// same part, and something is left for the rounding of distance and deviation.
constexpr double share_of_gap = 0.45;

double scalar_product(Point from, Point to, Point other_from, Point other_to) {
  return (to.x - from.x) * (other_to.x - other_from.x) + (to.y - from.y) * (other_to.y - other_from.y);
}

/// True if the two halves of the edge leave the point on the side of the segment on which it is.
bool stays_on_its_side(Point beside, const EndPoints& segment, const EndPoints& edge, Point p) {
  const double side = orient2d(segment.a, segment.b, beside);
  if (scalar_product(edge.a, edge.b, edge.a, beside) <= 0 || scalar_product(edge.b, edge.a, edge.b, beside) <= 0)
    return true;  // not beside this edge
  const bool is_before = scalar_product(edge.a, edge.b, beside, p) > 0;
  const double after = is_before ? orient2d(edge.a, p, beside) : orient2d(p, edge.b, beside);
  return side > 0 ? after > 0 : after < 0;
}

}  // namespace

bool keeps_clear(std::span<const Clearance> all, EndPoints segment, EndPoints edge, Point p) {
  if (all.empty()) return true;
  // One direction, so that all processes round alike.
  if (lexicographically_less(segment.b, segment.a)) std::swap(segment.a, segment.b);
  if (scalar_product(edge.a, edge.b, segment.a, segment.b) < 0) std::swap(edge.a, edge.b);
  const double deviation = std::abs(exact::twice_area(segment.a, segment.b, p)) / distance(segment.a, segment.b);
  return std::ranges::all_of(all, [&](const Clearance& c) {
    return deviation <= share_of_gap * (c.gap + c.slope * distance(c.at, p)) &&
           (!c.is_passed || stays_on_its_side(c.at, segment, edge, p));
  });
}

}  // namespace pardel::engine
