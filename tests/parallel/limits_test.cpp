// Tests limits that end a run before the goal is met, and errors that the caller makes.
#include "../../parallel/triangulation/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "../../parallel/arithmetic/floor.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/sizes.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "samples.hpp"

namespace pardel::engine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using samples::nan;

/// Expects that everything is valid except the bound on angles.
void expect_valid_but_for_angles(const Pslg& pslg, const Mesh& mesh) {
  const Certificate certificate = check(pslg, mesh, {.min_angle_deg = 0}, {.max_violations = 2});
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
}

TEST(Budget, ends_the_run_and_the_report_lists_the_triangles_that_remain) {
  const Pslg pslg = domains::pipe();
  const Goal goal{.max_area = 1e-4};
  for (const std::uint64_t most : {std::uint64_t{1}, std::uint64_t{pslg.points.size()}, std::uint64_t{2000}}) {
    const Result<Meshed> meshed = mesh(pslg, goal, {.max_vertices = most});
    ASSERT_TRUE(meshed);
    EXPECT_EQ(meshed->mesh.points.size(), std::max<std::size_t>(most, pslg.points.size()));
    EXPECT_FALSE(meshed->report.goal_met());
    const Certificate certificate = check(pslg, meshed->mesh, goal);
    std::set<Index> guilty, reported;
    for (const Violation& v : certificate.violations) {
      EXPECT_TRUE(v.kind == ViolationKind::large_area || v.kind == ViolationKind::small_angle) << v.message();
      guilty.insert(v.ids.front());
    }
    for (const Exemption& e : meshed->report.exempt) {
      EXPECT_EQ(e.reason, ExemptReason::budget);
      reported.insert(e.triangle);
    }
    EXPECT_TRUE(std::is_sorted(meshed->report.exempt.begin(), meshed->report.exempt.end(),
                               [](const Exemption& a, const Exemption& b) { return a.triangle < b.triangle; }));
    if (certificate.violations.size() < 1000) {
      EXPECT_TRUE(std::includes(reported.begin(), reported.end(), guilty.begin(), guilty.end()));
    }
  }
}

/// One triangle with an angle of 7 degrees.
TEST(Budget, no_small_input_angle_excuses_a_triangle_that_is_too_large) {
  Pslg pslg;
  pslg.points = {{0, 0}, {8, 0}, {8, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 0}};
  const Options options{.max_vertices = 3};
  const Result<Meshed> narrow = mesh(pslg, {}, options), large = mesh(pslg, {.max_area = 1}, options);
  ASSERT_TRUE(narrow && large);
  EXPECT_EQ(narrow->report.count(ExemptReason::nestled), 1U);
  EXPECT_TRUE(narrow->report.goal_met());
  EXPECT_EQ(large->report.count(ExemptReason::budget), 1U);
  EXPECT_FALSE(large->report.goal_met());
}

TEST(Memory, that_cannot_suffice_is_reported_before_the_work) {
  const Pslg pslg = domains::square();
  const Result<Meshed> refused = mesh(pslg, {.max_area = 1e-8}, {.max_memory = std::uint64_t{1} << 30U});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::resources);
  for (const char* words : {"100 million triangles", "3.17 GiB", "there are 1 GiB"})
    EXPECT_NE(refused.error().message.find(words), std::string::npos) << refused.error().message;
  const Result<Meshed> numbers = mesh(pslg, {.max_area = 1e-12});
  ASSERT_FALSE(numbers);
  EXPECT_EQ(numbers.error().kind, ErrorKind::resources);
}

TEST(Memory, that_a_region_needs_is_reported_before_the_work) {
  Pslg pslg = domains::square();
  pslg.regions = {{{0.5, 0.5}, 1, 1e-8}};
  const auto refused = [&](bool region_caps) {
    const Goal goal{.max_area = 0.1, .region_caps = region_caps};
    return mesh(pslg, goal, {.max_memory = std::uint64_t{1} << 30U});
  };
  ASSERT_FALSE(refused(true));
  EXPECT_EQ(refused(true).error().kind, ErrorKind::resources);
  EXPECT_NE(refused(true).error().message.find("100 million triangles"), std::string::npos)
      << refused(true).error().message;
  EXPECT_TRUE(refused(false));
}

