#include "radius_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "refinement.hpp"

namespace pardel::ref {
namespace {

/// A double that is at least the square root of x.
double root_from_above(const Number& x) {
  return std::nextafter(std::sqrt(CGAL::to_interval(x).second), std::numeric_limits<double>::infinity());
}

/// sin² of the angle at `apex`; 1 for angles of 90 degrees and more.
Number squared_sine_of_corner(const ExactPoint& apex, const ExactPoint& p, const ExactPoint& q) {
  const Kernel::Vector_2 u = p - apex, v = q - apex;
  const Number dot = u * v;
  return dot > 0 ? 1 - dot * dot / (u.squared_length() * v.squared_length()) : Number(1);
}

/// The factor that two segments cause, squared.
Number squared_growth_between(const Pslg& pslg, const Segment& s, const Segment& t, const Number& squared_start) {
  const auto at = [&](Index v) { return exact(pslg.points[v]); };
  for (const auto& [apex, p] : {Edge{s.a, s.b}, Edge{s.b, s.a}})
    for (const auto& [other, q] : {Edge{t.a, t.b}, Edge{t.b, t.a}})
      if (apex == other) return 1 / squared_sine_of_corner(at(apex), at(p), at(q));
  const Kernel::Segment_2 one(at(s.a), at(s.b)), two(at(t.a), at(t.b));
  const Number ratio = squared_start / CGAL::squared_distance(one, two);  // (r0 / λ)²
  return ratio > 1 ? (ratio + 2 + 1 / ratio) / 4 : Number(1);
}

}  // namespace

Result<Number> squared_radius_bound(const Goal& goal, RadiusTheorem theorem) {
  const double inverse = inverse_squared_ratio(goal);
  if (!(inverse > 0) || !std::isfinite(goal.max_area))
    return Error{ErrorKind::usage, "Theorem T3 needs a bound on angles and a bound on areas."};
  const Number ratio = 1 / Number(inverse), area = goal.max_area;  // ρ̄² and Δ̄
  const Number cube = ratio * ratio * ratio * area * area;
  const Number fourth_power = theorem == RadiusTheorem::t3 ? 16 * cube : 16 * ratio * cube / (4 * ratio - 1);
  return Number(root_from_above(fourth_power));
}

Number squared_growth_bound(const Pslg& pslg, const Number& squared_bound) {
  Number growth = 1;
  for (std::size_t i = 1; i < pslg.segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      growth = std::max(growth, squared_growth_between(pslg, pslg.segments[i], pslg.segments[j], squared_bound));
  return growth;
}

}  // namespace pardel::ref
