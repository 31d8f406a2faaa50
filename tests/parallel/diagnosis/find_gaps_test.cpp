// find_gaps(): the narrow places of a domain.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "../../../parallel/gaps.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../shapes.hpp"

namespace pardel {
namespace {

using testing::add_square;
using testing::points_only;
using testing::square;

std::vector<Gap> gaps_of(const Pslg& pslg) {
  Result<std::vector<Gap>> gaps = find_gaps(*validate(pslg));
  EXPECT_TRUE(gaps) << gaps.error().message;
  return std::move(*gaps);
}

/// A unit square that contains these points.
Pslg square_with(const std::vector<Point>& points) {
  Pslg pslg = square(1);
  pslg.points.insert(pslg.points.end(), points.begin(), points.end());
  return pslg;
}

TEST(Gaps, are_not_all_distances_beside_a_far_point) {
  EXPECT_TRUE(gaps_of(square_with({{0.5, 0.5}, {0.5, 0.75}, {1e12, 1e12}})).empty());
}

TEST(Gaps, are_two_points_that_nearly_touch) {
  const std::vector<Gap> gaps = gaps_of(square_with({{0.5, 0.5}, {0.5, 0.5 + 0x1p-30}}));
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].kind, GapKind::close_points);
  EXPECT_EQ(gaps[0].points, (std::vector<Index>{4, 5}));
  EXPECT_EQ(gaps[0].distance, 0x1p-30);
  EXPECT_EQ(gaps[0].message(1), "The distance of point 5 at (0.5, 0.5) from point 6 is only 9.313225746154785e-10.");
}

TEST(Gaps, of_three_points_in_a_row_name_the_narrowest_pair_and_not_the_point_that_it_contains) {
  const std::vector<Gap> gaps = gaps_of(square_with({{0.5, 0.5}, {0.5, 0.5 + 0x1p-30}, {0.5, 0.5 + 3 * 0x1p-30}}));
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].points, (std::vector<Index>{4, 5}));
  const std::vector<Gap> chain = gaps_of(square_with({{0.5, 0.5 + 3 * 0x1p-30}, {0.5, 0.5}, {0.5, 0.5 + 0x1p-30}}));
  ASSERT_EQ(chain.size(), 1);
  EXPECT_EQ(chain[0].points, (std::vector<Index>{5, 6}));
}

TEST(Gaps, are_the_same_beside_a_far_point_and_a_huge_part_of_the_domain) {
  for (const double width : {1e-5, 1e-7}) {
    Pslg pslg = square_with({{0.2, width}, {0.8, width}});
    pslg.segments.push_back({4, 5});
    const auto widths_of = [](const Pslg& domain) {
      std::vector<double> widths;
      for (const Gap& gap : gaps_of(domain)) widths.push_back(gap.distance);
      return widths;
    };
    const std::vector<double> alone = widths_of(pslg);
    EXPECT_EQ(alone.size(), width < 1e-6 ? 2 : 0);
    Pslg far = pslg;
    far.points.push_back({1e6, 1e6});
    EXPECT_EQ(widths_of(far), alone);
    add_square(pslg, 0x1p50, {2, 2});
    EXPECT_EQ(widths_of(pslg), alone);
  }
}

TEST(Gaps, are_a_point_beside_a_segment) {
  for (const double y : {0x1p-25, 0x1p-45}) {
    const std::vector<Gap> gaps = gaps_of(square_with({{0.25, y}}));
    ASSERT_EQ(gaps.size(), 1);
    EXPECT_EQ(gaps[0].kind, GapKind::point_near_segment);
    EXPECT_EQ(gaps[0].points, (std::vector<Index>{4}));
    EXPECT_EQ(gaps[0].segment, 0);
    EXPECT_EQ(gaps[0].distance, y);
  }
}