TEST(Memory, that_is_needed_at_least_is_that_of_twice_as_many_triangles_as_vertices_are_allowed) {
  const auto fits = [](double triangles, std::uint64_t vertices, std::uint64_t memory) {
    return bool(check_size(triangles, {.max_vertices = vertices, .max_memory = memory}));
  };
  std::uint64_t memory = 1000;  // of 2000 triangles
  while (!fits(2000, 0, memory)) ++memory;
  EXPECT_TRUE(fits(1e9, 1000, memory));
  EXPECT_FALSE(fits(1e9, 1000, memory - 1));
  EXPECT_TRUE(fits(2000, 1'000'000, memory));
  EXPECT_EQ(memory, 68'000U) << "34 bytes each, and not one byte more";
  EXPECT_TRUE(fits(max_engine_triangles, 0, 0)) << "as many triangles as can be numbered";
  EXPECT_FALSE(fits(max_engine_triangles + 1.0, 0, 0)) << "one more";
  EXPECT_TRUE(outgrows_memory(1, {.max_memory = 1}));
  EXPECT_FALSE(outgrows_memory(1, {.max_memory = 1000}));
  EXPECT_FALSE(outgrows_memory(1'000'000, {.max_memory = 0})) << "no limit";
}

/// Points that stand twice are searched for only after the triangulation has met two of them.
TEST(Memory, that_cannot_suffice_is_reported_before_points_that_stand_twice) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}};
  const Result<Meshed> refused = mesh(pslg, {}, {.max_memory = 1}), twice = mesh(pslg, {}, {});
  ASSERT_FALSE(refused || twice);
  EXPECT_EQ(refused.error().kind, ErrorKind::resources);
  EXPECT_EQ(twice.error().kind, ErrorKind::invalid_input);
}

TEST(Memory, that_suffices_is_not_refused) {
  // 137 thousand triangles, 48 bytes each.
  EXPECT_TRUE(mesh(domains::square(), {.max_area = 1e-5}, {.max_memory = 6'600'000}));
  EXPECT_TRUE(mesh(domains::square(), {.max_area = 1e-12}, {.max_vertices = 100, .max_memory = 10'000}));
}

TEST(Memory, that_the_mesh_exceeds_ends_the_work) {
  for (const int threads : {1, 2}) {
    // The limit is above the smallest estimate for 137 thousand triangles but below the memory that they need.
    const Result<Meshed> refused =
        mesh(domains::square(), {.max_area = 1e-5}, {.threads = threads, .max_memory = 4'800'000});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::resources);
    EXPECT_NE(refused.error().message.find("outgrown"), std::string::npos) << refused.error().message;
  }
}

TEST(Budget, that_is_not_needed_changes_nothing) {
  const Pslg pslg = domains::key();
  const Result<Meshed> free = mesh(pslg), capped = mesh(pslg, {}, {.max_vertices = 1'000'000});
  ASSERT_TRUE(free && capped);
  EXPECT_EQ(free->mesh, capped->mesh);
}

/// With a limit of 100 vertices, a goal of 10^12 triangles must not allocate the memory for 10^12 triangles.
TEST(Budget, makes_an_unreachable_goal_cheap) {
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 1e-12}, {.max_vertices = 100});
  ASSERT_TRUE(meshed);
  EXPECT_EQ(meshed->mesh.points.size(), 100U);
}

double shortest_edge(const Mesh& m) {
  double shortest = infinity;
  for (const Triangle& t : m.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point a = m.points[t.v[i]], b = m.points[t.v[(i + 1) % 3]];
      shortest = std::min(shortest, std::hypot(a.x - b.x, a.y - b.y));
    }
  return shortest;
}

