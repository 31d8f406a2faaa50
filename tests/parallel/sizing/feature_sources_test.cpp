// Which features of a domain ask for which lengths.
#include "../../../parallel/sizing/feature_sources.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../../../parallel/arithmetic/distance.hpp"
#include "../../../parallel/sizing/polylines.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_polygon;

/// The least length at p, for lengths that grow by 1 / edges.
double length_at(const Pslg& pslg, double edges, Point p) {
  double least = INFINITY;
  for (const GrowingSize& source : feature_sources(pslg, find_polylines(pslg, {}), edges, 1 / edges, {}))
    least = std::min(least, PreparedSize(source).at(p));
  return least;
}

TEST(FeatureSources, of_a_rectangle_are_its_width_divided_by_the_number_of_edges) {
  Pslg pslg;
  add_polygon(pslg, {{0, 0}, {10, 0}, {10, 1}, {0, 1}});
  for (const Point on_a_long_side : {Point{0, 0}, Point{5, 0}, Point{7.3, 1}})
    EXPECT_DOUBLE_EQ(length_at(pslg, 4, on_a_long_side), 0.25);
  EXPECT_DOUBLE_EQ(length_at(pslg, 4, {5, 0.5}), 0.375) << "half a width away, lengths have grown by an eighth";
}

TEST(FeatureSources, see_a_point_near_a_segment) {
  Pslg pslg = testing::square(8);
  pslg.points.push_back({3, 0.5});
  EXPECT_NEAR(length_at(pslg, 1, {3, 0}), 0.5, 0.125);
  EXPECT_LE(length_at(pslg, 1, {3, 0}), 0.5);
  EXPECT_DOUBLE_EQ(length_at(pslg, 1, {3, 0.5}), 0.5);
}

TEST(FeatureSources, do_not_see_a_point_far_outside_of_the_segments) {
  Pslg pslg = testing::square(8);
  add_polygon(pslg, {{1, 1}, {7, 1}, {7, 1.001}, {1, 2}});
  Pslg with_point = pslg;
  with_point.points.push_back({1e14, 0});
  for (double x = 0; x <= 8; x += 0.25)
    EXPECT_EQ(length_at(with_point, 3, {x, 1.5}), length_at(pslg, 3, {x, 1.5})) << x;
}

TEST(FeatureSources, see_the_side_opposite_a_corner) {
  Pslg pslg;
  add_polygon(pslg, {{0, 0}, {2, 0}, {1, 1}});
  EXPECT_DOUBLE_EQ(length_at(pslg, 2, {1, 1}), 0.5);
}

TEST(FeatureSources, of_a_circle_are_its_radius_however_many_vertices_it_has) {
  for (const int n : {64, 1000, 20000}) {
    const double length = length_at(testing::regular_polygon(n, 3), 2, {3, 0});
    EXPECT_LE(length, 1.5) << n;
    EXPECT_GE(length, 1.2) << n;
  }
}

TEST(FeatureSources, do_not_see_neighbours_along_a_polyline) {
  Pslg pslg;
  for (int k = 0; k <= 100; ++k) pslg.points.push_back({0.1 * k, 0});
  for (Index k = 0; k < 100; ++k) pslg.segments.push_back({k, k + 1});
  const auto sources = feature_sources(pslg, find_polylines(pslg, {}), 1, 1, {});
  ASSERT_EQ(sources.size(), 2U) << "the distance of the two ends";
  EXPECT_DOUBLE_EQ(sources[0].source.at_a, 10);
}

TEST(FeatureSources, see_the_other_side_of_a_long_smooth_hole) {
  Pslg pslg;
  std::vector<Point> corners;
  for (int k = 0; k <= 16; ++k) {
    const double angle = std::numbers::pi * (k / 16.0 - 0.5);
    corners.push_back({10 + std::cos(angle), std::sin(angle)});
  }
  for (int k = 0; k <= 16; ++k) {
    const double angle = std::numbers::pi * (k / 16.0 + 0.5);
    corners.push_back({-10 + std::cos(angle), std::sin(angle)});
  }
  add_polygon(pslg, corners);
  ASSERT_TRUE(find_polylines(pslg, {}).all[0].closed);
  EXPECT_NEAR(length_at(pslg, 1, {0, 1}), 2, 0.5);
  EXPECT_LE(length_at(pslg, 1, {0, 1}), 2);
}

