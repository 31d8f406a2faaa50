#include "../../../parallel/decomposition/hilbert_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

double length_of_tour(const std::vector<Point>& points, const Array<Index>& order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point a = points[order[i - 1]], b = points[order[i]];
    length += std::hypot(a.x - b.x, a.y - b.y);
  }
  return length;
}

bool is_permutation(Array<Index> order, std::size_t n) {
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] != i) return false;
  return order.size() == n;
}

TEST(HilbertOrder, lists_every_point_once) {
  for (const samples::Family& family : samples::families(5000, 1))
    EXPECT_TRUE(is_permutation(hilbert_order(family.points), family.points.size())) << family.name;
  EXPECT_TRUE(hilbert_order({}).empty());
}

TEST(HilbertOrder, depends_on_coordinates_only) {
  samples::Random random(2);
  for (const samples::Family& family : samples::families(3000, 3)) {
    std::vector<Point> other = family.points;
    random.shuffle(other);
    const Array<Index> first = hilbert_order(family.points), second = hilbert_order(other);
    for (std::size_t i = 0; i < first.size(); ++i)
      ASSERT_EQ(family.points[first[i]], other[second[i]]) << family.name << " at " << i;
  }
}

/// The input has several blocks of points, and clusters that are ordered recursively.
TEST(HilbertOrder, does_not_depend_on_threads) {
  samples::Random random(6);
  std::vector<Point> points = samples::uniform_points(40'000, 7);
  for (int cluster = 0; cluster < 500; ++cluster) {
    const Point centre = points[random.below(40'000)];
    for (int i = 0; i < 20; ++i)
      points.push_back({centre.x + random.uniform(0, 1e-9), centre.y + random.uniform(0, 1e-9)});
  }
  const Array<Index> order = hilbert_order(points);
  EXPECT_TRUE(is_permutation(order, points.size()));
  for (const int threads : {2, 3, 16}) EXPECT_EQ(hilbert_order(points, threads), order) << threads << " threads";
}

TEST(HilbertOrder, lists_equal_points_once_each) {
  const std::vector<Point> same(1000, Point{3, 4});
  EXPECT_TRUE(is_permutation(hilbert_order(same), same.size()));
}

/// The tour along the curve is at most a constant factor longer than the shortest one, which has length 0.71 sqrt(n A)
/// for uniform points in an area A.
TEST(HilbertOrder, makes_a_short_tour) {
  constexpr std::size_t n = 20'000;
  const std::vector<Point> points = samples::uniform_points(n, 4);
  EXPECT_LT(length_of_tour(points, hilbert_order(points)), std::sqrt(double(n)));
}

/// The defining property of Hilbert's curve: on a lattice of 2^k by 2^k points every step leads to a direct neighbour.
TEST(HilbertOrder, steps_from_neighbour_to_neighbour_on_a_lattice) {
  constexpr int n = 64;
  const std::vector<Point> points = samples::lattice_points(n);
  EXPECT_EQ(length_of_tour(points, hilbert_order(points)), n * n - 1);
}

/// All points of the cluster share one cell of the grid, so they are ordered recursively.
TEST(HilbertOrder, stays_short_inside_a_tiny_cluster) {
  std::vector<Point> points = samples::uniform_points(10'000, 5);
  for (Point& p : points) p = {p.x * 0x1p-30, p.y * 0x1p-30};
  points.push_back({1, 1});
  const Array<Index> order = hilbert_order(points);
  double inside = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point a = points[order[i - 1]], b = points[order[i]];
    if (a.x < 0.5 && b.x < 0.5) inside += std::hypot(a.x - b.x, a.y - b.y);
  }
  EXPECT_LT(inside, 100 * 0x1p-30);
}

}  // namespace
}  // namespace pardel::engine