TEST(Floor, is_never_undercut_and_the_report_names_it) {
  const Pslg pslg = domains::square();
  for (const Placement placement : {Placement::off_centre, Placement::circumcentre})
    for (const double floor : {0.3, 0.1, 0.03}) {
      const Goal goal{.max_area = 1e-5};
      const Result<Meshed> meshed = mesh(pslg, goal, {.placement = placement, .min_edge = floor});
      ASSERT_TRUE(meshed);
      EXPECT_GE(shortest_edge(meshed->mesh), floor);
      EXPECT_FALSE(meshed->report.goal_met());
      EXPECT_EQ(meshed->report.count(ExemptReason::min_edge), meshed->report.exempt.size());
      EXPECT_GT(meshed->report.refused, 0U);
      expect_valid_but_for_angles(pslg, meshed->mesh);
    }
}

/// The floor is the shortest allowed edge. A floor below the limit of double precision has no effect; otherwise edges
/// could join neighbouring doubles.
TEST(Floor, has_a_least_value) {
  const Pslg pslg = domains::moved(domains::wedge(4, 0.001), 654321, 4987654);
  const Goal goal{.min_angle_deg = 33, .conforming = true};
  const Result<Meshed> none = mesh(pslg, goal), tiny = mesh(pslg, goal, {.min_edge = 1e-300});
  ASSERT_TRUE(none && tiny);
  EXPECT_GE(shortest_edge(none->mesh), 4987654 * 0x1p-42);
  EXPECT_EQ(none->mesh, tiny->mesh);
}

/// Sizes go to zero at a corner, so edges become as short as the floor allows there.
TEST(Floor, is_that_of_each_place) {
  Goal goal;
  for (const Point corner : {Point{0, 0}, Point{1, 1}, Point{0x1p20, 0x1p20}}) {
    Pslg pslg = domains::square();
    pslg.points.push_back({0x1p20, 0x1p20});
    pslg.points.push_back({0x1p20 + 1, 0x1p20});
    pslg.points.push_back({0x1p20, 0x1p20 + 1});
    pslg.segments.insert(pslg.segments.end(), {{4, 5}, {5, 6}, {6, 4}});
    goal.size = [=](Point p) { return 0.5 * std::hypot(p.x - corner.x, p.y - corner.y); };
    const Result<Meshed> meshed = mesh(pslg, goal);
    ASSERT_TRUE(meshed) << meshed.error().message;
    const Mesh& m = meshed->mesh;
    double shortest = infinity;
    for (const Triangle& t : m.triangles)
      for (int i = 0; i < 3; ++i) {
        const Point a = m.points[t.v[i]], b = m.points[t.v[(i + 1) % 3]];
        const double length = std::hypot(a.x - b.x, a.y - b.y);
        EXPECT_GE(length, 0.999999 * Floor(0).along(a, b));
        shortest = std::min(shortest, length);
      }
    EXPECT_LT(shortest, 8 * Floor(0).at(corner)) << corner.x;
    EXPECT_EQ(meshed->report.count(ExemptReason::min_edge), meshed->report.exempt.size());
    EXPECT_GT(meshed->report.exempt.size(), 0U);
  }
}

TEST(Floor, holds_near_a_point_that_almost_touches_a_segment) {
  Pslg pslg = domains::square();
  pslg.points.push_back({0.5, 0.001});
  const Result<Meshed> meshed = mesh(pslg, {.min_angle_deg = 30}, {.min_edge = 0.01});
  ASSERT_TRUE(meshed);
  EXPECT_GE(shortest_edge(meshed->mesh), 0.01);
  EXPECT_GT(meshed->report.count(ExemptReason::min_edge), 0U);
}

TEST(KeptSegments, are_not_split_where_the_options_forbid_it) {
  const Pslg pslg = domains::cracks();
  const Goal goal{.max_area = 0.001};
  const Result<Meshed> all = mesh(pslg, goal, {.no_segment_splits = true});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->report.segment_splits, 0U);
  expect_valid_but_for_angles(pslg, all->mesh);
  EXPECT_GT(all->report.count(ExemptReason::kept_segment), 0U);

  const Result<Meshed> outline = mesh(pslg, goal, {.no_boundary_splits = true});
  ASSERT_TRUE(outline);
  EXPECT_GT(outline->report.segment_splits, 0U) << "segments inside may be split";
  for (const Triangle& t : outline->mesh.triangles)
    for (unsigned i = 0; i < 3; ++i) {
      if (t.n[i] != no_index) continue;
      EXPECT_LT(std::max(t.v[(i + 1) % 3], t.v[(i + 2) % 3]), pslg.points.size()) << "a boundary edge was split";
    }
  expect_valid_but_for_angles(pslg, outline->mesh);
}

