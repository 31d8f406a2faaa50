#include "../../../parallel/triangulation/domain_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pardel::engine {
namespace {

/// Segments from vertex 0 to the right, at 45 degrees, at 135 degrees and at 270 degrees.
struct Star {
  Array<Point> points{std::span<const Point>(std::vector<Point>{{0, 0}, {2, 0}, {1, 1}, {-1, 1}, {0, -3}})};
  std::vector<Constraint> constraints{{0, 1}, {2, 0}, {0, 3}, {4, 0}};
  DomainSegments segments{points, constraints};
};

TEST(DomainSegments, order_the_ends_of_each_segment) {
  const Star star;
  ASSERT_EQ(star.segments.size(), 4U);
  for (Index s = 0; s < 4; ++s) {
    EXPECT_EQ(star.segments[s].a, 0U);
    EXPECT_EQ(star.segments[s].b, s + 1);
  }
}

TEST(DomainSegments, know_the_smallest_angle_at_each_end) {
  const Star star;
  EXPECT_NEAR(star.segments[0].cosine_at_a, std::sqrt(0.5), 1e-15) << "45 and 90 degrees";
  EXPECT_NEAR(star.segments[1].cosine_at_a, std::sqrt(0.5), 1e-15) << "45 and 90 degrees";
  EXPECT_NEAR(star.segments[2].cosine_at_a, 0, 1e-15) << "90 and 135 degrees";
  EXPECT_NEAR(star.segments[3].cosine_at_a, 0, 1e-15) << "90 and 135 degrees";
  for (Index s = 0; s < 4; ++s) EXPECT_EQ(star.segments[s].cosine_at_b, -1);
  EXPECT_EQ(star.segments[0].cosine_at(0), star.segments[0].cosine_at_a);
  EXPECT_EQ(star.segments[0].cosine_at(3), -1) << "vertex 3 is not an end";
}

TEST(DomainSegments, compute_common_ends_and_angles) {
  const Star star;
  EXPECT_EQ(star.segments.shared_end(1, 3), 0U);
  EXPECT_NEAR(star.segments.cosine_at(star.points, 0, 0, 1), std::sqrt(0.5), 1e-15);
  const std::vector<Constraint> apart{{1, 2}, {3, 4}};
  EXPECT_EQ(DomainSegments(star.points, apart).shared_end(0, 1), no_index);
}

/// Segments from vertex 0: of length 4 to the right, of lengths 1 and 3 at half a degree and at 0.8 degrees from it on
/// its two sides, and of length 2 at two degrees.
TEST(DomainSegments, pass_the_ends_of_shorter_segments_at_less_than_one_degree) {
  const auto at = [](double length, double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180;
    return Point{length * std::cos(angle), length * std::sin(angle)};
  };
  const Array<Point> points{
      std::span<const Point>(std::vector<Point>{{0, 0}, {4, 0}, at(1, 0.5), at(3, -0.8), at(2, 2)})};
  const std::vector<Constraint> constraints{{0, 1}, {0, 2}, {0, 3}, {0, 4}};
  const DomainSegments segments(points, constraints);
  ASSERT_EQ(segments.places_beside_ends(0).size(), 2U);
  for (const PlaceBesideEnd& place : segments.places_beside_ends(0)) {
    const bool first = place.distance < 2;
    EXPECT_EQ(place.apex, 0U);
    EXPECT_NEAR(place.distance, first ? 1 : 3, 1e-15);
    EXPECT_NEAR(place.gap, first ? std::acos(-1.0) / 360 : 3 * 0.8 * std::acos(-1.0) / 180, 1e-5);
  }
  for (Index s = 1; s < 4; ++s) EXPECT_TRUE(segments.places_beside_ends(s).empty()) << s;
  EXPECT_EQ(segments.segments_at(0).size(), 4U);
  EXPECT_EQ(segments.segments_at(3).size(), 1U);
  EXPECT_TRUE(segments.segments_at(5).empty());
}

/// A flat triangle, whose long side passes the vertex between the others from both of its ends; and three segments at
/// one end, of which the longest has two shorter ones on one side.
TEST(DomainSegments, pass_ends_at_both_ends_and_several_on_one_side) {
  const Array<Point> points{std::span<const Point>(
      std::vector<Point>{{0, 0}, {1, 1e-4}, {2, 2e-5}, {3, 0}, {9, 0}, {8, 0.01}, {7, 0.02}, {5, 0}})};
  const std::vector<Constraint> constraints{{0, 2}, {2, 3}, {0, 3}, {7, 6}, {7, 5}, {7, 4}};
  const DomainSegments segments(points, constraints);
  const auto distances = [&](Index segment) {
    std::vector<std::pair<VertexId, double>> found;
    for (const PlaceBesideEnd& place : segments.places_beside_ends(segment))
      found.emplace_back(place.apex, std::round(1000 * place.distance) / 1000);
    std::ranges::sort(found);
    return found;
  };
  using Places = std::vector<std::pair<VertexId, double>>;
  EXPECT_EQ(distances(0), Places{});
  EXPECT_EQ(distances(1), Places{});
  EXPECT_EQ(distances(2), (Places{{0, 2}, {3, 1}}));
  EXPECT_EQ(distances(3), Places{});
  EXPECT_EQ(distances(4), (Places{{7, 2}}));
  EXPECT_EQ(distances(5), (Places{{7, 2}, {7, 3}}));
}

/// A hub whose 100 segments lie within one degree: only the 16 nearest ones on each side count.
TEST(DomainSegments, pass_at_most_16_ends_on_each_side) {
  std::vector<Point> hub{{0, 0}};
  std::vector<Constraint> constraints;
  for (Index i = 1; i <= 100; ++i) {
    hub.push_back({100.0 + i, 1e-4 * i * (100.0 + i)});
    constraints.push_back({0, i});
  }
  const Array<Point> points{std::span<const Point>(hub)};
  const DomainSegments segments(points, constraints);
  EXPECT_EQ(segments.places_beside_ends(0).size(), 0U);
  EXPECT_EQ(segments.places_beside_ends(5).size(), 5U);
  EXPECT_EQ(segments.places_beside_ends(50).size(), 16U);
  EXPECT_EQ(segments.places_beside_ends(99).size(), 32U) << "all are narrow wedges, also across the start of the order";
}

/// A triangle so flat that rounding makes it a segment. The formula for a cosine gives 1 + 2^-52 at both ends.
TEST(DomainSegments, have_no_narrow_apex_where_the_angles_at_both_ends_are_equal) {
  const Array<Point> points{std::span<const Point>(std::vector<Point>{{-2, -3}, {2, 3}, {-3e-20, 2e-20}})};
  const std::vector<Constraint> constraints{{0, 1}, {1, 2}, {2, 0}};
  const DomainSegments segments(points, constraints);
  EXPECT_EQ(segments[0].cosine_at_a, 1);
  EXPECT_EQ(segments[0].cosine_at_b, 1);
  EXPECT_EQ(segments[0].narrow_apex, no_index);
}

/// At vertex 0, two segments meet at an angle whose tangent is 1/128; at the other end of one of them, another segment
/// at the angle whose tangent is given. A cosine of one degree is 0.99985.
TEST(DomainSegments, have_a_narrow_apex_where_the_angle_is_much_smaller_than_at_the_other_end) {
  const auto apex = [](double tangent) {
    const Array<Point> points{std::span<const Point>(
        std::vector<Point>{{0, 0}, {128, 0}, {128, 1}, {0, 128 * tangent}})};  // 2 and 3 lie above the segment 0-1
    const std::vector<Constraint> constraints{{0, 1}, {0, 2}, {1, 3}};
    return DomainSegments(points, constraints)[0].narrow_apex;
  };
  EXPECT_EQ(apex(1), 0U);
  EXPECT_EQ(apex(1.0 / 64), 0U);
  EXPECT_EQ(apex(1.0 / 128), no_index) << "both angles are equal";
  EXPECT_EQ(apex(1.0 / 100), no_index) << "the angle is not much smaller";
  EXPECT_EQ(apex(1.0 / 256), 1U);
}

TEST(DomainSegments, find_the_segment_of_a_subsegment) {
  const Star star;
  Triangulation t;
  t.points = star.points;
  t.points.push_back({0.5, 0.5});
  t.points.push_back({0.25, 0.25});
  t.origin.resize(5, input_vertex);
  t.origin.push_back(origin_on_segment(1));
  t.origin.push_back(origin_on_segment(1));
  EXPECT_EQ(star.segments.segment_of(t, 0, 3), 2U);
  EXPECT_EQ(star.segments.segment_of(t, 4, 0), 3U);
  EXPECT_EQ(star.segments.segment_of(t, 2, 5), 1U);
  EXPECT_EQ(star.segments.segment_of(t, 5, 6), 1U);
  EXPECT_EQ(star.segments.segment_of(t, 1, 2), no_index);
}

}  // namespace
}  // namespace pardel::engine
