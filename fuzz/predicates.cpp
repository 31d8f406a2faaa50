// The exact predicates and expansions against rational arithmetic (GMP). The bytes make doubles with any sign, exponent
// and mantissa, and points that are degenerate or nearly so by construction: on one line, on one circle, equal, moved
// by a few units in the last place.
#include "../parallel/arithmetic/predicates.hpp"

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <string>

#include "../parallel/arithmetic/expansion.hpp"
#include "../parallel/arithmetic/predicate_stages.hpp"
#include "doubles.hpp"
#include "exact_signs.hpp"
#include "fuzz_one.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

using Rational = mpq_class;

/// The number, or zero if the predicates do not accept it.
double usable(double x) { return engine::is_usable(x) ? x : 0; }

/// A double that is zero or between the bounds of the predicates. `spread` binary orders of magnitude around 2^middle.
double any_double(Supply& bytes, int spread, int middle = 0) {
  const std::uint64_t word = bytes.word();
  const int offset = spread == 0 ? 0 : static_cast<int>((word >> 52) % static_cast<unsigned>(spread)) - spread / 2;
  return usable(with_exponent(word, middle + offset));
}
double small_integer(Supply& bytes) { return static_cast<double>(static_cast<std::int8_t>(bytes.byte())); }

Point any_point(Supply& bytes, int kind) {
  if (kind == 0) {
    const double x = small_integer(bytes);
    return {x, small_integer(bytes)};
  }
  // The last range is that of the predicates, from 2^-140 to 2^200.
  constexpr int spreads[] = {0, 1, 20, 341}, middles[] = {0, 0, 0, 30};
  const double x = any_double(bytes, spreads[kind], middles[kind]);
  return {x, any_double(bytes, spreads[kind], middles[kind])};
}

void nudge(Point& p, Supply& bytes) {
  const int units = bytes.byte();
  p = {usable(moved(p.x, units % 8 - 3)), usable(moved(p.y, units / 8 % 8 - 3))};
}

/// Four points, in a position that the first byte selects.
std::array<Point, 4> any_points(Supply& bytes) {
  const int position = bytes.below(8), kind = bytes.below(4);
  std::array<Point, 4> p{};
  for (Point& each : p) each = any_point(bytes, kind);
  if (position == 1) p[2] = p[0];
  if (position == 2 || position == 3) {  // on a line: a + k (b - a)
    const double k = small_integer(bytes) / 4;
    for (const int i : {2, 3}) p[i] = {p[0].x + k * i * (p[1].x - p[0].x), p[0].y + k * i * (p[1].y - p[0].y)};
  }
  if (position == 4 || position == 5) {  // on a circle: the symmetric images of one vector
    const Point c = p[0], v = p[1];
    p = {Point{c.x + v.x, c.y + v.y}, {c.x - v.y, c.y + v.x}, {c.x - v.x, c.y - v.y}, {c.x + v.y, c.y - v.x}};
  }
  if (position == 6) {  // the corners of a rectangle
    p[2] = {p[1].x, p[0].y};
    p[3] = {p[0].x, p[1].y};
  }
  for (Point& each : p)
    if (!engine::is_usable(each)) each = {usable(each.x), usable(each.y)};
  if (position % 2 == 1 || position == 6) nudge(p[bytes.byte() % 4], bytes);
  return p;
}

std::string text(const std::array<Point, 4>& points) {
  char line[400];
  std::snprintf(line, sizeof line, "(%a, %a) (%a, %a) (%a, %a) (%a, %a)", points[0].x, points[0].y, points[1].x,
                points[1].y, points[2].x, points[2].y, points[3].x, points[3].y);
  return line;
}

void require(bool holds, const char* what, const std::array<Point, 4>& points) {
  if (!holds) fail(std::string(what) + " has the wrong sign at " + text(points));
}

