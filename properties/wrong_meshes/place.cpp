#include "place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pardel::wrong_meshes {

using generators::Random;

Point Place::at(double x, double y) const {
  if (mirrored) x = -x;
  if (swapped) std::swap(x, y);
  return {std::ldexp(x + right, exponent), std::ldexp(y + up, exponent)};
}

double Place::length(double of_lattice) const { return std::ldexp(of_lattice, exponent); }

Place some_place(Random& random, int farthest) {
  Place place;
  place.exponent = random.between(-120, 150);
  place.mirrored = random.chance(2);
  place.swapped = random.chance(2);
  const auto shift = [&] {
    const double sign = random.chance(2) ? 1 : -1;
    if (random.chance(2)) return sign * double(65 + random.below(60));
    const int magnitude = random.between(7, farthest - 1);
    return sign * (std::ldexp(1.0, magnitude) + double(random.below(60)));
  };
  place.right = shift();
  place.up = shift();
  return place;
}

double some_magnitude(Random& random, double least, double greatest) {
  return least * std::pow(greatest / least, random.uniform());
}

double spacing(double x) {
  x = std::abs(x);
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

namespace {

struct Spacings {
  double x, y;
};
Spacings of_segment(Point a, Point b) {
  return {spacing(std::max(std::abs(a.x), std::abs(b.x))), spacing(std::max(std::abs(a.y), std::abs(b.y)))};
}

/// Twice the signed area of a, b, p divided by what one unit in each coordinate changes in it.
long double signed_distance(Point p, Point a, Point b) {
  using Long = long double;
  const auto [x, y] = of_segment(a, b);
  const Long dx = Long(b.x) - a.x, dy = Long(b.y) - a.y;
  return (dx * (Long(p.y) - a.y) - dy * (Long(p.x) - a.x)) / (x * std::abs(dy) + y * std::abs(dx));
}

/// The best of the points p + (i ux, j uy). Best is the least of cost(distance in units), if that is not infinite.
template <class Cost>
Point best_near(Point p, Point a, Point b, const Cost& cost) {
  constexpr int reach = 20;
  const auto [x, y] = of_segment(a, b);
  Point best = p;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const Point q{p.x + i * x, p.y + j * y};
      const double c = cost(static_cast<double>(signed_distance(q, a, b))) + 1e-3 * (std::abs(i) + std::abs(j));
      if (!(c < least)) continue;
      least = c;
      best = q;
    }
  return best;
}

}  // namespace

double distance_in_units(Point p, Point a, Point b) { return static_cast<double>(std::abs(signed_distance(p, a, b))); }

Point off_by_units(Point p, Point a, Point b, double units, int side) {
  return best_near(p, a, b,
                   [&](double d) { return side * d < units ? std::numeric_limits<double>::infinity() : std::abs(d); });
}

Point within_two_units(Point p, Point a, Point b, int side) {
  const double most = a.x == b.x || a.y == b.y ? 2 : 1.999;
  return best_near(p, a, b, [&](double d) {
    return side * d > most || side * d < 0 ? std::numeric_limits<double>::infinity() : 2 - std::abs(d);
  });
}

Point off_by(Point p, Point a, Point b, double distance, int side) {
  const double dx = b.x - a.x, dy = b.y - a.y, by = side * distance / std::hypot(dx, dy);
  return {p.x - by * dy, p.y + by * dx};
}

Point between(Point a, Point b, double share) {
  const Point near{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  if (distance_in_units(near, a, b) < 1.5) return near;
  return best_near(near, a, b, [](double d) { return std::abs(d); });
}

}  // namespace pardel::wrong_meshes
