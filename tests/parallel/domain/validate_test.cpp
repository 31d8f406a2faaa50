// find_problems(): one test per kind of problem, with its ids, place and message; and tests of inputs without problems.
#include "../../../parallel/validate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_polygon;
using testing::add_square;
using testing::points_only;
using testing::square;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Ids = std::vector<Index>;

/// The problems of one kind.
std::vector<Problem> of_kind(ProblemKind kind, const Pslg& pslg, const ValidateOptions& options = {}) {
  std::vector<Problem> problems = find_problems(pslg, options);
  std::erase_if(problems, [&](const Problem& p) { return p.kind != kind; });
  return problems;
}

/// Expects one problem and nothing else.
void expect_only(ProblemKind kind, const Ids& ids, Point where, const Pslg& pslg, const ValidateOptions& options = {}) {
  const std::vector<Problem> problems = find_problems(pslg, options);
  ASSERT_EQ(problems.size(), 1) << (problems.empty() ? "no problem" : problems[1].message());
  EXPECT_EQ(problems[0].kind, kind) << problems[0].message();
  EXPECT_EQ(problems[0].ids, ids);
  EXPECT_EQ(problems[0].where, where);
}

TEST(Validate, does_not_call_points_collinear_of_which_one_cannot_be_used) {
  expect_only(ProblemKind::coordinate_out_of_range, {2}, {1e300, 0}, points_only({{0, 0}, {1, 0}, {1e300, 0}}));
  expect_only(ProblemKind::non_finite_coordinate, {2}, {infinity, 0}, points_only({{0, 0}, {1, 0}, {infinity, 0}}));
  expect_only(ProblemKind::coordinate_out_of_range, {1}, {1e300, 0}, points_only({{0, 0}, {1e300, 0}}));
  expect_only(ProblemKind::non_finite_coordinate, {1}, {infinity, 0}, points_only({{0, 0}, {infinity, 0}}));
}

TEST(Validate, finds_no_problem_in_valid_domains) {
  Pslg with_hole = square(4);
  add_square(with_hole, 2, {1, 1});
  with_hole.holes = {{2, 2}};
  with_hole.regions = {{{0.5, 0.5}, 1, 0.25}};
  EXPECT_TRUE(find_problems(with_hole).empty());

  Pslg touching_holes = square(8);
  add_polygon(touching_holes, {{1, 1}, {3, 1}, {3, 3}});
  touching_holes.points.push_back({5, 3});
  touching_holes.points.push_back({5, 5});
  const Index shared = 6;
  touching_holes.segments.insert(touching_holes.segments.end(), {{shared, 7}, {7, 8}, {8, shared}});
  touching_holes.holes = {{2.5, 1.5}, {4.5, 3.5}};
  EXPECT_TRUE(find_problems(touching_holes).empty());

  Pslg fringe = square(4);  // dangling and free segments, isolated points inside and outside
  fringe.points.insert(fringe.points.end(), {{1, 1}, {2, 2}, {3, 2}, {1, 3}, {9, 9}, {0.5, 0.5}});
  fringe.segments.push_back({0, 9});
  fringe.segments.push_back({5, 6});
  EXPECT_TRUE(find_problems(fringe).empty());

  EXPECT_TRUE(find_problems(points_only({{0, 0}, {1, 0}, {0, 1}})).empty());
  EXPECT_TRUE(find_problems(square(4), {.convex_hull = true}).empty());
}

TEST(Validate, reports_a_coordinate_that_is_not_finite) {
  Pslg pslg = square(1);
  pslg.points.push_back({infinity, 0.5});
  expect_only(ProblemKind::non_finite_coordinate, {4}, {infinity, 0.5}, pslg);
  pslg.points[4] = {0.5, nan};
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 1);
  EXPECT_EQ(problems[0].kind, ProblemKind::non_finite_coordinate);
  EXPECT_EQ(problems[0].message(1), "Point 5 at (0.5, nan) has a coordinate that is not a finite number.");
}

