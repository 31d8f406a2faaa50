// Functions of the place become local bounds with the same values, whatever the hint.
#include "../../../parallel/sizing/local_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../../core/raster.hpp"
#include "../../../core/result.hpp"

namespace pardel::engine {
namespace {

std::shared_ptr<const Background> two_triangles() {
  return std::make_shared<const Background>(std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {0, 2}},
                                            std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}});
}

void expect_same(const std::function<double(Point)>& function) {
  const LocalBound bound = local_bound(function);
  LocationHint hint;
  for (const double x : {-1.0, 0.0, 0.25, 1.0, 1.75, 2.0})
    for (const double y : {0.0, 0.5, 1.0, 1.5, 3.0}) EXPECT_EQ(bound({x, y}, hint), function({x, y}));
}

TEST(LocalBound, of_values_at_points_interpolates_them) {
  const OnBackground<PointValues> size{
      std::make_shared<const PointValues>(PointValues{two_triangles(), {1, 3, 5, 3}, false})};
  EXPECT_EQ(size({0.5, 0.5}), 2);
  expect_same(size);
  LocationHint hint;
  EXPECT_EQ(local_bound(size)({1.5, 0.5}, hint), 3);
  EXPECT_NE(hint.leaf, no_index) << "the next search starts there";
}

TEST(LocalBound, of_values_on_triangles_is_constant_there) {
  const std::vector<double> values{7, 8};
  const OnBackground<TriangleValues> cap{
      std::make_shared<const TriangleValues>(TriangleValues{two_triangles(), values})};
  EXPECT_EQ(cap({1.5, 0.5}), 7);
  EXPECT_EQ(cap({0.5, 1.5}), 8);
  expect_same(cap);
}

/// A raster of 5 x 4 points, whose values are the numbers from 1 on, with some exceptions.
Raster some_raster() {
  Raster raster{.columns = 5, .rows = 4, .first = {-1, 0}, .step_x = 0.75, .step_y = 1, .values = {}};
  for (int k = 0; k < 20; ++k) raster.values.push_back(1 + k % 7 * 0.125);
  return raster;
}

TEST(LocalBound, of_a_raster_interpolates_it) {
  const LocalBound bound = local_bound(*interpolated_size(some_raster()));
  LocationHint hint;
  for (const double x : {-1.0, 0.1, 0.5, 1.9})
    for (const double y : {0.0, 0.3, 2.9}) EXPECT_EQ(bound({x, y}, hint), interpolate(some_raster(), {x, y}));
  EXPECT_THROW((void)bound({-2, 0}, hint), Error);
}

TEST(LocalBound, of_a_raster_knows_how_fast_it_changes) {
  const Raster raster = some_raster();
  const auto [slope, blur] = local_bound(*interpolated_size(raster)).steepness();
  double steepest = 0;
  for (int i = 0; i < 4000; ++i) {
    const Point p{-1 + 3 * (i * 37 % 4001 / 4001.0), 3 * (i * 1009 % 4003 / 4003.0)};
    for (const Point q : {Point{p.x + 0.01, p.y}, Point{p.x + 0.006, p.y + 0.008}, Point{p.x + 0.006, p.y - 0.008}}) {
      if (q.x > 2 || q.y > 3 || q.y < 0) continue;
      const double change = std::abs(interpolate(raster, p) - interpolate(raster, q));
      EXPECT_LE(change, slope * 0.01 + blur + 1e-15);
      steepest = std::max(steepest, change / 0.01);
    }
  }
  EXPECT_GE(steepest, 0.7 * slope);
}

TEST(LocalBound, of_a_raster_with_gaps_does_not_know_how_fast_it_changes) {
  Raster raster = some_raster();
  for (const double gap : {NAN, INFINITY}) {
    raster.values[7] = gap;
    EXPECT_EQ(local_bound(*interpolated_size(raster)).steepness().slope, INFINITY);
  }
}

TEST(LocalBound, of_a_function_of_the_caller_calls_it) {
  expect_same([](Point p) { return p.x + 10 * p.y; });
  EXPECT_FALSE(local_bound({}));
}

}  // namespace
}  // namespace pardel::engine
