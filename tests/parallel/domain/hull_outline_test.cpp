// Repair of domains that are the convex hull of their points, with points a little inside of a side of the hull.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "../../../parallel/mesher.hpp"
#include "../../../parallel/repair.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::points_only;

const RepairOptions automatic;

/// A grid of n by n cells, turned around a corner.
Pslg turned_grid(int n, Point corner = {}, double degrees = 17) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) points.push_back({corner.x + c * i - s * j, corner.y + s * i + c * j});
  return points_only(points);
}

void expect_good_mesh(const Pslg& pslg, const RepairOptions& options) {
  const Result<Repaired> repaired = repair(pslg, options);
  ASSERT_TRUE(repaired) << repaired.error().message;
  for (const double angle : {0.0, 20.7, 33.0}) {
    const Result<Meshed> meshed = mesh(repaired->domain, {.min_angle_deg = angle});
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(meshed->report.goal_met()) << angle;
    EXPECT_TRUE(meshed->report.gaps.empty()) << angle;
  }
}

TEST(HullOutline, passes_through_a_point_that_is_a_little_inside_of_a_side) {
  const Pslg pslg = points_only({{0, 0}, {1, 0}, {0.5, 1e-17}, {0.5, 1}});
  for (const std::optional<double> snap : {std::optional<double>(), std::optional(1e-3)}) {
    const Result<Repaired> repaired = repair(pslg, {.snap = snap});
    ASSERT_TRUE(repaired) << repaired.error().message;
    EXPECT_EQ(repaired->domain.pslg().points, pslg.points) << "no point moves";
    EXPECT_EQ(repaired->domain.pslg().segments, (std::vector<Segment>{{0, 2}, {2, 1}, {1, 3}, {3, 0}}));
    EXPECT_EQ(repaired->segment_map, (std::vector<Index>(4, no_index)));
    EXPECT_FALSE(repaired->domain.convex_hull());
    EXPECT_EQ(repaired->log,
              (std::vector<std::string>{"Segments added as the outline, because points are near sides of "
                                        "the convex hull: 4."}));
    expect_good_mesh(pslg, {.snap = snap});
  }
}

TEST(HullOutline, of_a_turned_grid_gives_a_good_mesh) {
  for (const int n : {2, 3, 10, 100}) expect_good_mesh(turned_grid(n), automatic);
  expect_good_mesh(turned_grid(10, {1000, -2000}), automatic);
}

/// From 2 to 100. A number is the rarer, the larger it is.
int some_number_of_cells(generators::Random& random) {
  return static_cast<int>(std::lround(2 * std::pow(50, random.uniform())));
}

TEST(HullOutline, of_grids_at_ten_angles_and_three_offsets_gives_meshes_that_keep_all_bounds) {
  generators::Random random(1);
  for (const double degrees : {1.0, 5.0, 10.0, 17.0, 23.0, 30.0, 33.0, 41.0, 45.0, 60.0})
    for (const double offset : {0.0, 5e5, 1e7})
      for (const int n : {2, 7, 20, some_number_of_cells(random), some_number_of_cells(random)}) {
        const Pslg pslg = turned_grid(n, {offset, offset}, degrees);
        SCOPED_TRACE(std::to_string(n) + " cells at " + std::to_string(degrees) + ", " + std::to_string(offset));
        expect_good_mesh(pslg, automatic);
        const Result<Repaired> repaired = repair(pslg, automatic);
        ASSERT_TRUE(repaired);
        const Result<Meshed> meshed = mesh(repaired->domain, {.max_area = 0.3});
        ASSERT_TRUE(meshed);
        EXPECT_TRUE(meshed->report.goal_met());
      }
}

TEST(HullOutline, joins_the_segments_of_the_domain) {
  Pslg pslg = turned_grid(3);
  pslg.segments = {{0, 15, 1}, {3, 12, 2}, {0, 1, 3}};
  pslg.has_segment_markers = true;
  const Result<Repaired> repaired = repair(pslg, {.convex_hull = true});
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_FALSE(repaired->domain.convex_hull());
  int with_marker = 0;
  for (const Segment& s : repaired->domain.pslg().segments) with_marker += s.marker == 3 ? 1 : 0;
  EXPECT_EQ(with_marker, 1) << "a segment on the hull stays what it is";
  expect_good_mesh(pslg, {.convex_hull = true});
}

TEST(HullOutline, is_not_drawn_if_all_points_near_the_hull_are_exactly_on_it) {
  const Pslg pslg = points_only({{0, 0}, {1, 0}, {0.5, 0}, {0.5, 1}, {0.5, 1e-3}});
  const Result<Repaired> repaired = repair(pslg);
  ASSERT_TRUE(repaired);
  EXPECT_EQ(repaired->domain.pslg(), pslg);
  EXPECT_TRUE(repaired->domain.convex_hull());
  EXPECT_TRUE(repaired->log.empty());
  EXPECT_TRUE(repair(turned_grid(3), {.snap = 0})->domain.convex_hull()) << "no distance counts as near";
}

