// Meshes large enough for several tiles and levels of lattices: the seams leave no trace, and neither do threads.
#include <gtest/gtest.h>

#include <cmath>

#include "../../core/digest.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/check.hpp"
#include "../../properties/domains.hpp"

namespace pardel {
namespace {

/// Certified, and the same on one, two and three threads.
void expect_same_on_threads(const Pslg& pslg, const Goal& goal) {
  const Result<Meshed> one = mesh(pslg, goal);
  ASSERT_TRUE(one) << one.error().message;
  ASSERT_GT(one->mesh.triangles.size(), 50'000U) << "less does not fill several tiles";
  EXPECT_TRUE(one->report.goal_met());
  const Certificate certificate = check(pslg, one->mesh, goal, {.max_violations = 2});
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
  for (const int threads : {2, 3}) {
    const Result<Meshed> other = mesh(pslg, goal, {.threads = threads});
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_TRUE(other->mesh == one->mesh) << threads << " threads";
  }
}

TEST(ManyTiles, of_one_size_leave_no_seam) { expect_same_on_threads(domains::pipe(), {.max_area = 4e-5}); }

TEST(ManyTiles, of_a_conforming_mesh_leave_no_seam) {
  expect_same_on_threads(domains::key(), {.min_angle_deg = 30, .max_area = 1e-4, .conforming = true});
}

TEST(ManyTiles, of_a_graded_mesh_leave_no_seam) {
  Goal goal{.min_angle_deg = 25};
  goal.size = [](Point p) { return 0.0006 + 0.02 * std::hypot(p.x, p.y); };
  expect_same_on_threads(domains::square(), goal);
}

TEST(ManyTiles, of_random_points_leave_no_seam) {
  expect_same_on_threads(domains::random_points(30'000, 4), {.min_angle_deg = 30});
}

TEST(ManyTiles, far_from_the_origin_leave_no_seam) {
  expect_same_on_threads(domains::moved(domains::pipe(), 654321, 4987654), {.min_angle_deg = 25, .max_area = 4e-5});
}

TEST(ManyTiles, of_a_long_thin_domain_leave_no_seam) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1000, 0}, {1000, 1}, {0, 1}, {0, 0.5}, {999.5, 0.501}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}, {4, 5}};
  expect_same_on_threads(pslg, {.min_angle_deg = 30, .max_area = 0.02});
}

TEST(ManyTiles, keep_the_budget_to_the_vertex) {
  for (const int threads : {1, 2, 3}) {
    const Result<Meshed> meshed =
        mesh(domains::pipe(), {.max_area = 4e-5}, {.threads = threads, .max_vertices = 30'000});
    ASSERT_TRUE(meshed);
    EXPECT_LE(meshed->mesh.points.size(), 30'000U);
    EXPECT_GE(meshed->mesh.points.size(), 29'000U);
    EXPECT_GT(meshed->report.count(ExemptReason::budget), 0U);
    EXPECT_TRUE(check(domains::pipe(), meshed->mesh, {.min_angle_deg = 0}).valid);
  }
}

TEST(ManyTiles, stop_when_the_caller_says_so) {
  int calls = 0;
  Options options{.threads = 2};
  options.progress = [&](const Progress&) { return ++calls < 5; };
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 1e-6}, options);
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::cancelled);
  EXPECT_EQ(calls, 5);
}

}  // namespace
}  // namespace pardel