TEST(FeatureSources, of_a_long_channel_are_few) {
  Pslg pslg;
  add_polygon(pslg, {{0, 0}, {1000, 0}, {1000, 1}, {0, 1}});
  const auto sources = feature_sources(pslg, find_polylines(pslg, {}), 2, 0.5, {});
  EXPECT_LT(sources.size(), 500U) << "pieces of equal width are one source";
}

TEST(FeatureSources, of_a_channel_are_no_more_if_it_is_narrower_than_a_65536th_of_the_domain) {
  std::size_t most = SIZE_MAX;
  for (const double width : {0x1p-16, 0x1p-19}) {
    Pslg pslg;
    add_polygon(pslg, {{0, 0}, {1, 0}, {1, width}, {0, width}});
    const auto sources = feature_sources(pslg, find_polylines(pslg, {}), 2, 0.5, {});
    EXPECT_LE(sources.size(), most);
    most = sources.size();
    const auto shorter = [](const GrowingSize& one, const GrowingSize& two) {
      return one.source.at_a < two.source.at_a;
    };
    EXPECT_DOUBLE_EQ(std::ranges::min_element(sources, shorter)->source.at_a, width / 2);
  }
}

/// A hairpin and a step. Seen from the first leg, the part that begins after a quarter turn is apart.
TEST(FeatureSources, see_the_own_polyline_from_where_it_has_turned_by_a_right_angle) {
  for (int pieces = 1; pieces <= 17; ++pieces)
    for (const bool mirrored : {false, true})
      for (const bool back : {false, true}) {
        Pslg pslg;
        for (int k = pieces; k >= 0; --k) pslg.points.push_back({-10.0 * k, 0});
        pslg.points.insert(pslg.points.end(), {{1, 1}, {1, 3}, {back ? 0.0 : 2.0, 4}, {back ? -10.0 : 12.0, 4}});
        for (Index k = 0; k + 1 < pslg.points.size(); ++k) pslg.segments.push_back({k, k + 1});
        for (Point& p : pslg.points) p.x *= mirrored ? -1 : 1;
        EXPECT_NEAR(length_at(pslg, 1, {0, 0}), std::sqrt(2.0), 1e-12) << pieces;
      }
}

TEST(FeatureSources, of_points_are_their_distances_to_the_nearest_other_point) {
  Pslg pslg;
  for (int n = 1; n <= 33; ++n) {
    pslg.points.push_back({std::fmod(0.7548776662466927 * n, 1), std::fmod(0.5698402909980532 * n, 1)});
    const auto sources = feature_sources(pslg, find_polylines(pslg, {}), 2, 0.5, {});
    ASSERT_EQ(sources.size(), n == 1 ? 0U : pslg.points.size());
    for (const GrowingSize& source : sources) {
      double nearest = INFINITY;
      for (const Point p : pslg.points)
        if (!(p == source.source.a)) nearest = std::min(nearest, distance(p, source.source.a));
      EXPECT_NEAR(source.source.at_a, nearest / 2, 1e-15) << n;
    }
  }
}

TEST(SegmentSources, have_the_lengths_of_the_segments) {
  Pslg pslg = testing::square(3);
  const auto sources = segment_sources(pslg, find_polylines(pslg, {}), 0.5);
  ASSERT_EQ(sources.size(), 4U);
  for (const GrowingSize& source : sources) EXPECT_EQ(source.source.at_a, 3);
  EXPECT_EQ(sources[0].slope, 0.5);
}

}  // namespace
}  // namespace pardel::engine
