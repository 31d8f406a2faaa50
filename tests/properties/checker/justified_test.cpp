// Which triangles the checker considers justified by a small input angle, and which not.
#include <cmath>

#include "../../../properties/checker/check.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "cgal_meshes.hpp"
#include "verdicts.hpp"

namespace pardel::checker {
namespace {

using Kind = ViolationKind;
using testing::Case;
using testing::count;
using testing::is_valid;
using testing::reports;
using testing::reports_only;

/// A wedge with its apex at the origin. The second leg is a quarter longer; both legs have a vertex at distance 1.
Case wedge_with_shell(double degrees = 10, double leg = 2) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  Case c;
  c.pslg.points = {{0, 0}, {leg, 0}, {1.25 * leg * std::cos(angle), 1.25 * leg * std::sin(angle)}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  std::vector<Point> points = c.pslg.points;
  points.push_back({1, 0});
  points.push_back({std::cos(angle), std::sin(angle)});
  c.mesh = testing::mesh_of(points, {{0, 3, 4}, {3, 1, 4}, {1, 2, 4}});
  c.mesh.origin[3] = origin_on_segment(0);
  c.mesh.origin[4] = origin_on_segment(2);
  c.mesh.constrained_edges = {{0, 3, 0, 1}, {3, 1, 0, 1}, {1, 2, 1, 1}, {2, 4, 2, 1}, {4, 0, 2, 1}};
  return c;
}

TEST(Check, justifies_triangles_at_a_small_input_angle) {
  Goal goal;
  goal.min_angle_deg = 9.8;
  EXPECT_EQ(check(wedge_with_shell(), goal).justified.size(), 1u) << "3-1-4 has an angle of 9.7 degrees";
  goal.min_angle_deg = 15;
  const Certificate certificate = check(wedge_with_shell(), goal);
  EXPECT_TRUE(is_valid(certificate));
  ASSERT_EQ(certificate.justified.size(), 2u);
  EXPECT_EQ(certificate.justified[0].triangle, 0u) << "nestled";
  EXPECT_EQ(certificate.justified[1].triangle, 1u) << "seditious: the ends of 3-4 lie on one shell";
  for (const Justified& j : certificate.justified) {
    EXPECT_EQ(j.apex, 0u);
    EXPECT_NEAR(j.input_angle_deg, 10, 1e-12);
  }
}

TEST(Check, justifies_no_small_angle_by_a_larger_angle_of_the_domain_in_the_same_triangle) {
  // Triangle 0-1-2 has an angle of 12 degrees at vertex 1, and one of 63 degrees between segments at vertex 0.
  for (const double side : {1.0, -1.0}) {
    Case c;
    c.pslg.points = {{0, 0}, {10, 0}, {1, 2 * side}, {10, 10 * side}};
    c.pslg.segments = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    c.mesh = side > 0 ? testing::mesh_of(c.pslg.points, {{0, 1, 2}, {1, 3, 2}})
                      : testing::mesh_of(c.pslg.points, {{0, 2, 1}, {1, 2, 3}});
    c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 3, 1, 1}, {3, 2, 2, 1}, {2, 0, 3, 1}};
    Goal goal;
    goal.min_angle_deg = 20;
    EXPECT_TRUE(reports_only(check(c, goal), Kind::small_angle));
  }
}

TEST(Check, justifies_each_of_two_small_angles_by_a_cause_of_its_own) {
  // Triangle 0-1-2 has angles of 14 degrees at vertices 0 and 2. Only the angle at vertex 0 is one of the domain, until
  // the edge 1-2 is a segment.
  for (const double side : {1.0, -1.0}) {
    Case c;
    c.pslg.points = {{0, 0}, {4, side}, {8, 0}, {8, 4 * side}};
    c.pslg.segments = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    c.mesh = side < 0 ? testing::mesh_of(c.pslg.points, {{0, 1, 2}, {1, 3, 2}})
                      : testing::mesh_of(c.pslg.points, {{0, 2, 1}, {1, 2, 3}});
    c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 3, 1, 1}, {3, 2, 2, 1}, {2, 0, 3, 1}};
    Goal goal;
    goal.min_angle_deg = 20;
    const Certificate unjustified = check(c, goal);
    EXPECT_TRUE(reports_only(unjustified, Kind::small_angle));
    EXPECT_TRUE(unjustified.justified.empty());
    ASSERT_EQ(unjustified.violations.size(), 1U);
    EXPECT_EQ(unjustified.violations[0].where[0], c.pslg.points[2]);
    c.pslg.segments.push_back({1, 2});
    c.mesh.constrained_edges.push_back({1, 2, 4, 0});
    const Certificate certificate = check(c, goal);
    EXPECT_TRUE(is_valid(certificate));
    ASSERT_EQ(certificate.justified.size(), 1U);
  }
}

