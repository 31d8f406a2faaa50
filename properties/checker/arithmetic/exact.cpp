#include "exact.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "text.hpp"

namespace pardel::checker::exactly {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Gmpq;

Kernel::Point_2 cgal(Point p) { return {p.x, p.y}; }

/// `formula` is a generic function of `number`, which converts a double to the number type in use: intervals first,
/// then rational numbers.
template <class Formula>
bool decide(const Formula& formula) {
  {
    const Interval::Protector round_upward;
    const CGAL::Uncertain<bool> answer = formula([](double x) { return Interval(x); });
    if (CGAL::is_certain(answer)) return CGAL::get_certain(answer);
  }
  return formula([](double x) { return Rational(x); });
}

template <class Formula>
int sign_of(const Formula& formula) {
  {
    const Interval::Protector round_upward;
    const CGAL::Uncertain<CGAL::Sign> answer = CGAL::sign(formula([](double x) { return Interval(x); }));
    if (CGAL::is_certain(answer)) return CGAL::get_certain(answer);
  }
  return CGAL::sign(formula([](double x) { return Rational(x); }));
}

// The formulas, each written once.

template <class Number>
auto squared_length(Point a, Point b, Number number) {
  const auto dx = number(b.x) - number(a.x);
  const auto dy = number(b.y) - number(a.y);
  return decltype(dx + dy)(dx * dx + dy * dy);
}

/// (b - a) . (d - c)
template <class Number>
auto dot(Point a, Point b, Point c, Point d, Number number) {
  const auto x = (number(b.x) - number(a.x)) * (number(d.x) - number(c.x));
  const auto y = (number(b.y) - number(a.y)) * (number(d.y) - number(c.y));
  return decltype(x + y)(x + y);
}

/// Twice the signed area of a, b, c.
template <class Number>
auto doubled_area(Point a, Point b, Point c, Number number) {
  const auto left = (number(b.x) - number(a.x)) * (number(c.y) - number(a.y));
  const auto right = (number(b.y) - number(a.y)) * (number(c.x) - number(a.x));
  return decltype(left - right)(left - right);
}

Rational rational(double x) { return Rational(x); }

std::string text(const Rational& value) {
  std::ostringstream out;
  out << value.numerator();
  if (value.denominator() != 1) out << '/' << value.denominator();
  std::string fraction = out.str();
  constexpr std::size_t readable = 40;
  if (fraction.size() <= readable) return fraction;
  const double rounded = CGAL::to_double(value);
  if (rounded != 0) return to_text(rounded) + " (rounded)";
  return CGAL::sign(value) > 0 ? "a positive number below the least double" : "a negative number above the greatest";
}

}  // namespace

int orientation(Point a, Point b, Point c) { return CGAL::orientation(cgal(a), cgal(b), cgal(c)); }

int in_circle(Point a, Point b, Point c, Point d) {
  return CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d));
}

bool cosine_exceeds(Point corner, Point a, Point b, double bound) {
  return decide([=](auto number) {
    const auto product = dot(corner, a, corner, b, number);
    const auto c = number(bound);
    const auto limit = c * c * squared_length(corner, a, number) * squared_length(corner, b, number);
    // Both sides are squared. The left side is product * |product|, which stays negative for an obtuse angle.
    return product * CGAL::abs(product) > limit;
  });
}

bool area_exceeds(Point a, Point b, Point c, double bound) {
  return decide([=](auto number) { return doubled_area(a, b, c, number) > number(2) * number(bound); });
}

bool length_exceeds(Point a, Point b, double bound) {
  return decide([=](auto number) { return squared_length(a, b, number) > number(bound) * number(bound); });
}

int compare_lengths(Point a, Point b, Point c, Point d) {
  return sign_of([=](auto number) { return squared_length(a, b, number) - squared_length(c, d, number); });
}

bool distances_differ(Point c, Point p, Point q, double relative, double absolute) {
  const bool p_is_nearer = compare_lengths(c, p, c, q) < 0;
  const Point near = p_is_nearer ? p : q, far = p_is_nearer ? q : p;
  // (1 - relative) |far| > |near| + absolute. Both sides are squared, and then both sides of
  // rest > 2 absolute |near|, where the rest may be negative.
  return decide([=](auto number) {
    const auto kept = number(1) - number(relative);
    const auto squared_near = squared_length(c, near, number);
    const auto squared_absolute = number(absolute) * number(absolute);
    const auto rest = kept * kept * squared_length(c, far, number) - squared_near - squared_absolute;
    return rest * CGAL::abs(rest) > number(4) * squared_absolute * squared_near;
  });
}