TEST(HullOutline, stays_the_outline_when_the_domain_is_repaired_again) {
  const Pslg once = repair(turned_grid(3))->domain.pslg();
  for (const bool convex_hull : {false, true}) {
    const Result<Repaired> twice = repair(once, {.convex_hull = convex_hull});
    ASSERT_TRUE(twice);
    EXPECT_EQ(twice->domain.pslg(), once);
    EXPECT_TRUE(twice->log.empty());
    EXPECT_FALSE(twice->domain.convex_hull());
  }
}

TEST(HullOutline, drops_a_hole_that_lies_on_it) {
  Pslg pslg = turned_grid(3);
  pslg.segments = {{5, 6}, {6, 10}, {10, 9}, {9, 5}};
  const Point inside{(pslg.points[5].x + pslg.points[10].x) / 2, (pslg.points[5].y + pslg.points[10].y) / 2};
  pslg.holes = {inside, {pslg.points[1].x * 0.5, pslg.points[1].y * 0.5}};
  const Result<Repaired> repaired = repair(pslg, {.convex_hull = true});
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_EQ(repaired->domain.pslg().holes, std::vector{inside});
}

TEST(HullOutline, says_which_hole_and_region_it_drops) {
  Pslg pslg = points_only({{0, 0}, {1, 0}, {0.5, 1e-17}, {0.5, 1}});
  pslg.holes = {{0.25, 0.5}};
  pslg.regions = {{{0.75, 0.5}, 1, INFINITY}};
  const Result<Repaired> repaired = repair(pslg, {.convex_hull = true});
  ASSERT_TRUE(repaired) << repaired.error().message;
  const std::vector<std::string> log{
      "Segments added as the outline, because points are near sides of the convex hull: 4.",
      "Dropped: Hole 0 at (0.25, 0.5) lies outside every closed outline.",
      "Dropped: Region 0 at (0.75, 0.5) lies outside the domain."};
  EXPECT_EQ(repaired->log, log);
}

/// Corners of the hull are merged, and then it has a side between two corners of the outline that does not pass through
/// the points between them, because these are near another point now.
TEST(HullOutline, is_drawn_once_where_corners_are_merged) {
  const Pslg pslg = points_only({{-3.0000000000000003e-13, 1},
                                 {0.11187198540397125, 3.0000000000000003e-13},
                                 {0, 0},
                                 {4.22492492238018e-14, 0},
                                 {1, 0},
                                 {1, 6.335974997793549e-13},
                                 {1e-13, 1.497157265689426e-13},
                                 {1, 1}});
  const Result<Repaired> repaired = repair(pslg, automatic);
  ASSERT_TRUE(repaired) << repaired.error().message;
  EXPECT_EQ(repaired->domain.pslg().segments.size(), 7);
  const Result<Meshed> meshed = mesh(repaired->domain, {.min_angle_deg = 20.7}, {.max_vertices = 1000});
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_TRUE(meshed->report.goal_met());
}

TEST(HullOutline, is_not_drawn_where_the_hull_is_so_narrow_that_its_sides_fall_into_one) {
  const Pslg needle = points_only({{2e-13, 1e-13},
                                   {3.0000000000000003e-13, 5.825146914884158e-13},
                                   {6.791490498495952e-13, 0.4720875235684545},
                                   {-1e-13, 1},
                                   {0, 7.721659139548161e-13},
                                   {0, 0},
                                   {0, 4.417794889682873e-13}});
  const Pslg tail = points_only({{1.0293631336401676e-13, 2.4537926733038895e-14},
                                 {0.9529649283826015, 0.04640016537810776},
                                 {8.396551508868992e-13, 3.97530050481296e-13},
                                 {0, -3.0000000000000003e-13},
                                 {6.149259055038593e-13, 1},
                                 {3.227571405919092e-13, 0.35010503101118573}});
  for (const Pslg& pslg : {needle, tail}) {
    const Result<Repaired> repaired = repair(pslg, automatic);
    ASSERT_TRUE(repaired) << repaired.error().message;
    EXPECT_TRUE(repaired->domain.pslg().segments.empty());
  }
}

TEST(HullOutline, does_not_bend_to_a_small_part_near_a_side_of_a_huge_hull) {
  Pslg pslg = points_only({{0, 0}, {0x1p50, 0}, {0, 0x1p50}});
  testing::add_square(pslg, 1, {1, 1});
  const Result<Repaired> repaired = repair(pslg, {.convex_hull = true});
  ASSERT_TRUE(repaired);
  EXPECT_EQ(repaired->domain.pslg(), pslg);
  EXPECT_TRUE(repaired->domain.convex_hull());
}

}  // namespace
}  // namespace pardel::engine
