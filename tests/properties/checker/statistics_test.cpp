// Statistics of small meshes with known values.
#include "../../../properties/checker/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pardel::checker {
namespace {

double degrees(double y, double x) { return std::atan2(y, x) * 180 / std::numbers::pi; }

Mesh one_triangle(Point a, Point b, Point c) {
  Mesh mesh;
  for (const Point p : {a, b, c}) mesh.points.push_back(p);
  mesh.triangles.push_back({{0, 1, 2}, {no_index, no_index, no_index}});
  return mesh;
}

TEST(Statistics, a_mesh_without_triangles_has_only_points) {
  Mesh mesh;
  mesh.points.push_back({1, 2});
  const MeshStatistics s = statistics(mesh);
  EXPECT_EQ(s.vertices, 1U);
  EXPECT_EQ(s.triangles, 0U);
  EXPECT_EQ(s.min_angle_deg, 0);
  EXPECT_EQ(s.area, 0);
}

TEST(Statistics, a_right_triangle_of_sides_3_4_5_is_measured) {
  const MeshStatistics s = statistics(one_triangle({0, 0}, {4, 0}, {0, 3}));
  EXPECT_DOUBLE_EQ(s.area, 6);
  EXPECT_DOUBLE_EQ(s.max_circumradius, 2.5);
  EXPECT_DOUBLE_EQ(s.max_angle_deg, 90);
  EXPECT_DOUBLE_EQ(s.min_angle_deg, degrees(3, 4));
}

TEST(Statistics, an_obtuse_angle_is_the_largest_wherever_it_stands) {
  const Point a{0, 0}, b{3, 0}, c{-3, 3};
  for (const Mesh& mesh : {one_triangle(a, b, c), one_triangle(b, c, a), one_triangle(c, a, b)}) {
    EXPECT_DOUBLE_EQ(statistics(mesh).max_angle_deg, 135);
    EXPECT_DOUBLE_EQ(statistics(mesh).min_angle_deg, degrees(1, 3));
  }
}

TEST(Statistics, extremes_are_taken_over_all_triangles_and_areas_add_up) {
  Mesh mesh = one_triangle({0, 0}, {1, 0}, {0, 1});
  mesh.points.push_back({10, 10});
  mesh.triangles.push_back({{1, 3, 2}, {no_index, no_index, no_index}});
  const MeshStatistics s = statistics(mesh);
  EXPECT_EQ(s.triangles, 2U);
  EXPECT_DOUBLE_EQ(s.area, 0.5 + 9.5);
  EXPECT_DOUBLE_EQ(s.max_angle_deg, 90);
  EXPECT_LT(s.min_angle_deg, 10);
}

TEST(Statistics, the_largest_coordinates_do_not_overflow) {
  const double big = 0x1p200;
  const MeshStatistics s = statistics(one_triangle({0, 0}, {4 * big, 0}, {0, 3 * big}));
  EXPECT_DOUBLE_EQ(s.max_circumradius, 2.5 * big);
  EXPECT_DOUBLE_EQ(s.area, 6 * big * big);
}

TEST(Statistics, a_million_small_areas_are_not_lost_next_to_a_large_one) {
  Mesh mesh = one_triangle({0, 0}, {0x1p16, 0}, {0, 0x1p16});
  mesh.points.push_back({0x1p-11, 0});
  mesh.points.push_back({0, 0x1p-11});
  for (int i = 0; i < 1 << 20; ++i) mesh.triangles.push_back({{0, 3, 4}, {no_index, no_index, no_index}});
  // The area of each small triangle is a quarter of a unit in the last place of the large triangle's area.
  EXPECT_EQ(statistics(mesh).area, 0x1p31 + 0.125);
}

}  // namespace
}  // namespace pardel::checker