void check_predicates(const std::array<Point, 4>& points) {
  const auto& [a, b, c, d] = points;
  const int turn = true_orientation(a, b, c), in = true_incircle(a, b, c, d);
  require(sign(engine::orient2d(a, b, c)) == turn, "orient2d", points);
  require(sign(engine::exact::orient2d(a, b, c)) == turn, "the exact orient2d", points);
  require(sign(engine::orient2d(c, a, b)) == turn, "orient2d of turned points", points);
  require(sign(engine::orient2d(b, a, c)) == -turn, "orient2d of exchanged points", points);
  require(sign(engine::incircle(a, b, c, d)) == in, "incircle", points);
  require(sign(engine::exact::incircle(a, b, c, d)) == in, "the exact incircle", points);
  require(sign(engine::incircle(b, c, a, d)) == in, "incircle of turned points", points);
  require(sign(engine::incircle(b, a, c, d)) == -in, "incircle of exchanged points", points);
  // The walk around a cavity makes two tests at a time. Each half of a pair must round as a double does.
  using engine::Pair;
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const engine::Orientation<double> first(ax, ay, bx, by), second(bx, by, ax, ay);
  const engine::Orientation<Pair> both(Pair{ax, bx}, Pair{ay, by}, Pair{bx, ax}, Pair{by, ay});
  if (both.determinant[0] != first.determinant || both.determinant[1] != second.determinant ||
      both.error[0] != first.error || both.error[1] != second.error)
    fail("a pair of determinants is not two determinants at " + text(points));
}

template <std::size_t N>
Rational value(const engine::exact::Expansion<N>& e) {
  Rational sum;
  for (std::size_t i = 0; i < e.size(); ++i) sum += e[i];
  return sum;
}

template <std::size_t N>
void require_value(const engine::exact::Expansion<N>& e, const Rational& expected, const char* what) {
  if (value(e) != expected) fail(std::string(what) + " of expansions is not exact");
  if (sign(e.estimate()) != sgn(expected)) fail(std::string(what) + ": the estimate has the wrong sign");
  for (std::size_t i = 0; i < e.size(); ++i)
    if (e[i] == 0 || (i > 0 && std::abs(e[i]) <= std::abs(e[i - 1]))) fail(std::string(what) + " is not well formed");
}

/// Numbers whose products of four neither overflow nor underflow.
void check_expansions(Supply& bytes) {
  namespace exact = engine::exact;
  const int spread = 1 + bytes.below(100);
  std::array<double, 6> x{};
  for (double& each : x) each = any_double(bytes, spread);
  if (bytes.flag(64)) x[3] = -x[0];  // sums cancel
  if (bytes.flag(64)) x[1] = moved(x[0], 1);
  const exact::Expansion<2> e(exact::two_sum(x[0], x[1])), f(exact::two_sum(x[2], x[3])),
      g(exact::two_difference(x[4], x[5]));
  const Rational E = Rational(x[0]) + x[1], F = Rational(x[2]) + x[3], G = Rational(x[4]) - x[5];
  require_value(e, E, "a sum of doubles");
  require_value(g, G, "a difference of doubles");
  require_value(exact::Expansion<2>(exact::two_product(x[0], x[2])), Rational(x[0]) * x[2], "a product of doubles");
  require_value(exact::Expansion<2>(exact::two_product_by_splitting(x[0], x[2])), Rational(x[0]) * x[2],
                "a product by splitting");
  require_value(e + f, E + F, "the sum");
  require_value(e - f, E - F, "the difference");
  require_value(e * x[4], E * x[4], "the multiple");
  require_value(e * f, E * F, "the product");
  require_value((e + f) * g, (E + F) * G, "the product of a sum");
  require_value(e * f - f * g, E * F - F * G, "the difference of products");
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  Supply supply(bytes);
  if (supply.flag(64))
    check_expansions(supply);
  else
    check_predicates(any_points(supply));
  return 0;
}

}  // namespace pardel::fuzz
