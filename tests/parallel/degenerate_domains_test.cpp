// Difficult inputs: refinement ends on each of them, and the mesh is certified. The floor is the shortest allowed edge.
// Triangles are exempt because of a small input angle or, only at the limit of double precision, because of the floor.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../../parallel/arithmetic/floor.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "on_segment.hpp"
#include "samples.hpp"

namespace pardel::engine {
namespace {

void add_closed(Pslg& pslg, const std::vector<Point>& outline) {
  const auto first = static_cast<Index>(pslg.points.size()), n = static_cast<Index>(outline.size());
  pslg.points.insert(pslg.points.end(), outline.begin(), outline.end());
  for (Index i = 0; i < n; ++i) pslg.segments.push_back({first + i, first + (i + 1) % n});
}

void add_segment(Pslg& pslg, Point a, Point b) {
  const auto first = static_cast<Index>(pslg.points.size());
  pslg.points.insert(pslg.points.end(), {a, b});
  pslg.segments.push_back({first, first + 1});
}

Pslg box(double low, double high) {
  Pslg pslg;
  add_closed(pslg, {{low, low}, {high, low}, {high, high}, {low, high}});
  return pslg;
}

/// Meshes the domain at each angle. Expects that all exemptions are justified and that the checker agrees.
void expect_certified(const Pslg& pslg, std::initializer_list<double> angles = {20.7, 30.0, 33.0}) {
  for (const bool conforming : {false, true})
    for (const double angle : angles) {
      SCOPED_TRACE(std::to_string(angle) + (conforming ? " conforming" : ""));
      const Goal goal{.min_angle_deg = angle, .conforming = conforming};
      const Result<Meshed> meshed = mesh(pslg, goal);
      ASSERT_TRUE(meshed) << meshed.error().message;
      EXPECT_TRUE(meshed->report.goal_met()) << meshed->report.count(ExemptReason::precision) << " precision, "
                                             << meshed->report.count(ExemptReason::min_edge) << " min_edge, of "
                                             << meshed->mesh.triangles.size() << " triangles";
      const Certificate certificate = check(pslg, meshed->mesh, goal, {.max_violations = 2});
      EXPECT_TRUE(certificate.valid) << to_text(certificate);
    }
}

TEST(TinyAngle, of_the_outline_ends) {
  for (const double degrees : {10.0, 1.0, 0.1, 0.01}) {
    SCOPED_TRACE(degrees);
    const double t = std::tan(degrees * std::numbers::pi / 180);
    Pslg pslg;
    add_closed(pslg, {{0, 0}, {1, 0}, {1, t}});
    expect_certified(pslg);
  }
}

TEST(TinyAngle, between_segments_of_unlike_lengths_ends) {
  for (const double degrees : {30.0, 3.0, 0.1, 0.01}) {
    SCOPED_TRACE(degrees);
    const double a = degrees * std::numbers::pi / 180;
    Pslg pslg = box(-2, 2);
    pslg.points.insert(pslg.points.end(), {{0, 0}, {1.3, 0}, {0.37 * std::cos(a), 0.37 * std::sin(a)}});
    pslg.segments.insert(pslg.segments.end(), {{4, 5}, {4, 6}});
    expect_certified(pslg);
  }
}

/// A point near a long segment, joined to both ends of the segment. No vertex of the segment was beside the point, and
/// edges became as short as the gap between the two. No vertex fits beside the point if the gap is below about 1e-11.
TEST(TinyAngle, at_both_ends_of_a_long_segment_needs_few_triangles) {
  samples::Random random(3);
  for (double gap = 1e-2; gap > 1e-18; gap /= 30)
    for (int i = 0; i < 4; ++i) {
      SCOPED_TRACE(gap);
      const Point a{random.uniform(-1, 0), random.uniform(-1, 1)}, b{random.uniform(0.5, 1), random.uniform(-1, 1)};
      const double part = random.uniform(0.05, 0.95);
      const Point near{a.x + part * (b.x - a.x) - gap * (b.y - a.y), a.y + part * (b.y - a.y) + gap * (b.x - a.x)};
      Pslg pslg = box(-2, 2);
      pslg.points.insert(pslg.points.end(), {a, b, near});
      pslg.segments.insert(pslg.segments.end(), {{4, 5}, {4, 6}, {6, 5}});
      if (orient2d(a, b, near) == 0) continue;
      const Result<Meshed> meshed = mesh(pslg, {.min_angle_deg = 28}, {.max_vertices = 5000});
      ASSERT_TRUE(meshed) << meshed.error().message;
      EXPECT_LT(meshed->mesh.triangles.size(), 600U);
      EXPECT_TRUE(check(pslg, meshed->mesh, {.min_angle_deg = gap < 1e-11 ? 0.0 : 28.0}).valid);
      const std::uint64_t missed =
          meshed->report.count(ExemptReason::precision) + meshed->report.count(ExemptReason::min_edge);
      EXPECT_LE(missed, gap < 1e-11 ? 4U : 0U);
    }
}

TEST(TinyAngle, whose_gap_is_below_the_floor_does_not_keep_a_segment_whole) {
  Pslg pslg = box(-2, 2);
  pslg.points.insert(pslg.points.end(), {{-1, 0}, {1, 0}, {0.3, 1e-5}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {4, 6}, {6, 5}});
  const Goal goal{.min_angle_deg = 0, .max_area = 0.05};
  const Result<Meshed> meshed = mesh(pslg, goal, {.min_edge = 1e-3});
  ASSERT_TRUE(meshed) << meshed.error().message;
  const Index passing_the_point = 4;
  EXPECT_GT(std::ranges::count(meshed->mesh.constrained_edges, passing_the_point, &ConstrainedEdge::segment), 1);
}

TEST(TinyAngle, chained_from_segment_to_segment_ends) {
  // A zigzag with sharp corners: a split at one corner encroaches on segments at the next.
  for (const double height : {0.5, 0.05, 0.002}) {
    SCOPED_TRACE(height);
    Pslg pslg = box(-1, 9);
    const auto first = static_cast<Index>(pslg.points.size());
    for (Index i = 0; i < 9; ++i) {
      pslg.points.push_back({i % 2 == 0 ? 0.5 : 7.5 - 0.3 * i, 1 + i * height});
      if (i > 0) pslg.segments.push_back({first + i - 1, first + i});
    }
    expect_certified(pslg);
  }
}

TEST(Hub, of_many_segments_ends) {
  for (const int spokes : {7, 60, 360}) {
    SCOPED_TRACE(spokes);
    Pslg pslg = box(-2, 2);
    pslg.points.push_back({0, 0});
    for (int i = 0; i < spokes; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.1) / spokes, length = 1 + 0.4 * std::sin(7.0 * i);
      pslg.points.push_back({length * std::cos(angle), length * std::sin(angle)});
      pslg.segments.push_back({4, static_cast<Index>(pslg.points.size() - 1)});
    }
    expect_certified(pslg);
  }
}

TEST(Parallels, that_nearly_touch_end) {
  for (const double gap : {1e-4, 1e-6, 1e-9}) {
    SCOPED_TRACE(gap);
    Pslg pslg = box(0, 1);
    // The segments are a thousand times as long as the gap. The triangles between them must be as small as the gap.
    add_segment(pslg, {0.5, 0.5}, {0.5 + 1000 * gap, 0.5});
    add_segment(pslg, {0.5 + 300 * gap, 0.5 + gap}, {0.5 + 1300 * gap, 0.5 + gap});
    expect_certified(pslg, {20.7, 30.0});
  }
}

TEST(NearDuplicates, end) {
  for (const double distance : {1e-6, 1e-9, 1e-12}) {
    SCOPED_TRACE(distance);
    Pslg pslg = box(0, 1);
    pslg.points.insert(pslg.points.end(), {{0.3, 0.4}, {0.3 + distance, 0.4}, {0.7, 0.7}, {0.7, 0.7 + distance}});
    expect_certified(pslg);
  }
}

TEST(Rectangle, a_million_times_as_long_as_wide_ends) {
  Pslg pslg;
  add_closed(pslg, {{0, 0}, {1e5, 0}, {1e5, 1}, {0, 1}});
  expect_certified(pslg, {20.7});
  Pslg high;
  add_closed(high, {{0, 0}, {1e-4, 0}, {1e-4, 10}, {0, 10}});
  expect_certified(high, {20.7});
}

TEST(Circle, of_a_thousand_points_ends_with_and_without_segments) {
  std::vector<Point> circle;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1000;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  Pslg outline;
  add_closed(outline, circle);
  expect_certified(outline);
  Pslg points;
  points.points = circle;
  expect_certified(points);
}

TEST(Scale, of_any_power_of_two_ends) {
  for (const std::string& name : domains::even_names())
    for (const double scale : {0x1p60, 0x1p-60, 0x1p150, 0x1p-100}) {
      SCOPED_TRACE(name + " times " + std::to_string(std::log2(scale)) + " octaves");
      const Pslg pslg = domains::moved(*domains::generate(name, 0, 1), 0, 0, scale);
      const Goal goal{.min_angle_deg = 30, .region_caps = false};
      const Result<Meshed> meshed = mesh(pslg, goal);
      ASSERT_TRUE(meshed) << meshed.error().message;
      EXPECT_TRUE(meshed->report.goal_met());
      EXPECT_TRUE(check(pslg, meshed->mesh, goal).valid);
    }
}

/// A domain of side 2^10 about (2^40, 2^40), where doubles are 2^-12 apart and the floor on edges is 2^-2.
TEST(FarOffset, of_two_to_the_fortieth_ends) {
  Pslg pslg = box(0, 1024);
  add_segment(pslg, {200, 300}, {700, 400});
  pslg.points.push_back({512, 900});
  pslg.segments.push_back({4, 6});
  expect_certified(domains::moved(pslg, 0x1p40, 0x1p40), {20.7, 30.0});
}

/// If the details of the input are as small as the spacing of doubles, refinement ends at the floor, and the report
/// lists this.
TEST(FarOffset, too_far_for_the_size_of_the_domain_ends_with_reasons) {
  for (const double offset : {0x1p46, 0x1p50, 0x1p51}) {
    SCOPED_TRACE(offset);
    const Pslg pslg = domains::moved(box(0, 64), offset, offset);
    const Goal goal{.min_angle_deg = 30, .max_area = 1};
    const Result<Meshed> meshed = mesh(pslg, goal);
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_FALSE(meshed->report.goal_met());
    EXPECT_GT(meshed->report.count(ExemptReason::min_edge), 0U);
    EXPECT_TRUE(check(pslg, meshed->mesh, {.min_angle_deg = 0}).valid);
  }
}

/// The corners of each triangle, from the lexicographically least one on; sorted.
std::vector<std::array<double, 6>> triangles_of(const Mesh& m) {
  std::vector<std::array<double, 6>> all;
  for (const Triangle& t : m.triangles) {
    std::array<std::array<double, 2>, 3> corners;
    for (unsigned i = 0; i < 3; ++i) corners[i] = {m.points[t.v[i]].x, m.points[t.v[i]].y};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back({corners[0][0], corners[0][1], corners[1][0], corners[1][1], corners[2][0], corners[2][1]});
  }
  std::sort(all.begin(), all.end());
  return all;
}

const std::vector<Goal> small_goals{
    {.min_angle_deg = 30}, {.min_angle_deg = 25, .max_area = 0.003}, {.min_angle_deg = 28, .feature_edges = 2}};

/// With vertices on all sides of a crack.
Pslg cracked_square() {
  Pslg pslg = box(0, 1);
  add_segment(pslg, {0.2, 0.3}, {0.7, 0.35});
  pslg.points.push_back({0.4, 0.37});
  return pslg;
}

TEST(FarPoint, outside_of_the_domain_changes_no_triangle) {
  const Pslg alone = cracked_square();
  for (const Goal& goal : small_goals)
    for (const Point far : {Point{1e12, 1e12}, Point{-1e20, 3}, Point{0, 0x1p190}}) {
      SCOPED_TRACE(far.x);
      Pslg pslg = alone;
      pslg.points.push_back(far);
      const Result<Meshed> meshed = mesh(pslg, goal), expected = mesh(alone, goal);
      ASSERT_TRUE(meshed && expected);
      EXPECT_TRUE(meshed->report.goal_met());
      EXPECT_TRUE(check(pslg, meshed->mesh, goal).valid);
      EXPECT_EQ(meshed->mesh.triangles.size(), expected->mesh.triangles.size());
      EXPECT_TRUE(triangles_of(meshed->mesh) == triangles_of(expected->mesh));
    }
}

TEST(Components, of_very_different_sizes_get_the_meshes_of_each_alone) {
  const Pslg small = cracked_square(), large = domains::moved(cracked_square(), 0x1p61, 0x1p59, 0x1p60);
  Pslg both = small;
  const auto first = static_cast<Index>(both.points.size());
  both.points.insert(both.points.end(), large.points.begin(), large.points.end());
  for (const Segment& s : large.segments) both.segments.push_back({first + s.a, first + s.b});
  for (const double angle : {20.7, 30.0}) {
    SCOPED_TRACE(angle);
    const Goal goal{.min_angle_deg = angle};
    const Result<Meshed> meshed = mesh(both, goal), one = mesh(small, goal), other = mesh(large, goal);
    ASSERT_TRUE(meshed && one && other);
    EXPECT_TRUE(meshed->report.goal_met());
    EXPECT_TRUE(check(both, meshed->mesh, goal).valid);
    std::vector<std::array<double, 6>> expected = triangles_of(one->mesh);
    for (const auto& triangle : triangles_of(other->mesh)) expected.push_back(triangle);
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(meshed->mesh.triangles.size(), expected.size());
    EXPECT_TRUE(triangles_of(meshed->mesh) == expected);
  }
  // Tiles of other sizes make slightly different meshes.
  for (const Goal& goal : {Goal{.min_angle_deg = 28, .feature_edges = 3}, Goal{.min_angle_deg = 28, .grading = 0.2}}) {
    const Result<Meshed> meshed = mesh(both, goal), one = mesh(small, goal), other = mesh(large, goal);
    ASSERT_TRUE(meshed && one && other);
    EXPECT_TRUE(meshed->report.goal_met());
    const double sum = static_cast<double>(one->mesh.triangles.size() + other->mesh.triangles.size());
    EXPECT_LT(static_cast<double>(meshed->mesh.triangles.size()), 1.05 * sum);
  }
}

/// Coordinates below 2^-140 are not possible, and edges below 2^-129 are not made.
TEST(TinyDomain, ends_with_vertices_on_its_segments) {
  for (int exponent = -138; exponent <= -100; ++exponent)
    for (const double slope : {0.0, 0.01, 0.3, 1.0}) {
      SCOPED_TRACE(std::to_string(exponent) + ", " + std::to_string(slope));
      Pslg pslg = box(-1, 1);
      add_segment(pslg, {-0.75, -0.75 * slope}, {0.5, 0.5 * slope});
      add_segment(pslg, {-0.5 * slope - 0.0625, 0.5}, {0.625 * slope - 0.0625, -0.625});
      if (!find_problems(pslg).empty()) pslg.segments.pop_back();
      pslg = domains::moved(pslg, 0, 0, std::ldexp(1.0, exponent));
      if (!find_problems(pslg).empty()) continue;
      const Goal goal{.min_angle_deg = 28, .max_area = std::ldexp(0.001, 2 * exponent)};
      const Result<Meshed> meshed = mesh(pslg, goal);
      ASSERT_TRUE(meshed) << meshed.error().message;
      const Mesh& m = meshed->mesh;
      for (std::size_t v = 0; v < m.points.size(); ++v) {
        EXPECT_TRUE(is_usable(m.points[v]));
        const Index s = segment_of_origin(m.origin[v]);
        if (s >= pslg.segments.size()) continue;
        const Point a = pslg.points[pslg.segments[s].a], b = pslg.points[pslg.segments[s].b];
        EXPECT_TRUE(samples::is_on_line(m.points[v], a, b)) << v;
      }
      EXPECT_TRUE(check(pslg, m, {.min_angle_deg = 0}).valid);
      if (exponent > -116) {
        EXPECT_TRUE(meshed->report.goal_met());
      }
      EXPECT_EQ(meshed->report.count(ExemptReason::precision), 0U);
    }
}

/// Points rounded onto a slanted line: the hull has corners of 179.99999999999 degrees, and slivers along it are too
/// thin to be split in double precision. Everything else is valid.
TEST(NearlyCollinear, points_of_the_hull_end_with_reasons) {
  samples::Random random(1);
  Pslg pslg;
  pslg.points = {{0.5, 7}, {0.5, -7}};
  for (int i = 0; i < 50; ++i) {
    const double x = random.uniform(0, 1);
    pslg.points.push_back({x, 0.5 + x / 3});
  }
  expect_certified(pslg, {20.7});
  pslg.points.erase(pslg.points.begin() + 1);
  const Result<Meshed> meshed = mesh(pslg);
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_TRUE(check(pslg, meshed->mesh, {.min_angle_deg = 0}).valid);
}

/// The size function goes to zero at a point. Near this point the edges shrink to the floor (the shortest allowed
/// edge).
TEST(Size, that_vanishes_at_a_corner_ends) {
  Goal goal;
  goal.size = [](Point p) { return 0.3 * std::hypot(p.x, p.y); };
  const Pslg pslg = domains::square();
  const Result<Meshed> meshed = mesh(pslg, goal);
  ASSERT_TRUE(meshed);
  EXPECT_LT(meshed->mesh.triangles.size(), 100'000U);
  // At the corner, sizes and triangles get too small for double precision. The report lists this.
  EXPECT_FALSE(meshed->report.goal_met());
  for (const Violation& violation : check(pslg, meshed->mesh, {}).violations) {
    EXPECT_EQ(violation.kind, ViolationKind::small_angle) << violation.message();
    const Index triangle = violation.ids.front();
    EXPECT_TRUE(std::any_of(meshed->report.exempt.begin(), meshed->report.exempt.end(), [&](const Exemption& e) {
      return e.triangle == triangle && e.reason == ExemptReason::min_edge;
    })) << violation.message();
  }
}

/// Random segments in all directions, many with common ends: small angles of every kind.
TEST(RandomSegments, end) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    samples::Random random(seed);
    Pslg pslg = box(-0.25, 1.25);
    const std::vector<Point> points = samples::uniform_points(25, seed);
    const std::vector<Constraint> constraints = samples::random_constraints(points, 40, random);
    pslg.points.insert(pslg.points.end(), points.begin(), points.end());
    for (const Constraint c : constraints) pslg.segments.push_back({c.a + 4, c.b + 4});
    expect_certified(pslg, {20.7, 33.0});
    expect_certified(domains::moved(pslg, 654321, 4987654), {25.0});
  }
}

}  // namespace
}  // namespace pardel::engine