TEST(Gaps, are_found_between_a_point_and_a_slanted_segment_behind_another_flat_triangle) {
  // Points 4 and 5 are above the side from (0, 0) to (1, 0.5), and point 5 is between point 4 and its end.
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0.5}, {1, 2}, {0, 2}, {0.25, 0.125 + 0x1p-40}, {0.75, 0.375 + 0x1p-41}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const std::vector<Gap> gaps = gaps_of(pslg);
  ASSERT_EQ(gaps.size(), 2);
  EXPECT_EQ(gaps[0].points, (std::vector<Index>{5}));
  EXPECT_EQ(gaps[1].points, (std::vector<Index>{4}));
  for (const Gap& gap : gaps) EXPECT_EQ(gap.segment, 0);
  EXPECT_NEAR(gaps[1].distance, 0x1p-40 / std::sqrt(1.25), 0x1p-60);
}

TEST(Gaps, are_a_short_segment_between_long_ones) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0x1p-28, 1}, {0, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}};
  const std::vector<Gap> gaps = gaps_of(pslg);
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].kind, GapKind::short_segment);
  EXPECT_EQ(gaps[0].segment, 3);
}

TEST(Gaps, in_small_surroundings_are_too_narrow_for_double_precision_and_their_messages_say_so) {
  Pslg island = square(1);
  add_square(island, 1e-10, {0.5, 0.5});
  const std::vector<Gap> gaps = gaps_of(island);
  ASSERT_FALSE(gaps.empty());
  for (const Gap& gap : gaps)
    EXPECT_TRUE(gap.message().ends_with(", less than 1000 times the shortest edge that double precision allows."));
}

TEST(Gaps, are_a_point_beside_the_convex_hull) {
  const std::vector<Gap> gaps = gaps_of(points_only({{0, 0}, {1, 0}, {0.5, 1}, {0.5, 0x1p-44}}));
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].kind, GapKind::point_near_hull);
  EXPECT_EQ(gaps[0].points.size(), 3);
  EXPECT_EQ(gaps[0].points[0], 3);
  EXPECT_EQ(closing_snap(gaps), 0x1p-43);
}

TEST(Gaps, are_not_random_points_that_happen_to_lie_near_a_side_of_the_convex_hull) {
  EXPECT_TRUE(gaps_of(points_only({{0, 0}, {1, 0}, {0.5, 1}, {0.5, 1e-8}})).empty());
  EXPECT_TRUE(gaps_of(domains::random_points(300'000, 1)).empty());
}

TEST(Gaps, are_not_the_distances_between_points_that_are_dense_in_a_place) {
  EXPECT_TRUE(gaps_of(domains::radial(6)).empty());
  std::vector<Point> points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int i = 0; i < 400; ++i) points.push_back({1e-8 * (i % 20), 1e-8 * (i / 20 + 0.1 * (i % 2))});
  EXPECT_TRUE(gaps_of(points_only(points)).empty());
}

TEST(Gaps, are_two_points_that_nearly_touch_where_points_are_dense) {
  std::vector<Point> points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int i = 0; i < 400; ++i) points.push_back({1e-5 * (i % 20), 1e-5 * (i / 20 + 0.1 * (i % 2))});
  points.push_back({1e-5 * 7, 1e-5 * 5.1 + 1e-10});  // beside point 4 + 107
  const std::vector<Gap> gaps = gaps_of(points_only(points));
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].points, (std::vector<Index>{111, 404}));
}

TEST(Gaps, are_two_points_that_nearly_touch_on_the_convex_hull) {
  const std::vector<Gap> gaps = gaps_of(points_only({{0, 0}, {1, 0}, {1 + 1e-9, 1e-9}, {0.5, 1}, {0.5, 0.5}}));
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].points, (std::vector<Index>{1, 2}));
}

TEST(Gaps, are_not_small_shapes_nor_places_outside_the_domain) {
  Pslg island = square(1);
  add_square(island, 1e-8, {0.5, 0.5});
  EXPECT_TRUE(gaps_of(island).empty());

  Pslg hole = square(4);
  add_square(hole, 1, {1, 1});
  hole.holes = {{1.5, 1.2}};
  hole.points.insert(hole.points.end(), {{1.5, 1.5}, {1.5, 1.5 + 0x1p-40}});
  EXPECT_TRUE(gaps_of(hole).empty());
}