TEST(Check, justifies_no_angle_across_a_shell_that_is_smaller_than_the_next_shell_explains) {
  Goal goal;
  goal.min_angle_deg = 15;
  EXPECT_EQ(count(check(wedge_with_shell(10, 2), goal), Kind::small_angle), 0U);
  for (const double leg : {2.1, 4.0, 1000.0, 1e6})
    EXPECT_GE(count(check(wedge_with_shell(10, leg), goal), Kind::small_angle), 1U) << leg;
}

TEST(Check, justifies_nothing_by_input_points_at_equal_distances) {
  // The ends of the two legs have the distance 65 from the apex, and 1-2-3 an angle of 1 degree at vertex 3.
  Case c;
  c.pslg.points = {{0, 0}, {63, 16}, {60, 25}, {585, 200}};
  c.pslg.segments = {{0, 1}, {0, 2}, {1, 3}, {3, 2}};
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}, {1, 3, 2}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {0, 2, 1, 1}, {1, 3, 2, 1}, {3, 2, 3, 1}};
  Goal goal;
  goal.min_angle_deg = 20;
  EXPECT_TRUE(is_valid(check(c, goal))) << "the angle at vertex 3 lies between two segments";
  c.pslg.segments[2] = {1, 4};
  c.pslg.segments.push_back({4, 3});
  c.pslg.points.push_back({600, 100});
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}, {1, 3, 2}, {1, 4, 3}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {0, 2, 1, 1}, {1, 4, 2, 1}, {3, 2, 3, 1}, {4, 3, 4, 1}};
  EXPECT_TRUE(reports(check(c, goal), Kind::small_angle));
}

PARDEL_FACT(
    Check, justifies_nothing_that_is_not_on_one_shell,
    {.statement = "a triangle outside the corner of two segments is not justified by their small angle if none of its "
                  "edges joins points of both segments at the same distance from the corner",
     .source = "properties/checker/stages/justified.cpp",
     .families = "a wedge of 10 degrees, its legs cut at 1 and at 1.1"}) {
  Case c = wedge_with_shell();
  const double farther = 1.1;  // the angle across is larger than on one shell, so it is large enough
  c.mesh.points[4] = {c.mesh.points[4].x * farther, c.mesh.points[4].y * farther};
  Goal goal;
  goal.min_angle_deg = 15;
  EXPECT_TRUE(reports(check(c, goal), Kind::small_angle));
  facts.cases = 1;
}

PARDEL_FACT(
    Check, justifies_nothing_at_a_large_input_angle,
    {.statement = "where no input angle is below 60 degrees, a triangle with an angle below the bound is reported",
     .source = "properties/checker/stages/justified.cpp",
     .families = "a sliver on a side of a square; a corner of 90 degrees cut at one distance"}) {
  // A sliver far from any small input angle.
  Case c;
  c.pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  c.pslg.points.push_back({2, 0.125});
  c.mesh = testing::triangulated_by_cgal(c.pslg);
  Goal goal;
  goal.min_angle_deg = 20;
  const Certificate certificate = check(c, goal);
  EXPECT_TRUE(reports_only(certificate, Kind::small_angle));
  EXPECT_TRUE(certificate.justified.empty());
  // The ends of the shortest edge of 3-1-4 have the same distance from a common apex, but the angle there is a right
  // angle.
  goal.min_angle_deg = 15;
  EXPECT_TRUE(reports(check(wedge_with_shell(90, 8), goal), Kind::small_angle));
  facts.cases = 2;
}

}  // namespace
}  // namespace pardel::checker
