// find_warnings(): segments with open ends outside the domain.
#include "../../../parallel/warnings.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "../shapes.hpp"

namespace pardel {
namespace {

using testing::add_square;
using testing::square;

/// A square and, beside it, an outline of which one side is missing.
Pslg open_beside_closed() {
  Pslg pslg = square(4);
  add_square(pslg, 2, {6, 0});
  pslg.segments.pop_back();
  return pslg;
}

TEST(Warnings, name_an_outline_that_is_not_closed_beside_a_closed_one) {
  const Pslg pslg = open_beside_closed();
  const std::vector<Warning> warnings = find_warnings(*validate(pslg));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].segments, (std::vector<Index>{4, 5, 6}));
  EXPECT_EQ(warnings[0].message(1),
            "3 segments, the first of them segment 5, are joined but have an open end at (6, 2) and lie outside the "
            "domain. They are not in the mesh.");
}

TEST(Warnings, name_an_open_outline_whose_segments_come_first_and_no_ring_in_a_hole) {
  Pslg pslg;
  pslg.points = {{6, 0}, {8, 0}, {8, 2}};
  pslg.segments = {{0, 1}, {1, 2}};
  add_square(pslg, 4, {0, 0});
  add_square(pslg, 2, {1, 1});
  add_square(pslg, 0.5, {1.5, 1.5});
  pslg.holes = {{1.25, 1.25}, {1.75, 1.75}};
  const std::vector<Warning> warnings = find_warnings(*validate(pslg));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].segments, (std::vector<Index>{0, 1}));
  pslg.segments[0] = {2, 0};
  pslg.segments[1] = {0, 1};
  EXPECT_EQ(find_warnings(*validate(pslg))[0].segments, (std::vector<Index>{0, 1})) << "the open ends are not shared";
  pslg.points.erase(pslg.points.begin() + 2);
  pslg.segments.erase(pslg.segments.begin());
  for (Segment& s : pslg.segments)
    for (Index* end : {&s.a, &s.b}) *end -= *end > 1 ? 1 : 0;
  ASSERT_EQ(find_warnings(*validate(pslg)).size(), 1);
  EXPECT_EQ(find_warnings(*validate(pslg))[0].segments, (std::vector<Index>{0})) << "a single segment, the first";
}

TEST(Warnings, name_a_point_or_a_segment_that_is_far_away_from_everything_else) {
  Pslg point = square(4);
  add_square(point, 1, {1, 1});
  point.points.push_back({1, 600});
  const std::vector<Warning> warnings = find_warnings(*validate(point));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].kind, WarningKind::far_part);
  EXPECT_EQ(warnings[0].points, (std::vector<Index>{8}));
  EXPECT_EQ(warnings[0].message(1),
            "Point 9 at (1, 600) lies far away from everything else. Without it, the extent of the domain would be 4.");
  Pslg segment = point;
  segment.points.push_back({5, 700});
  segment.segments.push_back({8, 9, 0});
  const std::vector<Warning> of_segment = find_warnings(*validate(segment));
  ASSERT_EQ(of_segment.size(), 2);
  EXPECT_EQ(of_segment[0].segments, (std::vector<Index>{8}));
  EXPECT_TRUE(of_segment[0].message().starts_with("Segment 8 at (5, 700) lies far away from everything else."));
  EXPECT_EQ(of_segment[1].kind, WarningKind::open_outline);
}

TEST(Warnings, name_a_far_point_beside_a_square) {
  Pslg pslg = square(4);
  pslg.points.push_back({1e6, 0});
  const std::vector<Warning> warnings = find_warnings(*validate(pslg));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].points, (std::vector<Index>{4}));
}

TEST(Warnings, are_none_for_parts_at_a_moderate_distance_or_with_more_than_two_points) {
  Pslg near = square(4);
  near.points.insert(near.points.end(), {{1, 100}, {1, 1}});
  EXPECT_TRUE(find_warnings(*validate(near)).empty());
  Pslg island = square(4);
  add_square(island, 1, {10000, 0});
  EXPECT_TRUE(find_warnings(*validate(island)).empty());
}