bool circumradius_exceeds(Point a, Point b, Point c, double bound) {
  // R = |ab| |bc| |ca| / (2 D), where D is twice the area.
  return decide([=](auto number) {
    const auto product = squared_length(a, b, number) * squared_length(b, c, number) * squared_length(c, a, number);
    const auto limit = number(2) * number(bound) * doubled_area(a, b, c, number);
    return product > limit * limit;
  });
}

bool line_offset_exceeds(Point p, Point a, Point b, Units units) {
  return decide([=](auto number) {
    const auto cross = doubled_area(a, b, p, number);
    const auto dx = number(b.x) - number(a.x), dy = number(b.y) - number(a.y);
    return CGAL::abs(cross) > number(units.x) * CGAL::abs(dy) + number(units.y) * CGAL::abs(dx);
  });
}

double tangent_across_shell(Point apex, Point p, Point q) {
  const double extent = std::max({std::abs(p.x - apex.x), std::abs(p.y - apex.y), std::abs(q.x - apex.x),
                                  std::abs(q.y - apex.y), std::numeric_limits<double>::min()});
  // All quadratic terms are scaled alike, so that none overflows.
  const auto scale = rational(std::ldexp(1.0, -std::ilogb(extent)));
  const auto scaled = [&](const auto& term) { return CGAL::to_double(term * scale * scale); };
  const double cross = std::abs(scaled(doubled_area(apex, p, q, rational)));
  const double product = scaled(dot(apex, p, apex, q, rational));
  const double lengths =
      std::sqrt(scaled(squared_length(apex, p, rational))) * std::sqrt(scaled(squared_length(apex, q, rational)));
  const double tangent = cross / (2 * lengths - product);
  return std::isfinite(tangent) ? tangent : std::numeric_limits<double>::max();  // excuses nothing
}

bool tangent_is_below(Point corner, Point p, Point q, double bound, double error) {
  return decide([=](auto number) {
    const auto sum = [&](Point end) {
      const auto dx = number(end.x) - number(corner.x), dy = number(end.y) - number(corner.y);
      return decltype(dx + dy)(CGAL::abs(dx) + CGAL::abs(dy));
    };
    const auto cross = doubled_area(corner, p, q, number);
    return CGAL::abs(cross) + number(error) * (sum(p) + sum(q)) < number(bound) * dot(corner, p, corner, q, number);
  });
}

int progress(Point from, Point to, Point a, Point b) {
  return sign_of([=](auto number) { return dot(from, to, a, b, number); });
}

std::string orientation_text(Point a, Point b, Point c) { return text(doubled_area(a, b, c, rational)); }

std::string in_circle_text(Point a, Point b, Point c, Point d) {
  const auto lift = [d](Point p) { return squared_length(d, p, rational); };
  return text(lift(a) * doubled_area(d, b, c, rational) + lift(b) * doubled_area(d, c, a, rational) +
              lift(c) * doubled_area(d, a, b, rational));
}

std::string squared_cosine_text(Point corner, Point a, Point b) {
  const Rational product = dot(corner, a, corner, b, rational);
  const Rational lengths = squared_length(corner, a, rational) * squared_length(corner, b, rational);
  return lengths == 0 ? "undefined" : text(product * product / lengths);
}

std::string area_text(Point a, Point b, Point c) { return text(doubled_area(a, b, c, rational) / Rational(2)); }

std::string squared_length_text(Point a, Point b) { return text(squared_length(a, b, rational)); }

std::string squared_circumradius_text(Point a, Point b, Point c) {
  const Rational area = doubled_area(a, b, c, rational);
  if (area == 0) return "infinite";
  return text(squared_length(a, b, rational) * squared_length(b, c, rational) * squared_length(c, a, rational) /
              (Rational(4) * area * area));
}

std::string squared_line_distance_text(Point p, Point a, Point b) {
  const Rational cross = doubled_area(a, b, p, rational);
  const Rational length = squared_length(a, b, rational);
  return length == 0 ? "undefined" : text(cross * cross / length);
}

}  // namespace pardel::checker::exactly
