#include <cstddef>
#include <cstdint>
#include <vector>

#include "domains.hpp"
#include "generators/random.hpp"
#include "paths.hpp"

namespace pardel::domains {
namespace {

/// A random function on a circle, with values in (-1, 1), at n places at equal distances: a sum of polylines. Each has
/// twice as many corners as the one before, and half its height.
std::vector<double> rough_function(std::size_t n, generators::Random& random) {
  std::vector<double> sum(n, 0);
  double height = 0.5;
  for (std::size_t corners = 5; corners < 2 * n; corners *= 2, height *= 0.5) {
    std::vector<double> at(corners);
    for (double& value : at) value = random.uniform(-height, height);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t corner = i * corners / n;
      const double part = static_cast<double>(i * corners % n) / static_cast<double>(n);
      sum[i] += (1 - part) * at[corner] + part * at[(corner + 1) % corners];
    }
  }
  return sum;
}

/// A ring of n points around the centre, between 0.7 and 1.3 radii away.
void add_ring(Pslg& pslg, Point centre, double radius, std::size_t n, int marker, generators::Random& random) {
  const std::vector<double> rough = rough_function(n, random);
  std::vector<Point> ring;
  for (std::size_t i = 0; i < n; ++i)
    ring.push_back(
        on_circle(centre, radius * (1 + 0.3 * rough[i]), 360.0 * static_cast<double>(i) / static_cast<double>(n)));
  add_closed(pslg, ring, marker);
}

}  // namespace

Pslg coast(std::uint64_t n, std::uint64_t seed) {
  constexpr std::uint64_t rows = 4, islands = rows * rows;
  generators::Random random(seed);
  Pslg pslg;
  const std::uint64_t of_island = n / 2 / islands;
  add_ring(pslg, {0, 0}, 1, n - islands * of_island, 1, random);
  for (std::uint64_t i = 0; i < islands; ++i) {
    const Point centre{0.22 * static_cast<double>(i % rows) - 0.33, 0.22 * static_cast<double>(i / rows) - 0.33};
    add_ring(pslg, centre, 0.07, of_island, 2, random);
    pslg.holes.push_back(centre);
  }
  return pslg;
}

}  // namespace pardel::domains