/// Two points next to a long segment, one on each side.
TEST(KeptSegments, that_are_not_delaunay_break_a_conforming_goal) {
  Pslg pslg = domains::square();
  pslg.points.insert(pslg.points.end(), {{0.1, 0.5}, {0.9, 0.5}, {0.5, 0.55}, {0.5, 0.45}});
  pslg.segments.push_back({4, 5});
  const Goal goal{.min_angle_deg = 0, .conforming = true};
  const Result<Meshed> kept = mesh(pslg, goal, {.no_segment_splits = true}), split = mesh(pslg, goal);
  ASSERT_TRUE(kept && split);
  EXPECT_EQ(kept->report.count(ExemptReason::kept_segment), 2U) << "the triangles on both sides of the segment";
  EXPECT_FALSE(kept->report.goal_met());
  EXPECT_FALSE(check(pslg, kept->mesh, goal).valid);
  EXPECT_TRUE(split->report.goal_met());
  EXPECT_TRUE(check(pslg, split->mesh, goal).valid);
}

/// A segment blocks a triangle. Later, a vertex comes between the triangle's split point and the segment. The triangle
/// was not tried again, and the reason in the report was `precision`.
TEST(KeptSegments, do_not_excuse_a_triangle_after_a_vertex_has_come_between) {
  const auto in_square = [](const std::vector<Point>& points, const std::vector<Segment>& segments) {
    Pslg pslg = domains::moved(domains::square(), 0, 0, 32);
    pslg.points.insert(pslg.points.end(), points.begin(), points.end());
    pslg.segments.insert(pslg.segments.end(), segments.begin(), segments.end());
    return pslg;
  };
  const std::vector<std::pair<Pslg, Goal>> cases{
      {in_square({{3, 19}, {25, 24}, {29, 12}}, {{4, 5}}),
       {.min_angle_deg = 0, .max_area = 28, .feature_edges = 1, .conforming = true}},
      {in_square({{31, 9}, {25, 12}, {26, 27}, {5, 27}, {31, 26}}, {{4, 5}, {6, 7}}),
       {.min_angle_deg = 25, .max_area = 10}},
      {in_square({{27, 2}, {21, 31}, {13, 2}, {21, 26}}, {{4, 5}, {6, 7}}),
       {.min_angle_deg = 25, .max_area = 3, .feature_edges = 1, .conforming = true}}};
  for (const auto& [pslg, goal] : cases) {
    const Result<Meshed> meshed = mesh(pslg, goal, {.no_boundary_splits = true});
    ASSERT_TRUE(meshed) << meshed.error().message;
    ASSERT_FALSE(meshed->report.exempt.empty());
    EXPECT_EQ(meshed->report.count(ExemptReason::kept_segment), meshed->report.exempt.size());
  }
}

TEST(Cancellation, ends_the_run_with_an_error_of_its_kind) {
  Options options;
  options.progress = [](const Progress&) { return false; };
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 1e-5}, options);
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::cancelled);
}

TEST(ProgressCallback, is_called_with_a_growing_number_of_triangles) {
  std::vector<std::uint64_t> seen;
  Options options;
  options.progress = [&](const Progress& progress) {
    seen.push_back(progress.triangles);
    return true;
  };
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 1e-5}, options);
  ASSERT_TRUE(meshed);
  ASSERT_GE(seen.size(), 3U);
  EXPECT_LT(seen.front(), seen.back() / 2);
  EXPECT_NEAR(double(seen.back()) / double(meshed->mesh.triangles.size()), 1, 0.2);
}

