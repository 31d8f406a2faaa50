// A field of sizes that ends somewhere has to cover the vertices of the domain.
#include "../../../parallel/sizing/coverage.hpp"

#include <gtest/gtest.h>

#include "../../../core/raster.hpp"
#include "../../../core/result.hpp"
#include "../../../parallel/sizing/local_bound.hpp"

namespace pardel::engine {
namespace {

std::function<double(Point)> on_a_triangle(bool limited) {
  auto background = std::make_shared<const Background>(std::vector<Point>{{0, 0}, {1, 0}, {0, 1}},
                                                       std::vector<std::array<Index, 3>>{{0, 1, 2}});
  const PointValues values{std::move(background), {1, 2, 3}, limited, "the field"};
  return OnBackground<PointValues>{std::make_shared<const PointValues>(values)};
}

/// The message about the first point without a size, or an empty text.
std::string uncovered(const std::function<double(Point)>& size, std::span<const Point> points, int threads = 1) {
  try {
    require_coverage(size, points, Threads(threads));
    return {};
  } catch (const Error& error) {
    return error.message;
  }
}

TEST(Coverage, of_a_limited_field_ends_a_side_beyond_its_mesh) {
  const std::vector<Point> near{{0, 0}, {0.2, 0.2}, {2, -1}}, far{{0, 0}, {3, 0}, {4, 0}};
  EXPECT_EQ(uncovered(on_a_triangle(true), near), "");
  EXPECT_EQ(uncovered(on_a_triangle(true), far), "the field does not cover (3, 0)");
  EXPECT_EQ(uncovered(on_a_triangle(false), far), "");
}

TEST(Coverage, of_a_raster_ends_at_its_border) {
  Raster raster{.columns = 2, .rows = 2, .first = {0, 0}, .step_x = 1, .step_y = 1, .values = {1, 1, 1, 1}};
  const auto size = interpolated_size(std::move(raster), "sizes.asc");
  ASSERT_TRUE(size);
  const std::vector<Point> inside{{0, 0}, {1, 1}}, outside{{0, 0}, {1, 7}};
  EXPECT_EQ(uncovered(*size, inside), "");
  EXPECT_EQ(uncovered(*size, outside), "sizes.asc has no size at (1, 7)");
}

TEST(Coverage, names_the_first_point_on_any_number_of_threads) {
  std::vector<Point> points(400'000, Point{0.25, 0.25});
  points[399'999] = {9, 9};
  points[250'000] = {8, 8};
  for (const int threads : {1, 2, 4})
    EXPECT_EQ(uncovered(on_a_triangle(true), points, threads), "the field does not cover (8, 8)");
}

TEST(Coverage, is_asked_at_the_points_only) {
  std::vector<Point> points(300'000, Point{8, 8});
  std::fill(points.begin(), points.begin() + 100'000, Point{0.25, 0.25});
  const std::span<const Point> covered(points.data(), 100'000);
  for (const int threads : {1, 2}) EXPECT_EQ(uncovered(on_a_triangle(true), covered, threads), "");
}

TEST(Coverage, is_not_asked_of_a_function_of_the_caller) {
  const std::vector<Point> points{{0, 0}};
  EXPECT_EQ(uncovered([](Point) -> double { throw Error{ErrorKind::usage, "called"}; }, points), "");
}

}  // namespace
}  // namespace pardel::engine
