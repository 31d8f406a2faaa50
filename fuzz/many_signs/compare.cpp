#include "compare.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../../parallel/arithmetic/predicate_stages.hpp"
#include "../../properties/checker/arithmetic/exact.hpp"
#include "../../properties/checker/arithmetic/filter.hpp"
#include "../doubles.hpp"
#include "../exact_signs.hpp"
#include "certified.hpp"

namespace pardel::fuzz {
namespace {

using engine::Pair;

int exact_orientation(Point a, Point b, Point c, Comparison& result) {
  std::optional<int> certain = certain_orientation(a, b, c);
  if (!certain) ++result.exact;
  const int turn = certain ? *certain : true_orientation(a, b, c);
  if (turn == 0) ++result.zeros;
  return turn;
}

int exact_incircle(Point a, Point b, Point c, Point d, Comparison& result) {
  std::optional<int> certain = certain_incircle(a, b, c, d);
  if (!certain) ++result.exact;
  const int in = certain ? *certain : true_incircle(a, b, c, d);
  if (in == 0) ++result.zeros;
  return in;
}

class Comparing {
 public:
  Comparing(const FourPoints& points, Comparison& result) : p_(points), result_(result) {}

  void orientation(int found, int expected, const char* what) {
    ++result_.orientations;
    require(found == expected, what);
  }
  void incircle(int found, int expected, const char* what) {
    ++result_.incircles;
    require(found == expected, what);
  }
  void filter(bool says_yes, bool is_right, const char* what) {
    if (!says_yes) return;
    ++result_.filters;
    require(is_right, what);
  }

 private:
  void require(bool holds, const char* what) {
    if (holds) return;
    if (++result_.differences > 1) return;
    char text[500];
    std::snprintf(text, sizeof text, "%s at (%a, %a) (%a, %a) (%a, %a) (%a, %a)", what, p_[0].x, p_[0].y, p_[1].x,
                  p_[1].y, p_[2].x, p_[2].y, p_[3].x, p_[3].y);
    result_.first_difference = text;
  }

  const FourPoints& p_;
  Comparison& result_;
};

/// The determinants as the walk around a cavity computes them, two at a time.
void compare_pairs(const FourPoints& points, int turn, int in, Comparing& comparing) {
  const auto& [a, b, c, d] = points;
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const engine::Orientation<Pair> turns(Pair{ax, bx}, Pair{ay, by}, Pair{bx, ax}, Pair{by, ay});
  if (turns.is_certain()) {
    comparing.orientation(sign(turns.determinant[0]), turn, "the first of two orientations");
    comparing.orientation(sign(turns.determinant[1]), -turn, "the second of two orientations");
  }
  const double px = a.x - d.x, py = a.y - d.y, qx = b.x - d.x, qy = b.y - d.y, rx = c.x - d.x, ry = c.y - d.y;
  const double p2 = px * px + py * py, q2 = qx * qx + qy * qy;
  const engine::InCircle<Pair> both(Pair{qx, px}, Pair{qy, py}, Pair{px, qx}, Pair{py, qy}, Pair{rx, rx}, Pair{ry, ry},
                                    Pair{q2, p2}, Pair{p2, q2});
  if (both.is_certain()) {
    comparing.incircle(sign(both.determinant[0]), in, "the first of two in-circle tests");
    comparing.incircle(sign(both.determinant[1]), -in, "the second of two in-circle tests");
  }
}

using Rational = mpq_class;

Rational squared_length(Point a, Point b) {
  const Rational x = Rational(b.x) - a.x, y = Rational(b.y) - a.y;
  return x * x + y * y;
}

/// The filters of the checker on a counter-clockwise triangle, with bounds near the values of the triangle.
void compare_filters(Point a, Point b, Point c, Point d, int in, Comparing& comparing) {
  namespace filter = checker::filter;
  const filter::Shape shape(a, b, c);
  if (!shape.is_tame()) return;
  const Point corners[]{a, b, c};
  for (int k = 0; k < 3; ++k)
    comparing.filter(filter::is_outside_circle(shape, k, corners[(k + 1) % 3], corners[(k + 2) % 3], d), in < 0,
                     "the checker's filter for circles");
  // The bounds are the rounded values, moved by up to a few rounding errors, so that the filters have to be careful.
  const Rational doubled =
      (Rational(b.x) - a.x) * (Rational(c.y) - a.y) - (Rational(b.y) - a.y) * (Rational(c.x) - a.x);
  const Rational sides[]{squared_length(b, c), squared_length(c, a), squared_length(a, b)};
  const Rational& longest = std::max({sides[0], sides[1], sides[2]});
  for (const double units : {-8.0, -2.0, 0.0, 2.0, 8.0, 64.0}) {
    const double factor = 1 + units * 0x1p-53;
    const double area = shape.doubled_area / 2 * factor, length = std::sqrt(shape.longest) * factor;
    comparing.filter(filter::is_not_larger(shape, area), doubled <= 2 * Rational(area),
                     "the checker's filter for areas");
    comparing.filter(filter::is_not_longer(shape, length), longest <= Rational(length) * length,
                     "the checker's filter for lengths");
    const double radius =
        std::sqrt(shape.squared[0] * shape.squared[1] * shape.squared[2]) / (2 * shape.doubled_area) * factor;
    const Rational bound = 2 * Rational(radius) * doubled;
    comparing.filter(filter::has_no_larger_circumradius(shape, radius), sides[0] * sides[1] * sides[2] <= bound * bound,
                     "the checker's filter for circumradii");
    // The cosine of the smallest angle, which the largest dot product belongs to.
    const auto k = static_cast<std::size_t>(std::ranges::max_element(shape.dot) - shape.dot.begin());
    const double cosine = shape.dot[k] / std::sqrt(shape.squared[(k + 1) % 3] * shape.squared[(k + 2) % 3]) * factor;
    if (!(cosine >= 0 && cosine < 1)) continue;
    bool exceeds = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational &left = sides[(i + 1) % 3], &right = sides[(i + 2) % 3], dot = (left + right - sides[i]) / 2;
      exceeds = exceeds || (dot > 0 && dot * dot > Rational(cosine) * cosine * left * right);
    }
    comparing.filter(filter::has_no_angle_below(shape, filter::cotangent_below(cosine)), !exceeds,
                     "the checker's filter for angles");
  }
}

}  // namespace