TEST(Usage, is_the_error_for_a_goal_out_of_range) {
  const std::vector<Goal> wrong{
      {.min_angle_deg = 60}, {.min_angle_deg = 33.01}, {.min_angle_deg = -1},      {.min_angle_deg = nan},
      {.max_area = 0},       {.max_area = -1},         {.max_area = nan},          {.max_edge = 0},
      {.max_edge = -2},      {.max_edge = nan},        {.min_angle_deg = infinity}};
  for (const Goal& goal : wrong) {
    const Result<Meshed> meshed = mesh(domains::square(), goal);
    ASSERT_FALSE(meshed);
    EXPECT_EQ(meshed.error().kind, ErrorKind::usage);
    EXPECT_FALSE(meshed.error().message.empty());
  }
  for (const double floor : {-1.0, nan, infinity}) {
    const Result<Meshed> meshed = mesh(domains::square(), {}, {.min_edge = floor});
    ASSERT_FALSE(meshed);
    EXPECT_EQ(meshed.error().kind, ErrorKind::usage);
  }
}

TEST(Usage, ends_exactly_at_the_limits_of_a_goal) {
  constexpr double most = 1e6, least = 1e-12;
  EXPECT_TRUE(mesh(domains::square(), {.grading = least}));
  EXPECT_FALSE(mesh(domains::square(), {.grading = std::nextafter(least, 0)}));
  EXPECT_FALSE(mesh(domains::square(), {.feature_edges = std::nextafter(most, 2e6)}));
  EXPECT_FALSE(mesh(domains::square(), {.size_slope = -0x1p-1074}));
  EXPECT_TRUE(mesh(domains::square(), {.min_angle_deg = 33}));
  EXPECT_FALSE(mesh(domains::square(), {.min_angle_deg = std::nextafter(33, 34)}));
}

TEST(Usage, of_angles_from_33_to_45_degrees_requires_a_limit_on_vertices) {
  const Goal goal{.min_angle_deg = 34};
  EXPECT_FALSE(mesh(domains::square(), goal));
  const Result<Meshed> meshed = mesh(domains::square(), goal, {.max_vertices = 100});
  ASSERT_TRUE(meshed) << meshed.error().message;
  EXPECT_TRUE(meshed->report.goal_met());
  const Result<Meshed> endless = mesh(domains::key(), {.min_angle_deg = 44}, {.max_vertices = 500});
  ASSERT_TRUE(endless) << endless.error().message;
  EXPECT_EQ(endless->mesh.points.size(), 500U);
  EXPECT_GT(endless->report.count(ExemptReason::budget), 0U);
  for (const double angle : {45.01, 60.0}) {
    const Result<Meshed> refused = mesh(domains::square(), {.min_angle_deg = angle}, {.max_vertices = 100});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("0 and 45 degrees"), std::string::npos) << refused.error().message;
  }
}

TEST(InvalidInput, is_an_error_that_names_the_place) {
  Pslg bad_point = domains::square();
  bad_point.points[2].x = nan;
  Pslg bad_id = domains::square();
  bad_id.segments[1].b = 17;
  Pslg crossing = domains::square();
  crossing.segments.insert(crossing.segments.end(), {{0, 2}, {1, 3}});
  Pslg open = domains::square();
  open.segments.pop_back();
  Pslg eaten = domains::square();
  eaten.holes.push_back({0.5, 0.5});
  Pslg flat;
  flat.points = {{0, 0}, {1, 1}, {2, 2}};
  Pslg cap = domains::square();
  cap.regions.push_back({{0.5, 0.5}, 1, -3});
  for (const Pslg& pslg : {bad_point, bad_id, crossing, open, eaten, flat, cap, Pslg{}}) {
    const Result<Meshed> meshed = mesh(pslg);
    ASSERT_FALSE(meshed);
    EXPECT_EQ(meshed.error().kind, ErrorKind::invalid_input);
    EXPECT_FALSE(meshed.error().message.empty());
  }
}

TEST(InvalidInput, is_a_size_that_is_not_one_positive_number_per_point) {
  const Pslg pslg = domains::square();
  for (const std::vector<double>& sizes :
       {std::vector<double>{1, 1, 1}, {1, 1, 1, 0}, {1, -1, 1, 1}, {1, 1, nan, 1}, {1, 1, 1, infinity}}) {
    const auto size = interpolated_size(pslg, sizes);
    ASSERT_FALSE(size);
    EXPECT_EQ(size.error().kind, ErrorKind::invalid_input);
  }
}

}  // namespace
}  // namespace pardel::engine
