#include "../../../parallel/construction/point_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/decomposition/bounding_box.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

std::vector<std::vector<Point>> uneven_sets() {
  return {domains::kuzmin_points(20'000, 1).points, domains::line_points(20'000, 2).points,
          domains::clustered_points(20'000, 3).points};
}

Box bounds_of(const std::vector<Point>& points) {
  return bounding_box(1, points.size(), [&](std::size_t i) { return points[i]; });
}

std::vector<std::size_t> points_per_leaf(const Quadtree& tree, const std::vector<Point>& points) {
  std::vector<std::size_t> count(tree.cells(), 0);
  for (const Point p : points) ++count[tree.cell_of(p)];
  return count;
}

TEST(PointTiles, have_no_more_points_than_allowed) {
  for (const std::vector<Point>& points : uneven_sets()) {
    const Quadtree tree = quadtree_of(bounds_of(points), points, points.size(), 300);
    EXPECT_LE(std::ranges::max(points_per_leaf(tree, points)), 300U);
  }
}

TEST(PointTiles, of_a_sample_have_hardly_more_points_than_allowed) {
  for (const std::vector<Point>& points : uneven_sets()) {
    std::vector<Point> sample;
    for (std::size_t i = 0; i < points.size(); i += 5) sample.push_back(points[i]);
    const Quadtree tree = quadtree_of(bounds_of(points), sample, points.size(), 300);
    EXPECT_LE(std::ranges::max(points_per_leaf(tree, points)), 450U);
    EXPECT_GE(tree.cells(), 20'000U / 450);
  }
}

TEST(PointTiles, are_one_leaf_if_that_is_allowed) {
  for (const std::vector<Point>& points : uneven_sets())
    EXPECT_EQ(quadtree_of(bounds_of(points), points, points.size(), 20'000).cells(), 1U);
}

}  // namespace
}  // namespace pardel::engine
