// Meshes large enough for several tiles and levels of lattices. The borders of tiles and the number of threads have no
// effect that can be seen in the mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../../../core/digest.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

/// The checker accepts the mesh, and the mesh is the same on one, two and three threads.
void expect_same_on_threads(const Pslg& pslg, const Goal& goal) {
  const Result<Meshed> one = mesh(pslg, goal, {.threads = 1});
  ASSERT_TRUE(one) << one.error().message;
  ASSERT_GT(one->mesh.triangles.size(), 50'000U) << "a smaller mesh does not fill several tiles";
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

/// The sizes span three decades, and nearly all triangles are near one corner.
TEST(ManyTiles, of_a_graded_mesh_share_the_work) {
  Goal goal{.min_angle_deg = 25};
  goal.size = [](Point p) { return 0.0001 + 0.03 * std::hypot(p.x, p.y); };
  const Options options{.threads = 2, .decomposition = Decomposition::quadtree, .triangles_per_tile = 100};
  const Result<Meshed> meshed = mesh(domains::square(), goal, options);
  ASSERT_TRUE(meshed);
  ASSERT_GT(meshed->report.tiling.leaves.size(), 100U);
  std::uint64_t largest = 0, all = 0, handed_on = 0;
  for (const Sweep& sweep : meshed->report.tiling.sweeps) {
    largest = std::max(largest, sweep.largest_task);
    all += sweep.inserted;
    handed_on += sweep.handed_on();
  }
  EXPECT_EQ(all, meshed->report.inserted + meshed->report.segment_splits);
  EXPECT_LT(largest, all / 20);
  EXPECT_LT(handed_on, all / 2);
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

TEST(ManyTiles, stop_at_the_budget_of_vertices) {
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

Pslg strip(double width) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, width}, {0, width}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return pslg;
}

/// A strip needs 10^8 triangles and more, but the budget ends the refinement long before. Leaves for all of them would
/// get a few vertices each, and the sweeps over them would take longer than the refinement.
TEST(ManyTiles, of_a_strip_are_only_as_many_as_a_budget_of_vertices_fills) {
  for (const Goal& goal : {Goal{.feature_edges = 2}, Goal{.grading = 0.3}}) {
    const Result<Meshed> meshed = mesh(strip(3e-8), goal, {.threads = 1, .max_vertices = 30'000});
    ASSERT_TRUE(meshed);
    EXPECT_EQ(meshed->mesh.points.size(), 30'000U);
    const Tiling& tiling = meshed->report.tiling;
    EXPECT_GE(tiling.leaves.size(), 10U) << "enough for several threads";
    EXPECT_LE(tiling.leaves.size(), 400U);
    EXPECT_LE(tiling.sweeps.size(), 15U);
  }
}

TEST(ManyTiles, of_a_strip_hardly_evaluate_more_sizes_than_one_tile) {
  const auto evaluated = [](Decomposition decomposition) {
    std::size_t sizes = 0;
    Goal goal;
    goal.size = [&](Point) { return ++sizes, 3e-8; };
    EXPECT_TRUE(mesh(strip(3e-8), goal, {.threads = 1, .decomposition = decomposition, .max_vertices = 30'000}));
    return static_cast<double>(sizes);
  };
  EXPECT_LE(evaluated(Decomposition::quadtree), 1.3 * evaluated(Decomposition::none));
}

/// A regression, with boundaries that may not be split. A triangle needed a point in one tile; the task of this tile
/// needed a point in another tile for it. The two tasks handed the triangle on (passed it to each other) for ever.
TEST(ManyTiles, do_not_hand_a_triangle_on_for_ever) {
  Pslg pslg;
  pslg.points = {{1, 7},  {3, 3},  {5, 3},  {7, 8},  {9, 5},  {10, 4}, {14, 0}, {15, 5}, {16, 1}, {16, 5},
                 {16, 8}, {18, 7}, {19, 3}, {19, 7}, {20, 3}, {21, 5}, {22, 5}, {22, 6}, {26, 2}, {29, 0},
                 {29, 1}, {31, 0}, {31, 2}, {33, 3}, {38, 6}, {40, 4}, {41, 3}, {42, 1}, {42, 5}, {43, 5},
                 {45, 0}, {46, 5}, {47, 1}, {51, 7}, {52, 4}, {54, 7}, {57, 3}};
  for (Point& p : pslg.points) p = {p.x / 8, p.y / 64};
  pslg.segments = {{11, 25}, {16, 5},  {6, 34}, {23, 5},  {7, 11}, {26, 6},  {29, 28}, {26, 28}, {2, 12},
                   {35, 26}, {29, 11}, {23, 8}, {29, 13}, {7, 10}, {36, 20}, {19, 20}, {6, 19},  {4, 7}};
  const Goal goal{.min_angle_deg = 30, .max_area = 0.01, .convex_hull = true};
  const Result<Meshed> meshed = mesh(pslg, goal, {.no_boundary_splits = true});
  ASSERT_TRUE(meshed);
  EXPECT_TRUE(check(pslg, meshed->mesh, {.min_angle_deg = 0, .convex_hull = true}).valid);
}

TEST(ManyTiles, stop_when_the_caller_cancels) {
  int calls = 0;
  Options options{.threads = 2};
  options.progress = [&](const Progress&) { return ++calls < 5; };
  const Result<Meshed> meshed = mesh(domains::square(), {.max_area = 1e-6}, options);
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::cancelled);
  EXPECT_EQ(calls, 5) << "the caller is not asked again";
}

}  // namespace
}  // namespace pardel::engine
