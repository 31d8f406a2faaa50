#include "points.hpp"

#include <cmath>
#include <numbers>

#include "../../parallel/arithmetic/predicates.hpp"
#include "../doubles.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;

double usable(double x) { return engine::is_usable(x) ? x : 0; }

/// A double with a random sign and mantissa. Its exponent is random, too, among `spread` numbers.
double any_double(Random& random, int spread) {
  const std::uint64_t word = random.next();
  return usable(with_exponent(word, static_cast<int>(random.below(static_cast<std::size_t>(spread))) - spread / 2));
}

Point any_point(Random& random, int kind) {
  const auto coordinate = [&]() -> double {
    switch (kind) {
      case 0:
        return random.uniform(-1, 1);
      case 1:
        return random.between(-1'000, 1'000);
      case 2:
        return any_double(random, 20);
      default:
        return any_double(random, 300);
    }
  };
  const double x = coordinate();
  return {x, coordinate()};
}

void nudge(Point& p, Random& random) {
  p = {usable(moved(p.x, random.between(-3, 3))), usable(moved(p.y, random.between(-3, 3)))};
}

/// a + k (b - a), rounded.
Point along(Point a, Point b, double k) { return {a.x + k * (b.x - a.x), a.y + k * (b.y - a.y)}; }

FourPoints on_line(Random& random, int kind) {
  const Point a = any_point(random, kind), b = any_point(random, kind);
  const auto share = [&] { return random.chance(2) ? random.between(-8, 8) / 4.0 : random.uniform(-2, 3); };
  const double first = share();
  return {a, b, along(a, b, first), along(a, b, share())};
}

/// Images of one vector under turns by 90 degrees: exactly on a circle, up to the rounding of sums.
FourPoints on_circle(Random& random, int kind) {
  const Point c = any_point(random, kind), v = any_point(random, kind);
  FourPoints p{Point{c.x + v.x, c.y + v.y}, {c.x - v.y, c.y + v.x}, {c.x - v.x, c.y - v.y}, {c.x + v.y, c.y - v.x}};
  if (random.chance(2)) p[3] = {c.x + v.x, c.y - v.y};
  return p;
}

/// Four points of a circle, all of them rounded.
FourPoints near_circle(Random& random) {
  const Point c = any_point(random, 0);
  const double radius = std::ldexp(random.uniform(1, 2), random.between(-30, 3));
  FourPoints p{};
  for (Point& each : p) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    each = {c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)};
  }
  return p;
}

FourPoints rectangle(Random& random, int kind) {
  const Point a = any_point(random, kind), b = any_point(random, kind);
  return {a, {b.x, a.y}, b, {a.x, b.y}};
}

/// A small figure on a lattice, far from the origin.
FourPoints far_lattice(Random& random) {
  const int side = random.chance(2) ? 4 : 1'000, exponent = random.between(-60, 20);
  const double far = std::ldexp(1.0, random.between(0, 40));
  FourPoints p{};
  for (Point& each : p)
    each = {std::ldexp(far + random.between(0, side), exponent),
            std::ldexp(far / 2 + random.between(0, side), exponent)};
  return p;
}

}  // namespace

FourPoints random_points(Random& random) {
  const int kind = static_cast<int>(random.below(4));
  FourPoints p{};
  for (Point& each : p) each = any_point(random, kind);
  return p;
}

FourPoints hard_points(Random& random) {
  const int kind = static_cast<int>(random.below(4));
  FourPoints p{};
  switch (random.below(8)) {
    case 0:
    case 1:
      p = on_line(random, kind);
      break;
    case 2:
    case 3:
      p = on_circle(random, kind);
      break;
    case 4:
      p = near_circle(random);
      break;
    case 5:
      p = rectangle(random, kind);
      break;
    case 6:
      p = far_lattice(random);
      break;
    default:
      p = random_points(random);
      p[random.below(4)] = p[random.below(4)];
  }
  for (Point& each : p) each = {usable(each.x), usable(each.y)};
  if (random.chance(2)) nudge(p[random.below(4)], random);
  if (random.chance(8)) nudge(p[random.below(4)], random);
  if (random.chance(4)) random.chance(2) ? std::swap(p[0], p[3]) : std::swap(p[1], p[2]);
  return p;
}

}  // namespace pardel::fuzz