TEST(Validate, reports_a_coordinate_that_is_too_large_or_too_small) {
  Pslg pslg = square(1);
  pslg.points.push_back({0.5, 1e300});
  expect_only(ProblemKind::coordinate_out_of_range, {4}, {0.5, 1e300}, pslg);
  pslg.points[4] = {1e-300, 0.5};
  expect_only(ProblemKind::coordinate_out_of_range, {4}, {1e-300, 0.5}, pslg);
}

TEST(Validate, reports_a_wrong_number_of_attributes_or_markers) {
  Pslg pslg = square(1);
  pslg.attributes_per_point = 2;
  pslg.point_attributes.resize(7);
  expect_only(ProblemKind::wrong_count, {}, {}, pslg);
  pslg.point_attributes.resize(8);
  EXPECT_TRUE(find_problems(pslg).empty());
  pslg.point_markers = {1, 2, 3};
  expect_only(ProblemKind::wrong_count, {}, {}, pslg);
}

TEST(Validate, reports_a_segment_whose_end_is_no_point) {
  Pslg pslg = square(1);
  pslg.segments.push_back({0, 4});
  pslg.segments.push_back({no_index, 2});
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 2);
  EXPECT_EQ(problems[0].kind, ProblemKind::index_out_of_range);
  EXPECT_EQ(problems[0].ids, Ids{4});
  EXPECT_EQ(problems[1].ids, Ids{5});
  EXPECT_EQ(problems[0].message(1), "Segment 5 names a point that does not exist.");
}

TEST(Validate, reports_every_duplicate_of_a_point) {
  Pslg pslg = square(1);
  pslg.points.insert(pslg.points.end(), {{1, 1}, {-0.0, 0.0}, {1, 1}});
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 3);
  for (const Problem& p : problems) EXPECT_EQ(p.kind, ProblemKind::duplicate_points);
  EXPECT_EQ(problems[0].ids, (Ids{0, 5}));
  EXPECT_EQ(problems[1].ids, (Ids{2, 4}));
  EXPECT_EQ(problems[2].ids, (Ids{2, 6}));
  EXPECT_EQ(problems[1].where, (Point{1, 1}));
  EXPECT_EQ(problems[1].message(), "Points 2 and 4 are both at (1, 1).");
}

TEST(Validate, reports_a_segment_without_length) {
  Pslg pslg = square(1);
  pslg.segments.push_back({2, 2});
  expect_only(ProblemKind::zero_length_segment, {4}, {1, 1}, pslg);
  pslg.points.push_back({1, 1});
  pslg.segments[4] = {2, 4};
  EXPECT_EQ(of_kind(ProblemKind::zero_length_segment, pslg)[0].ids, Ids{4});
}

TEST(Validate, reports_segments_with_the_same_ends) {
  Pslg pslg = square(1);
  pslg.segments.push_back({2, 1});
  pslg.segments.push_back({1, 2});
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 2);
  EXPECT_EQ(problems[0].kind, ProblemKind::duplicate_segments);
  EXPECT_EQ(problems[0].ids, (Ids{1, 4}));
  EXPECT_EQ(problems[1].ids, (Ids{1, 5}));
  EXPECT_EQ(problems[0].where, (Point{1, 0}));
}

TEST(Validate, reports_segments_whose_ends_are_equal_points_as_duplicates) {
  Pslg pslg = square(1);
  pslg.points.push_back({1, 1});
  pslg.segments.push_back({4, 1});
  EXPECT_EQ(of_kind(ProblemKind::duplicate_segments, pslg)[0].ids, (Ids{1, 4}));
  EXPECT_TRUE(of_kind(ProblemKind::overlapping_segments, pslg).empty());
}

TEST(Validate, reports_crossing_segments_with_the_crossing) {
  Pslg pslg = square(4);
  pslg.segments.push_back({0, 2});
  pslg.segments.push_back({1, 3});
  expect_only(ProblemKind::crossing_segments, {4, 5}, {2, 2}, pslg);
  EXPECT_EQ(find_problems(pslg)[0].message(1), "Segments 5 and 6 cross at (2, 2).");
}