TEST(Warnings, name_a_single_segment_in_a_hole) {
  Pslg pslg = square(8);
  add_square(pslg, 4, {2, 2});
  pslg.holes = {{3, 3}};
  pslg.points.insert(pslg.points.end(), {{4, 4}, {5, 5}});
  pslg.segments.push_back({8, 9});
  const std::vector<Warning> warnings = find_warnings(*validate(pslg));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_TRUE(warnings[0].message().starts_with("Segment 8 has an open end at (5, 5) and lies outside the domain."));
}

TEST(Warnings, are_not_given_for_cracks_inside_the_domain_nor_for_a_convex_hull) {
  Pslg crack = square(4);
  crack.points.insert(crack.points.end(), {{1, 1}, {2, 2}});
  crack.segments.push_back({4, 5});
  EXPECT_TRUE(find_warnings(*validate(crack)).empty());
  EXPECT_TRUE(find_warnings(*validate(square(4))).empty());
  EXPECT_TRUE(find_warnings(*validate(open_beside_closed(), {.convex_hull = true})).empty());
}

/// A square, turned by quarters, with one point far away in each direction.
TEST(Warnings, name_a_far_point_in_any_direction) {
  for (const Point far : {Point{-1e4, 1}, {1e4, 1}, {1, -1e4}, {1, 1e4}, {-1e4, -1e4}, {1e4, 1e4}})
    for (const bool first : {true, false}) {
      Pslg pslg = square(4);
      if (first) {
        pslg.points.insert(pslg.points.begin(), far);
        for (Segment& s : pslg.segments) ++s.a, ++s.b;
      } else {
        pslg.points.push_back(far);
      }
      const std::vector<Warning> warnings = find_warnings(*validate(pslg));
      ASSERT_EQ(warnings.size(), 1U);
      EXPECT_EQ(warnings[0].kind, WarningKind::far_part);
      EXPECT_EQ(warnings[0].where, far);
      EXPECT_EQ(warnings[0].points, (std::vector<Index>{first ? 0U : 4U}));
      EXPECT_EQ(warnings[0].extent_without, 4);
    }
}

TEST(Warnings, name_the_first_end_of_a_far_segment_whose_ends_are_equally_far) {
  for (const auto& [first, second] : {std::pair(Point{-1e4, 1}, Point{-1e4, 2}),
                                      {Point{1e4, 2}, Point{1e4, 1}},
                                      {Point{1, -1e4}, Point{2, -1e4}},
                                      {Point{2, 1e4}, Point{1, 1e4}}})
    for (const bool turned : {false, true}) {
      Pslg pslg = square(4);
      pslg.points.insert(pslg.points.end(), {first, second});
      pslg.segments.push_back(turned ? Segment{5, 4} : Segment{4, 5});
      const Warning warning = find_warnings(*validate(pslg)).at(0);
      EXPECT_EQ(warning.kind, WarningKind::far_part);
      EXPECT_EQ(warning.where, first);
      EXPECT_EQ(warning.points, turned ? (std::vector<Index>{5, 4}) : (std::vector<Index>{4, 5}));
      EXPECT_EQ(warning.segments, (std::vector<Index>{4}));
    }
}

TEST(Warnings, are_none_for_a_far_end_of_a_segment_that_is_joined_to_the_rest) {
  for (const bool turned : {false, true}) {
    Pslg pslg = square(4);
    add_square(pslg, 1, {1, 1});
    pslg.points.push_back({-1e4, 0});
    pslg.segments.push_back(turned ? Segment{8, 0} : Segment{0, 8});
    for (const Warning& warning : find_warnings(*validate(pslg))) EXPECT_NE(warning.kind, WarningKind::far_part);
  }
}

}  // namespace
}  // namespace pardel