TEST(Gaps, do_not_occur_in_ordinary_domains) {
  for (const Pslg& pslg : {domains::pipe(), domains::key(), domains::star(7, 5), domains::comb(5, 0.01),
                           domains::wedge(20, 1), domains::random_points(2000, 1)})
    EXPECT_TRUE(gaps_of(pslg).empty());
}

TEST(Gaps, are_in_the_report_of_the_mesher) {
  const Pslg pslg = square_with({{0.25, 0x1p-25}});
  const Result<Meshed> meshed = mesh(pslg);
  ASSERT_TRUE(meshed);
  ASSERT_EQ(meshed->report.gaps.size(), 1);
  EXPECT_EQ(meshed->report.gaps[0].points, gaps_of(pslg)[0].points);
}

TEST(Gaps, of_similar_width_are_closed_by_one_snapping_distance) {
  const auto gap = [](double distance) { return Gap{GapKind::close_points, {0, 1}, no_index, distance, 1, {}}; };
  EXPECT_EQ(closing_snap(std::vector{gap(1), gap(4), gap(32), gap(512)}), 64);
  EXPECT_EQ(closing_snap({}), 0);
}

TEST(Gaps, at_the_convex_hull_are_described_by_three_points) {
  const Gap gap{GapKind::point_near_hull, {4, 7, 9}, no_index, 1e-5, 1, {0.25, 0.5}};
  EXPECT_EQ(gap.message(),
            "The distance of point 4 at (0.25, 0.5) from the side of the convex hull between points 7 "
            "and 9 is only 1e-05.");
}

TEST(Gaps, are_narrower_than_a_millionth_of_the_extent) {
  const auto with_pair = [](double distance) { return square_with({{0.5, 0.5}, {0.5, 0.5 + distance}}); };
  EXPECT_EQ(gaps_of(with_pair(0.99e-6)).size(), 1);
  EXPECT_TRUE(gaps_of(with_pair(1.01e-6)).empty());
}

/// Without the second segment, the first one and the corner behind it would be a gap, too.
TEST(Gaps, of_two_short_segments_in_a_row_are_the_shorter_one) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0x1.8p-33, 1}, {0x1p-34, 1}, {0, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
  for (const bool reversed : {false, true}) {
    if (reversed) {
      std::swap(pslg.points[3], pslg.points[5]);
      pslg.segments = {{0, 1}, {1, 2}, {2, 5}, {5, 4}, {4, 3}, {3, 0}};
    }
    const std::vector<Gap> gaps = gaps_of(pslg);
    ASSERT_EQ(gaps.size(), 1);
    EXPECT_EQ(gaps[0].kind, GapKind::short_segment);
    EXPECT_EQ(gaps[0].distance, 0x1p-34);
  }
}

TEST(Gaps, beside_a_segment_have_the_longest_segment_at_the_point_as_surroundings) {
  Pslg pslg = square_with({{0.5, 0x1p-25}, {0.5, 0.25 + 0x1p-25}});
  pslg.segments.push_back({4, 5});
  const std::vector<Gap> gaps = gaps_of(pslg);
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0].kind, GapKind::point_near_segment);
  EXPECT_EQ(gaps[0].surroundings, 0.25);
}

/// The point is beside the segment, or only beside its end.
TEST(Gaps, are_between_a_point_and_a_segment_if_its_end_is_more_than_twice_as_far_away) {
  constexpr double height = 1e-8;
  for (const double times : {1.99, 2.01, 2.5, 3.5}) {
    const std::vector<Gap> gaps = gaps_of(square_with({{std::sqrt(times * times - 1) * height, height}}));
    ASSERT_EQ(gaps.size(), 1) << times;
    EXPECT_EQ(gaps[0].kind, times > 2 ? GapKind::point_near_segment : GapKind::close_points) << times;
  }
}

}  // namespace
}  // namespace pardel