TEST(Validate, distinguishes_a_crossing_from_a_miss_by_one_rounding) {
  Pslg pslg = square(1);
  const double x = 0.7;
  pslg.points.insert(pslg.points.end(), {{0.1, 0.1}, {0.9, 0.9}, {x, x}, {0.8, 0.2}});
  pslg.segments.push_back({4, 5});
  pslg.segments.push_back({6, 7});
  expect_only(ProblemKind::point_on_segment, {6, 4}, {x, x}, pslg);
  pslg.points[6].y = std::nextafter(x, 0.0);
  EXPECT_TRUE(find_problems(pslg).empty());
  pslg.points[6].y = std::nextafter(x, 1.0);
  expect_only(ProblemKind::crossing_segments, {4, 5}, {x, x}, pslg);
}

TEST(Validate, reports_overlapping_segments_and_the_ends_inside_them) {
  Pslg pslg = square(8);
  pslg.points.insert(pslg.points.end(), {{1, 4}, {5, 4}, {3, 4}, {7, 4}});
  pslg.segments.push_back({4, 5});
  pslg.segments.push_back({7, 6});
  const auto overlaps = of_kind(ProblemKind::overlapping_segments, pslg);
  ASSERT_EQ(overlaps.size(), 1);
  EXPECT_EQ(overlaps[0].ids, (Ids{4, 5}));
  EXPECT_EQ(overlaps[0].where, (Point{3, 4}));
  const auto inside = of_kind(ProblemKind::point_on_segment, pslg);
  ASSERT_EQ(inside.size(), 2);
  EXPECT_EQ(inside[0].ids, (Ids{5, 5}));
  EXPECT_EQ(inside[1].ids, (Ids{6, 4}));
}

TEST(Validate, reports_segments_that_overlap_from_a_common_end) {
  Pslg pslg = square(8);
  pslg.points.push_back({8, 8});
  pslg.points[4] = {4, 4};
  pslg.segments.push_back({0, 4});
  pslg.segments.push_back({0, 2});
  EXPECT_EQ(of_kind(ProblemKind::overlapping_segments, pslg)[0].ids, (Ids{4, 5}));
  EXPECT_EQ(of_kind(ProblemKind::point_on_segment, pslg)[0].ids, (Ids{4, 5}));
}

TEST(Validate, lets_collinear_segments_meet_at_an_end) {
  Pslg pslg = square(8);
  pslg.points.push_back({4, 4});
  pslg.segments.push_back({0, 4});
  pslg.segments.push_back({4, 2});
  EXPECT_TRUE(find_problems(pslg).empty());
}

TEST(Validate, reports_a_point_inside_a_segment) {
  Pslg pslg = square(4);
  pslg.points.push_back({4, 1});
  expect_only(ProblemKind::point_on_segment, {4, 1}, {4, 1}, pslg);
  EXPECT_EQ(find_problems(pslg)[0].message(), "Point 4 at (4, 1) lies in the interior of segment 1.");
}

TEST(Validate, reports_a_point_inside_two_segments_once_for_each) {
  Pslg pslg = square(4);
  pslg.points.push_back({2, 2});
  pslg.segments.push_back({0, 2});
  pslg.segments.push_back({1, 3});
  const auto inside = of_kind(ProblemKind::point_on_segment, pslg);
  ASSERT_EQ(inside.size(), 2);
  EXPECT_EQ(inside[0].ids, (Ids{4, 4}));
  EXPECT_EQ(inside[1].ids, (Ids{4, 5}));
  EXPECT_EQ(of_kind(ProblemKind::crossing_segments, pslg).size(), 1);
}

