// Functions of the place become local bounds with the same values, whatever the hint.
#include "../../../parallel/interpolation/local_bound.hpp"

#include <gtest/gtest.h>

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
      std::make_shared<const PointValues>(two_triangles(), std::vector<double>{1, 3, 5, 3})};
  EXPECT_EQ(size({0.5, 0.5}), 2);
  expect_same(size);
  LocationHint hint;
  EXPECT_EQ(local_bound(size)({1.5, 0.5}, hint), 3);
  EXPECT_NE(hint.leaf, no_index) << "the next search starts there";
}

TEST(LocalBound, of_values_on_triangles_is_constant_there) {
  const std::vector<double> values{7, 8};
  const OnBackground<TriangleValues> cap{std::make_shared<const TriangleValues>(two_triangles(), values)};
  EXPECT_EQ(cap({1.5, 0.5}), 7);
  EXPECT_EQ(cap({0.5, 1.5}), 8);
  expect_same(cap);
}

TEST(LocalBound, of_a_function_of_the_caller_calls_it) {
  expect_same([](Point p) { return p.x + 10 * p.y; });
  EXPECT_FALSE(local_bound({}));
}

}  // namespace
}  // namespace pardel::engine
