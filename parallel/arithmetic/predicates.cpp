// The exact part of the predicates. The error bounds are from Shewchuk 1997, with epsilon = 2^-53.
#include "predicates.hpp"

#include <algorithm>
#include <initializer_list>

#include "expansion.hpp"
#include "predicate_stages.hpp"

namespace pardel::engine::exact {
namespace {

constexpr double epsilon = 0x1p-53;
constexpr double estimate_bound = (3 + 8 * epsilon) * epsilon;
constexpr double orient2d_bound_b = (2 + 12 * epsilon) * epsilon;
constexpr double orient2d_bound_c = (9 + 64 * epsilon) * epsilon * epsilon;
constexpr double incircle_bound_b = (4 + 48 * epsilon) * epsilon;
constexpr double incircle_bound_c = (44 + 576 * epsilon) * epsilon * epsilon;

/// The exact difference of two points: rounded coordinates (head) and rounding errors (tail).
struct Difference {
  Two x, y;

  Difference(Point p, Point origin) : x(two_difference(p.x, origin.x)), y(two_difference(p.y, origin.y)) {}
  [[nodiscard]] bool exact() const { return x.tail == 0 && y.tail == 0; }
  [[nodiscard]] double square() const { return x.head * x.head + y.head * y.head; }
};

/// p.x * q.y - p.y * q.x, computed exactly from the heads.
Expansion<4> cross_of_heads(const Difference& p, const Difference& q) {
  return Expansion<2>(two_product(p.x.head, q.y.head)) - Expansion<2>(two_product(p.y.head, q.x.head));
}

/// p.x * q.y - p.y * q.x, computed from the heads with rounding.
double rounded_cross(const Difference& p, const Difference& q) { return p.x.head * q.y.head - p.y.head * q.x.head; }
double magnitude_of_cross(const Difference& p, const Difference& q) {
  return std::abs(p.x.head * q.y.head) + std::abs(p.y.head * q.x.head);
}
/// The first-order change of the cross product that the tails cause.
double correction_of_cross(const Difference& p, const Difference& q) {
  return (p.x.head * q.y.tail + q.y.head * p.x.tail) - (p.y.head * q.x.tail + q.x.head * p.y.tail);
}

Expansion<16> cross(const Difference& p, const Difference& q) {
  return Expansion<2>(p.x) * Expansion<2>(q.y) - Expansion<2>(p.y) * Expansion<2>(q.x);
}
Expansion<16> square(const Difference& p) {
  const Expansion<2> x(p.x), y(p.y);
  return x * x + y * y;
}

/// x^2 e + y^2 e with the heads x, y of p. Scaling e twice by each coordinate is cheaper than a product of expansions.
Expansion<32> lifted_by_heads(const Expansion<4>& e, const Difference& p) {
  return e * p.x.head * p.x.head + e * p.y.head * p.y.head;
}

/// True if all heads are multiples of a power of two u and at most 2^12 u. Then their squares, their products and sums
/// of two of these are at most 2^25 u^2, and the determinant of incircle is at most 3 * 2^50 u^4, so every intermediate
/// result is exactly a double. Adding and subtracting 2^41 times the largest head rounds a number to a multiple of such
/// a unit; a number that this does not change is a multiple.
bool on_small_lattice(const Difference& a, const Difference& b, const Difference& c) {
  const std::initializer_list<double> heads = {a.x.head, a.y.head, b.x.head, b.y.head, c.x.head, c.y.head};
  double largest = 0;
  for (const double head : heads) largest = std::max(largest, std::abs(head));
  const double shift = 0x1p41 * largest;
  bool survives = true;
  for (const double head : heads) survives &= (head + shift) - shift == head;
  return survives;
}

Decision incircle_by_expansions(const Difference& a, const Difference& b, const Difference& c) {
  const auto determinant = square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b);
  return {determinant.estimate(), Stage::expansions};
}

}  // namespace

Decision decide_orient2d(Point a, Point b, Point c) {
  const Difference p(a, c), q(b, c);
  const Expansion<4> of_heads = cross_of_heads(p, q);
  double value = of_heads.estimate();
  if (p.exact() && q.exact()) return {value, Stage::exact_differences};

  const double magnitude = magnitude_of_cross(p, q);
  if (std::abs(value) > orient2d_bound_b * magnitude) return {value, Stage::rounded_differences};

  const double uncertainty = orient2d_bound_c * magnitude + estimate_bound * std::abs(value);
  value += correction_of_cross(p, q);
  if (std::abs(value) > uncertainty) return {value, Stage::corrected};

  return {cross(p, q).estimate(), Stage::expansions};
}

Decision decide_incircle(Point a, Point b, Point c, Point d) {
  const Difference p(a, d), q(b, d), r(c, d);
  const bool exact = p.exact() && q.exact() && r.exact();
  const double qr = rounded_cross(q, r), rp = rounded_cross(r, p), pq = rounded_cross(p, q);
  if (exact && on_small_lattice(p, q, r)) return {p.square() * qr + q.square() * rp + r.square() * pq, Stage::lattice};

  const Expansion<96> of_heads = lifted_by_heads(cross_of_heads(q, r), p) + lifted_by_heads(cross_of_heads(r, p), q) +
                                 lifted_by_heads(cross_of_heads(p, q), r);
  double value = of_heads.estimate();
  if (exact) return {value, Stage::exact_differences};

  const double magnitude = magnitude_of_cross(q, r) * p.square() + magnitude_of_cross(r, p) * q.square() +
                           magnitude_of_cross(p, q) * r.square();
  if (std::abs(value) > incircle_bound_b * magnitude) return {value, Stage::rounded_differences};

  const double uncertainty = incircle_bound_c * magnitude + estimate_bound * std::abs(value);
  const auto correction = [](const Difference& u, double vw, const Difference& v, const Difference& w) {
    return u.square() * correction_of_cross(v, w) + 2 * (u.x.head * u.x.tail + u.y.head * u.y.tail) * vw;
  };
  value += correction(p, qr, q, r) + correction(q, rp, r, p) + correction(r, pq, p, q);
  if (std::abs(value) > uncertainty) return {value, Stage::corrected};

  return incircle_by_expansions(p, q, r);
}

double orient2d(Point a, Point b, Point c) { return decide_orient2d(a, b, c).value; }
double incircle(Point a, Point b, Point c, Point d) { return decide_incircle(a, b, c, d).value; }

double twice_area(Point a, Point b, Point c) {
  const Difference p(b, a), q(c, a);
  return p.exact() && q.exact() ? cross_of_heads(p, q).estimate() : cross(p, q).estimate();
}

}  // namespace pardel::engine::exact
