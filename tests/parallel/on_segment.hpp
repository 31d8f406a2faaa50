// Whether a rounded point lies on a segment.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../parallel/arithmetic/expansion.hpp"
#include "../../parallel/arithmetic/predicates.hpp"

namespace pardel::engine::samples {

/// The distance from the largest coordinate of a segment's ends to the next larger double; 0 if both are 0.
inline double unit_of(double a, double b) {
  const double largest = std::max(std::abs(a), std::abs(b));
  return largest == 0 ? 0 : std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

/// True if two units in each coordinate are enough to move p onto the line through a and b. Exact.
inline bool is_on_line(Point p, Point a, Point b) {
  using namespace exact;
  const Expansion<2> dx(two_difference(b.x, a.x)), dy(two_difference(b.y, a.y));
  const Expansion<2> ex(two_difference(p.x, a.x)), ey(two_difference(p.y, a.y));
  const auto cross = dx * ey - dy * ex;
  const auto magnitude = [](const Expansion<2>& e) { return e.estimate() < 0 ? -e : e; };
  const auto most = magnitude(dy) * (2 * unit_of(a.x, b.x)) + magnitude(dx) * (2 * unit_of(a.y, b.y));
  return (cross - most).estimate() <= 0 && (cross + most).estimate() >= 0;
}

}  // namespace pardel::engine::samples