TEST(Validate, reports_points_that_are_too_few_or_on_one_line) {
  expect_only(ProblemKind::all_points_collinear, {}, {}, {});
  expect_only(ProblemKind::all_points_collinear, {}, {1, 2}, points_only({{1, 2}, {3, 4}}));
  Pslg line = points_only({{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}});
  line.segments = {{0, 1}, {1, 2}};
  expect_only(ProblemKind::all_points_collinear, {}, {0.1, 0.1}, line);
  line.points[1].x = std::nextafter(0.3, 1.0);
  EXPECT_TRUE(of_kind(ProblemKind::all_points_collinear, line).empty());
}

TEST(Validate, reports_an_outline_that_is_not_closed) {
  Pslg pslg = square(4);
  pslg.segments.pop_back();
  expect_only(ProblemKind::unclosed_outline, {}, {0, 0}, pslg);
  EXPECT_TRUE(find_problems(pslg, {.convex_hull = true}).empty());
}

TEST(Validate, reports_holes_that_leave_no_domain) {
  Pslg pslg = square(4);
  pslg.points.push_back({2, 2});
  pslg.segments.push_back({0, 2});
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 2}};
  pslg.holes = {{1, 3}};
  EXPECT_TRUE(find_problems(pslg).empty());
  pslg.holes.push_back({3, 1});
  expect_only(ProblemKind::no_domain, {0, 1}, {1, 3}, pslg);
}

TEST(Validate, reports_a_hole_outside) {
  Pslg pslg = square(4);
  pslg.holes = {{5, 2}};
  expect_only(ProblemKind::hole_outside, {0}, {5, 2}, pslg);
  EXPECT_EQ(find_problems(pslg)[0].message(), "Hole 0 at (5, 2) lies outside every closed outline.");
  pslg.holes = {{1e300, 2}};
  expect_only(ProblemKind::hole_outside, {0}, {1e300, 2}, pslg);
  pslg.holes = {{nan, 2}};
  EXPECT_EQ(of_kind(ProblemKind::hole_outside, pslg)[0].ids, Ids{0});
}

TEST(Validate, names_only_the_holes_that_leave_no_domain) {
  Pslg pslg = square(4);
  pslg.holes = {{5, 2}, {1, 1}, {6, 2}, {2, 3}};
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].message(),
            "Nothing is left to mesh: every face contains a hole (1 and 3), the first at (1, 1).");
  EXPECT_EQ(problems[1].message(), "Hole 0 at (5, 2) lies outside every closed outline.");
  EXPECT_EQ(problems[2].message(), "Hole 2 at (6, 2) lies outside every closed outline.");
}

TEST(Validate, reports_a_hole_on_a_segment_or_on_a_point_of_one) {
  Pslg pslg = square(4);
  pslg.holes = {{4, 2}};
  expect_only(ProblemKind::hole_on_segment, {0, 1}, {4, 2}, pslg);
  pslg.holes = {{4, 4}};
  EXPECT_EQ(of_kind(ProblemKind::hole_on_segment, pslg).size(), 1);
  pslg.holes = {{std::nextafter(4.0, 5.0), 2}};
  EXPECT_EQ(of_kind(ProblemKind::hole_outside, pslg).size(), 1);
}

TEST(Validate, reports_a_region_outside_the_domain) {
  Pslg pslg = square(4);
  add_square(pslg, 2, {1, 1});
  pslg.holes = {{2, 2}};
  pslg.regions = {{{0.5, 0.5}}, {{2, 2.5}}, {{7, 7}}};
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 2);
  EXPECT_EQ(problems[0].kind, ProblemKind::region_outside);
  EXPECT_EQ(problems[0].ids, Ids{1});
  EXPECT_EQ(problems[1].ids, Ids{2});
  EXPECT_EQ(problems[1].where, (Point{7, 7}));
}

TEST(Validate, reports_a_region_on_a_segment) {
  Pslg pslg = square(4);
  pslg.regions = {{{2, 0}}};
  expect_only(ProblemKind::region_on_segment, {0, 0}, {2, 0}, pslg);
}

