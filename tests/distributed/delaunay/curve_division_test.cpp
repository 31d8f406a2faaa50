#include "../../../distributed/delaunay/curve_division.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../../../parallel/arithmetic/predicates.hpp"
#include "../../../parallel/decomposition/bounding_box.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../parallel/samples.hpp"

namespace pardel::engine {
namespace {

using generators::Random;

TEST(CurveGrid, has_all_points_of_a_quadrant_in_one_range_of_keys) {
  const std::vector<Point> points = samples::uniform_points(2'000, 3);
  const CurveGrid grid(bounding_box({}, points.size(), [&](std::size_t i) { return points[i]; }));
  for (const unsigned level : {0U, 1U, 3U, 8U, 16U})
    for (const Point p : points) {
      const CurveGrid::Quadrant cell = grid.around(Box::around(p));
      const unsigned up = cell.level > level ? cell.level - level : 0;
      const CurveGrid::Quadrant quadrant{cell.x >> up, cell.y >> up, cell.level - up};
      EXPECT_LE(CurveGrid::first_key(quadrant), grid.key(p));
      EXPECT_GE(CurveGrid::last_key(quadrant), grid.key(p));
      const Box square = grid.square(quadrant);
      EXPECT_TRUE(square.min_x <= p.x && p.x <= square.max_x && square.min_y <= p.y && p.y <= square.max_y);
    }
}

TEST(CurveGrid, orders_the_points_of_some_cells_as_all_points) {
  for (const samples::Family& family : samples::families(3'000, 4)) {
    const std::vector<Point>& points = family.points;
    const CurveGrid grid(bounding_box({}, points.size(), [&](std::size_t i) { return points[i]; }));
    const Array<Index> all = hilbert_order(points);
    for (const std::uint32_t limit : {0x20000000U, 0x80000000U, 0xe0000000U}) {
      std::vector<Point> part;
      std::vector<Index> expected;
      for (std::size_t k = 0; k < all.size(); ++k)
        if (grid.key(points[all[k]]) < limit) expected.push_back(all[k]);
      std::vector<Index> input;
      for (Index i = 0; i < points.size(); ++i)
        if (grid.key(points[i]) < limit) {
          part.push_back(points[i]);
          input.push_back(i);
        }
      const Array<Index> order = hilbert_order(part, grid);
      ASSERT_EQ(order.size(), expected.size());
      for (std::size_t k = 0; k < order.size(); ++k) ASSERT_EQ(input[order[k]], expected[k]) << family.name;
    }
  }
}

/// All points in the disk, or left of the line, belong to ranks that are found.
TEST(CurveDivision, finds_all_owners_of_points_in_an_area) {
  Random random(2);
  for (const samples::Family& family : samples::families(600, 5)) {
    const std::vector<Point>& points = family.points;
    const CurveGrid grid(bounding_box({}, points.size(), [&](std::size_t i) { return points[i]; }));
    const CurveDivision division(grid, {0, 0x30000000, 0x30000000, 0x70000000, 0xc0000001, UINT32_MAX});
    for (int round = 0; round < 200; ++round) {
      const Point a = points[random.below(points.size())], b = points[random.below(points.size())],
                  c = points[random.below(points.size())];
      if (!(orient2d(a, b, c) > 0)) continue;
      const Disk disk = Disk::around(a, b, c);
      std::set<int> in_disk, on_left;
      for (const Point p : points) {
        if (incircle(a, b, c, p) >= 0) in_disk.insert(division.owner(p));
        if (orient2d(a, b, p) >= 0) on_left.insert(division.owner(p));
      }
      for (int self = 0; self < 6; ++self) {
        const std::vector<int> near = division.others_in(disk, self), left = division.others_in(HalfPlane{a, b}, self);
        for (const int rank : in_disk) EXPECT_TRUE(rank == self || std::ranges::count(near, rank) == 1) << family.name;
        for (const int rank : on_left) EXPECT_TRUE(rank == self || std::ranges::count(left, rank) == 1) << family.name;
        EXPECT_TRUE(!division.certainly_owns(self, disk) || in_disk == std::set{self}) << family.name;
      }
    }
  }
}

TEST(CurveDivision, gives_ranks_about_equally_many_points) {
  const std::vector<Point> points = samples::uniform_points(100'000, 6);
  properties::on_ranks(4, [&](Ranks& ranks) {
    const auto part = std::span(points).subspan(25'000 * static_cast<std::size_t>(ranks.rank()), 25'000);
    const CurveDivision division = divide_along_curve(part, ranks);
    std::vector<std::size_t> owned(4, 0);
    for (const Point p : points) ++owned[division.owner(p)];
    for (const std::size_t count : owned) EXPECT_NEAR(static_cast<double>(count), 25'000, 500);
  });
}

TEST(Disk, of_a_flat_triangle_is_the_whole_plane) {
  EXPECT_TRUE(Disk::around({0, 0}, {1, 0}, {2, 0}).is_whole_plane());
  EXPECT_TRUE(Disk::around({0, 0}, {1, 1}, {2, 2 + 1e-12}).is_whole_plane());
  const Disk disk = Disk::around({0, 0}, {2, 0}, {0, 2});
  EXPECT_NEAR(disk.centre.x, 1, 1e-9);
  EXPECT_NEAR(disk.centre.y, 1, 1e-9);
  EXPECT_NEAR(disk.radius, 1.41421356, 1e-4);
  EXPECT_FALSE(disk.may_meet({2.5, 2.5, 3, 3}));
  EXPECT_TRUE(disk.may_meet({1.9, 1.9, 3, 3}));
}

}  // namespace
}  // namespace pardel::engine
