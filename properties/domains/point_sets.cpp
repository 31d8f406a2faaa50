// Random points without segments, evenly spread or concentrated. Only + - * / and square roots compute coordinates, so
// they are the same on every platform.
#include <array>
#include <cmath>

#include "domains.hpp"
#include "generators/random.hpp"

namespace pardel::domains {
namespace {

using generators::Random;

/// A number in [0, 1), a multiple of 2^-40.
double coordinate(Random& random) { return static_cast<double>(random.next() >> 24) * 0x1p-40; }

/// The next lower multiple of 2^-40.
double rounded(double x) { return std::floor(x * 0x1p40) * 0x1p-40; }

/// n points, each made by draw(random) and rounded.
template <class Draw>
Pslg points_of(std::uint64_t n, std::uint64_t seed, const Draw& draw) {
  Pslg pslg;
  pslg.points.reserve(n);
  Random random(seed);
  for (std::uint64_t i = 0; i < n; ++i) {
    const Point p = draw(random);
    pslg.points.push_back({rounded(p.x), rounded(p.y)});
  }
  return pslg;
}

Point in_unit_square(Random& random) {
  const double x = coordinate(random);
  return {x, coordinate(random)};
}

/// A random direction: a point in the unit disk, but not close to its centre, divided by its length.
Point direction(Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double squared = x * x + y * y;
    if (squared > 1 || squared < 1e-4) continue;
    const double length = std::sqrt(squared);
    return {x / length, y / length};
  }
}

/// A sum of uniform numbers, nearly normally distributed, with variance 1/3.
double bell(Random& random) {
  double sum = -2;
  for (int i = 0; i < 4; ++i) sum += random.uniform();
  return sum;
}

}  // namespace

Pslg random_points(std::uint64_t n, std::uint64_t seed) { return points_of(n, seed, in_unit_square); }

Pslg kuzmin_points(std::uint64_t n, std::uint64_t seed) {
  return points_of(n, seed, [](Random& random) {
    // The share of points within r of the centre is 1 - 1 / sqrt(1 + r^2).
    const double beyond = 1 - random.uniform();
    const double r = std::sqrt(1 / (beyond * beyond) - 1);
    const Point towards = direction(random);
    return Point{r * towards.x, r * towards.y};
  });
}

Pslg line_points(std::uint64_t n, std::uint64_t seed) {
  return points_of(n, seed, [](Random& random) {
    constexpr double b = 0.001;
    const double x = random.uniform(), v = random.uniform();
    return Point{x, b / (v - b * v + b)};
  });
}

Pslg clustered_points(std::uint64_t n, std::uint64_t seed) {
  constexpr int clusters = 100;
  struct Cluster {
    Point centre;
    double radius;
  };
  std::array<Cluster, clusters> all;
  Random random(seed ^ 0xc1u);
  for (Cluster& cluster : all) {
    cluster.centre = in_unit_square(random);
    cluster.radius = 0x1p-5;
    for (int halvings = random.between(0, 10); halvings > 0; --halvings) cluster.radius /= 2;
  }
  return points_of(n, seed, [&all](Random& draw) {
    const auto& [centre, radius] = all[draw.below(all.size())];
    const double x = centre.x + radius * bell(draw);
    return Point{x, centre.y + radius * bell(draw)};
  });
}

}  // namespace pardel::domains
