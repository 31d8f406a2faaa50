#include "conflicts.hpp"

#include <algorithm>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/expansion.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

using exact::Expansion;
using exact::two_difference;

/// The common point of the lines ab and cd is a + (b - a) * above / below, without rounding.
struct ExactCrossing {
  Expansion<2> ux, uy;  ///< b - a
  Expansion<16> above, below;

  ExactCrossing(Point a, Point b, Point c, Point d) : ux(two_difference(b.x, a.x)), uy(two_difference(b.y, a.y)) {
    const Expansion<2> dx(two_difference(d.x, c.x)), dy(two_difference(d.y, c.y));
    const Expansion<2> wx(two_difference(a.x, c.x)), wy(two_difference(a.y, c.y));
    above = dx * wy - dy * wx;
    below = dy * ux - dx * uy;
  }
};

int sign(double x) { return (x > 0) - (x < 0); }

/// The lexicographically smaller end of the common part of two segments on one line.
Point begin_of_overlap(Point a, Point b, Point c, Point d) {
  const auto less = lexicographically_less;
  return std::max(std::min(a, b, less), std::min(c, d, less), less);
}

}  // namespace

Point crossing_point(Point a, Point b, Point c, Point d) {
  const ExactCrossing at(a, b, c, d);  // numerator and denominator are rounded once
  const double below = at.below.estimate();
  return {snapped((at.below * a.x + at.above * at.ux).estimate() / below),
          snapped((at.below * a.y + at.above * at.uy).estimate() / below)};
}

int compare_crossing(Point a, Point b, Point c, Point d, Point p) {
  const ExactCrossing at(a, b, c, d);
  const int sign_below = sign(at.below.estimate());
  const auto compare = [&](double from, double to, const Expansion<2>& u) {
    return sign_below * sign((at.below * Expansion<2>(two_difference(from, to)) + at.above * u).estimate());
  };
  const int by_x = compare(a.x, p.x, at.ux);
  return by_x != 0 ? by_x : compare(a.y, p.y, at.uy);
}

Point place_of(const Conflict& conflict, std::span<const Point> points, std::span<const Segment> segments) {
  if (conflict.kind == ConflictKind::point_on_segment) return points[conflict.first];
  const Segment &s = segments[conflict.first], &t = segments[conflict.second];
  const Point a = points[s.a], b = points[s.b], c = points[t.a], d = points[t.b];
  return conflict.kind == ConflictKind::crossing ? crossing_point(a, b, c, d) : begin_of_overlap(a, b, c, d);
}

}  // namespace pardel::engine