TEST(Validate, reports_regions_that_share_a_face) {
  Pslg pslg = square(4);
  pslg.regions = {{{1, 1}}, {{3, 3}}};
  expect_only(ProblemKind::regions_share_face, {0, 1}, {3, 3}, pslg);
  pslg.segments.push_back({1, 3});
  EXPECT_TRUE(find_problems(pslg).empty());
}

TEST(Validate, reports_an_area_cap_that_is_not_positive) {
  Pslg pslg = square(4);
  for (const double cap : {nan, 0.0, -1.0}) {
    pslg.regions = {{{1, 1}, 0, cap}};
    expect_only(ProblemKind::bad_region_cap, {0}, {1, 1}, pslg);
  }
}

TEST(Validate, includes_pockets_of_the_hull_in_the_domain_when_the_hull_is_the_outline) {
  Pslg wedge;  // a reflex corner: the pocket is the triangle 0, 1, 2
  add_polygon(wedge, {{0, 0}, {2, 3}, {4, 0}, {4, 4}, {0, 4}});
  wedge.regions = {{{2, 1}}};
  expect_only(ProblemKind::region_outside, {0}, {2, 1}, wedge);
  EXPECT_TRUE(find_problems(wedge, {.convex_hull = true}).empty());
  wedge.holes = {{2, 3.5}};
  EXPECT_TRUE(find_problems(wedge, {.convex_hull = true}).empty());
  wedge.holes.push_back({2, 0.5});
  wedge.regions.clear();
  expect_only(ProblemKind::no_domain, {0, 1}, {2, 3.5}, wedge, {.convex_hull = true});
}

TEST(Validate, takes_the_hull_of_points_without_segments_for_the_outline) {
  Pslg pslg = points_only({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}});
  pslg.regions = {{{2, 3}}};
  EXPECT_TRUE(find_problems(pslg).empty());
  pslg.regions[0].seed = {3, 0};
  expect_only(ProblemKind::region_on_segment, {0}, {3, 0}, pslg);
  EXPECT_EQ(find_problems(pslg)[0].message(), "Region 0 at (3, 0) lies on the convex hull.");
  pslg.regions[0].seed = {5, 0};
  expect_only(ProblemKind::region_outside, {0}, {5, 0}, pslg);
}

TEST(Validate, finds_holes_in_islands_of_islands) {
  Pslg pslg = square(10);
  for (int depth = 1; depth < 5; ++depth) add_square(pslg, 10 - 2 * depth, {1.0 * depth, 1.0 * depth});
  pslg.holes = {{1.5, 1.5}, {3.5, 3.5}};
  pslg.regions = {{{0.5, 0.5}}, {{2.5, 2.5}}, {{4.5, 4.5}}};
  EXPECT_TRUE(find_problems(pslg).empty());
  pslg.regions.push_back({{1.25, 5}});
  expect_only(ProblemKind::region_outside, {3}, {1.25, 5}, pslg);
}

TEST(Validate, orders_problems_by_kind_and_ids) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{4, 0}, {nan, 0}, {1, 4}});
  pslg.segments.insert(pslg.segments.end(), {{1, 3}, {0, 2}, {2, 2}, {0, 99}});
  const auto problems = find_problems(pslg);
  ASSERT_EQ(problems.size(), 6);
  for (std::size_t i = 1; i < problems.size(); ++i)
    EXPECT_TRUE(problems[i - 1].kind < problems[i].kind ||
                (problems[i - 1].kind == problems[i].kind && problems[i - 1].ids < problems[i].ids));
}

TEST(Validate, stops_at_the_largest_number_of_problems_of_a_kind) {
  Pslg pslg = square(101);
  for (int i = 1; i <= 100; ++i) {
    const Index n = static_cast<Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {{0.5, 1.0 * i}, {100.5, 101.0 - i}, {1.0 * i, 50}, {1.0 * i, 50}});
    pslg.segments.push_back({n, n + 1});
  }
  EXPECT_EQ(of_kind(ProblemKind::duplicate_points, pslg, {.max_problems = 7}).size(), 7);
  EXPECT_LE(of_kind(ProblemKind::crossing_segments, pslg, {.max_problems = 7}).size(), 7);
  EXPECT_GT(of_kind(ProblemKind::crossing_segments, pslg).size(), 4000);
}

