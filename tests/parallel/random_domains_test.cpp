// Random domains with points on and off a lattice, dangling and enclosing segments, holes and regions. Each domain is
// meshed with a random goal and the mesh is certified; then the mesh is refined again.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../../core/digest.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/validate.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

std::vector<Point> random_points(Random& random) {
  const Index kind = random.below(3), n = 5 + random.below(40);
  std::vector<Point> points;
  for (Index i = 0; i < n; ++i) {
    if (kind == 0)
      points.push_back({double(random.below(9)), double(random.below(9))});
    else if (kind == 1)
      points.push_back({random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
    else
      points.push_back({random.below(64) / 8.0, random.below(9) / 64.0});
  }
  std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Removes parts of the input, or changes the goal, until the domain is valid. Returns false if this fails.
bool make_valid(Pslg& pslg, Goal& goal) {
  for (int round = 0; round < 4; ++round) {
    const std::vector<Problem> problems = find_problems(pslg, {goal.convex_hull});
    if (problems.empty()) return true;
    for (const Problem& problem : problems) switch (problem.kind) {
        case ProblemKind::hole_outside:
        case ProblemKind::hole_on_segment:
        case ProblemKind::no_domain:
          pslg.holes.clear();
          break;
        case ProblemKind::unclosed_outline:
          goal.convex_hull = true;
          break;
        default:
          pslg.regions.clear();
      }
  }
  return false;
}

struct Case {
  Pslg pslg;
  Goal goal;
};

Case random_case(Random& random) {
  Case c;
  c.pslg.points = random_points(random);
  for (const Constraint s : samples::random_constraints(c.pslg.points, random.below(80), random))
    c.pslg.segments.push_back({s.a, s.b, static_cast<int>(random.below(4))});
  const auto somewhere = [&] {
    const Point near = c.pslg.points[random.below(c.pslg.points.size())];
    return Point{near.x + random.uniform(-0.1, 0.1), near.y + random.uniform(-0.1, 0.1)};
  };
  for (Index i = random.below(3); i > 0; --i) c.pslg.holes.push_back(somewhere());
  for (Index i = random.below(3); i > 0; --i)
    c.pslg.regions.push_back(
        {somewhere(), double(i), random.below(2) == 0 ? 0.05 : std::numeric_limits<double>::infinity()});
  constexpr std::array angles{0.0, 10.0, 20.7, 25.0, 30.0, 33.0};
  c.goal.min_angle_deg = angles[random.below(angles.size())];
  c.goal.conforming = random.below(2) == 0;
  c.goal.convex_hull = c.pslg.segments.empty() || random.below(2) == 0;
  if (random.below(3) == 0) c.goal.max_area = 0.02;
  if (random.below(3) == 0) c.pslg = domains::moved(c.pslg, 654321, 4987654);
  return c;
}

TEST(RandomDomain, is_meshed_and_certified_and_refining_the_mesh_again_changes_nothing) {
  int meshed_ones = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Case c = random_case(random);
    if (!make_valid(c.pslg, c.goal)) continue;
    ++meshed_ones;
    const Options options{.placement = random.below(4) == 0 ? Placement::circumcentre : Placement::off_centre};
    const Result<Meshed> meshed = mesh(c.pslg, c.goal, options);
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(meshed->report.goal_met());
    const Certificate certificate = check(c.pslg, meshed->mesh, c.goal, {.max_violations = 2});
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
    c.goal.region_caps = false;  // a mesh has no area caps
    const Result<Meshed> again = refine(meshed->mesh, {}, c.goal, options);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(digest(again->mesh), digest(meshed->mesh));
  }
  EXPECT_GT(meshed_ones, 350);
}

/// Segments that must be kept are not split; otherwise the mesh is valid. The report has a reason for every exempt
/// triangle.
TEST(RandomDomain, with_kept_segments_is_meshed_as_far_as_it_goes) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Case c = random_case(random);
    c.goal.conforming = false;
    if (!make_valid(c.pslg, c.goal)) continue;
    Options options;
    (seed % 2 == 0 ? options.no_segment_splits : options.no_boundary_splits) = true;
    const Result<Meshed> meshed = mesh(c.pslg, c.goal, options);
    ASSERT_TRUE(meshed) << meshed.error().message;
    EXPECT_TRUE(!options.no_segment_splits || meshed->report.segment_splits == 0);
    std::vector<bool> reported(meshed->mesh.triangles.size(), false);
    for (const Exemption& e : meshed->report.exempt) reported[e.triangle] = true;
    for (const Violation& v : check(c.pslg, meshed->mesh, c.goal).violations) {
      EXPECT_TRUE(v.kind == ViolationKind::small_angle || v.kind == ViolationKind::large_area ||
                  v.kind == ViolationKind::region_area)
          << v.message();
      EXPECT_TRUE(reported[v.ids.front()]) << v.message();
    }
  }
}

}  // namespace
}  // namespace pardel::engine