void Comparison::add(const Comparison& other) {
  orientations += other.orientations;
  incircles += other.incircles;
  filters += other.filters;
  zeros += other.zeros;
  exact += other.exact;
  for (std::size_t i = 0; i < orient2d_stages.size(); ++i) {
    orient2d_stages[i] += other.orient2d_stages[i];
    incircle_stages[i] += other.incircle_stages[i];
  }
  if (differences == 0) first_difference = other.first_difference;
  differences += other.differences;
}

void compare(const FourPoints& points, Comparison& result, const Predicates& predicates) {
  const auto& [a, b, c, d] = points;
  Comparing comparing(points, result);
  comparing.orientation(sign(predicates.orient2d(a, b, c)), exact_orientation(a, b, c, result), "orient2d");
  comparing.incircle(sign(predicates.incircle(a, b, c, d)), exact_incircle(a, b, c, d, result), "incircle");
}

void compare_all(const FourPoints& points, Comparison& result, const Predicates& predicates) {
  namespace exact = engine::exact;
  const auto& [a, b, c, d] = points;
  const int turn = exact_orientation(a, b, c, result), in = exact_incircle(a, b, c, d, result);
  Comparing comparing(points, result);
  comparing.orientation(sign(predicates.orient2d(a, b, c)), turn, "orient2d");
  comparing.orientation(sign(predicates.orient2d(b, a, c)), -turn, "orient2d of exchanged points");
  const exact::Decision turn_stage = exact::decide_orient2d(c, a, b), in_stage = exact::decide_incircle(b, c, a, d);
  comparing.orientation(sign(turn_stage.value), turn, "the exact orient2d of turned points");
  comparing.incircle(sign(predicates.incircle(a, b, c, d)), in, "incircle");
  comparing.incircle(sign(predicates.incircle(b, a, c, d)), -in, "incircle of exchanged points");
  comparing.incircle(sign(in_stage.value), in, "the exact incircle of turned points");
  ++result.orient2d_stages[static_cast<std::size_t>(turn_stage.stage)];
  ++result.incircle_stages[static_cast<std::size_t>(in_stage.stage)];
  compare_pairs(points, turn, in, comparing);
  comparing.orientation(checker::exactly::orientation(a, b, c), turn, "the orientation of the checker");
  if (turn == 0) return;
  const Point second = turn > 0 ? b : c, third = turn > 0 ? c : b;
  comparing.incircle(checker::exactly::in_circle(a, second, third, d), in * turn, "the in-circle test of the checker");
  compare_filters(a, second, third, d, in * turn, comparing);
}

}  // namespace pardel::fuzz