TEST(Validate, works_far_from_the_origin) {
  Pslg pslg = square(1);
  for (Point& p : pslg.points) p = {p.x + 654321, p.y + 4987654};
  pslg.holes = {{654323, 4987654.5}};
  expect_only(ProblemKind::hole_outside, {0}, {654323, 4987654.5}, pslg);
}

TEST(Validate, has_a_name_and_a_message_for_every_kind) {
  for (int k = 0; k <= static_cast<int>(ProblemKind::cancelled); ++k) {
    const Problem problem{static_cast<ProblemKind>(k), {2, 5}, {0.1, -1e22}};
    EXPECT_STRNE(name(problem.kind), "unknown");
    EXPECT_EQ(problem.message().back(), '.');
    EXPECT_EQ(problem.message().find('_'), std::string::npos);
  }
}

TEST(Validate, lists_at_most_eight_ids_in_a_message) {
  const std::vector<std::pair<Ids, std::string>> cases = {{{7}, "7"},
                                                          {{7, 4}, "7 and 4"},
                                                          {{7, 4, 9}, "7, 4, 9"},
                                                          {{0, 1, 2, 3, 4, 5, 6, 7}, "0, 1, 2, 3, 4, 5, 6, 7"},
                                                          {{0, 1, 2, 3, 4, 5, 6, 7, 8}, "0, 1, 2, 3, 4, 5, 6, 7, ..."}};
  for (const auto& [ids, list] : cases)
    EXPECT_EQ((Problem{ProblemKind::no_domain, ids, {2, 3}}.message()),
              "Nothing is left to mesh: every face contains a hole (" + list + "), the first at (2, 3).");
}

TEST(Validate, does_not_compare_segments_that_end_at_an_unusable_point) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const bool turned : {false, true}) {
      Pslg pslg = testing::square(4);
      pslg.points.insert(pslg.points.end(), {{1, 1}, {bad, 2}});
      pslg.segments.push_back(turned ? Segment{5, 4} : Segment{4, 5});
      const std::vector<Problem> problems = find_problems(pslg);
      ASSERT_EQ(problems.size(), 1U);
      EXPECT_EQ(problems[0].kind, ProblemKind::non_finite_coordinate);
      EXPECT_EQ(problems[0].ids, std::vector<Index>{5});
    }
}

TEST(Validate, reports_the_first_point_inside_a_segment) {
  Pslg pslg = points_only({{2, 0}});
  add_square(pslg, 4, {0, 0});
  expect_only(ProblemKind::point_on_segment, {0, 0}, {2, 0}, pslg);
}

TEST(Validate, names_no_segment_if_a_seed_lies_on_a_side_of_the_hull) {
  for (const Point on_side : {Point{1, 0}, Point{4, 1}, Point{3, 4}, Point{0, 3}}) {
    Pslg corners = points_only({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    corners.regions = {{on_side}};
    expect_only(ProblemKind::region_on_segment, {0}, on_side, corners);
    corners.points.insert(corners.points.end(), {{1, 2}, {3, 2}});
    corners.segments = {{4, 5}};
    expect_only(ProblemKind::region_on_segment, {0}, on_side, corners, {.convex_hull = true});
  }
}

TEST(Validate, does_not_compare_segments_that_end_out_of_range) {
  for (const bool turned : {false, true}) {
    Pslg pslg = square(4);
    pslg.points.insert(pslg.points.end(), {{1, 1}, {0x1p201, 1}});
    pslg.segments.push_back(turned ? Segment{5, 4} : Segment{4, 5});
    expect_only(ProblemKind::coordinate_out_of_range, {5}, {0x1p201, 1}, pslg);
  }
}

}  // namespace
}  // namespace pardel::engine
