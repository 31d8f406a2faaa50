// Filled meshes: they are valid and small, the same on any number of threads, and every run ends.
#include "../../../parallel/filling/refine_filled.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../patches/domains_to_fill.hpp"

namespace pardel::engine {
namespace {

double area_of(const Pslg& pslg) {
  const Result<Meshed> coarse = triangulate(pslg);
  double twice = 0;
  for (const Triangle& triangle : coarse->mesh.triangles) {
    const Point a = coarse->mesh.points[triangle.v[0]], b = coarse->mesh.points[triangle.v[1]],
                c = coarse->mesh.points[triangle.v[2]];
    twice += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  return twice / 2;
}

TEST(RefineFilled, gives_valid_meshes_that_never_have_more_triangles_than_without_patches) {
  for (const Pslg& pslg : domains_to_fill())
    for (const double bounds : {100.0, 1'000.0, 20'000.0})
      for (const double angle : {20.7, 30.0, 33.0}) {
        const Goal goal{.min_angle_deg = angle, .max_area = area_of(pslg) / bounds};
        Options options{.interior = Interior::fill, .threads = 1};
        const Result<Meshed> filled = mesh(pslg, goal, options);
        options.interior = Interior::refine;
        const Result<Meshed> refined = mesh(pslg, goal, options);
        ASSERT_TRUE(filled && refined);
        EXPECT_EQ(filled->report.goal_met(), refined->report.goal_met());
        EXPECT_LE(filled->mesh.triangles.size(), refined->mesh.triangles.size()) << bounds << " " << angle;
        const Certificate certificate = check(pslg, filled->mesh, goal);
        EXPECT_TRUE(certificate.valid) << to_text(certificate);
        if (angle <= 30 && filled->report.laid > 0) {
          EXPECT_LE(filled->report.restarts, 4U);
        }
      }
}

/// A square and a narrow channel, in which no patch fits.
TEST(RefineFilled, keeps_patches_where_the_rest_needs_many_vertices) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {3.8, 0}, {3.8, 1e-5}, {2, 1e-5}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const Result<Meshed> filled = mesh(pslg, {.max_area = 1.0 / 20'000}, {.interior = Interior::fill, .threads = 1});
  ASSERT_TRUE(filled);
  const auto in_channel = [](Point p) { return p.x >= 2; };
  EXPECT_GT(std::ranges::count_if(filled->mesh.points.span(), in_channel), 125'000);
  EXPECT_GT(filled->report.laid, 15'000U);
  EXPECT_EQ(filled->report.restarts, 0U);
  EXPECT_TRUE(filled->report.goal_met());
}

TEST(RefineFilled, keeps_a_bound_on_edges_beside_larger_caps_of_regions) {
  Pslg pslg = domains::square();
  pslg.regions = {{{0.5, 0.5}, 1, 0.01}};
  const Goal goal{.max_edge = 0.04, .region_caps = true};
  const Result<Meshed> filled = mesh(pslg, goal, {.interior = Interior::fill, .threads = 1});
  ASSERT_TRUE(filled);
  EXPECT_GT(filled->report.laid, 500U);
  const Certificate certificate = check(pslg, filled->mesh, goal);
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
}

TEST(RefineFilled, comes_near_the_least_number_of_triangles) {
  const Pslg pslg = domains::square();
  for (const double angle : {20.7, 30.0}) {
    const Result<Meshed> filled =
        mesh(pslg, {.min_angle_deg = angle, .max_area = 1e-5}, {.interior = Interior::fill, .threads = 1});
    ASSERT_TRUE(filled);
    EXPECT_LT(filled->mesh.triangles.size(), 101'200U) << "an area bound fits 100,000 times";
    EXPECT_EQ(filled->report.restarts, 0U);
  }
}

TEST(RefineFilled, restarts_to_the_same_mesh_on_any_number_of_threads) {
  const Pslg pslg = domains::square();
  const Goal goal{.min_angle_deg = 33, .max_area = 1e-4};
  Options options{.interior = Interior::fill, .threads = 1, .triangles_per_tile = 200};
  const Result<Meshed> one = mesh(pslg, goal, options);
  ASSERT_TRUE(one);
  EXPECT_GT(one->report.restarts, 0U);
  EXPECT_GT(one->report.laid, 5'000U);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    const Result<Meshed> many = mesh(pslg, goal, options);
    ASSERT_TRUE(many);
    EXPECT_EQ(many->mesh, one->mesh);
    EXPECT_EQ(many->report.restarts, one->report.restarts);
  }
}

TEST(RefineFilled, shows_complete_meshes_after_each_sweep) {
  const Pslg pslg = domains::square();
  std::size_t sweeps = 0;
  Options options{.interior = Interior::fill, .threads = 1, .triangles_per_tile = 100};
  options.after_sweep = [&](const Mesh& mesh, const Sweep&) -> Status {
    ++sweeps;
    const Certificate certificate = check(pslg, mesh, {.min_angle_deg = 0});
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
    EXPECT_GT(mesh.triangles.size(), 700U) << "the patches are in it";
    return Done{};
  };
  ASSERT_TRUE(mesh(pslg, {.min_angle_deg = 25, .max_area = 1e-3}, options));
  EXPECT_GT(sweeps, 1U);
}

TEST(RefineFilled, keeps_the_limit_on_vertices) {
  const Pslg pslg = domains::square();
  const Goal goal{.min_angle_deg = 30, .max_area = 1e-3};
  const Result<Meshed> whole = mesh(pslg, goal, {.interior = Interior::fill, .threads = 1});
  ASSERT_TRUE(whole);
  const std::size_t vertices = whole->mesh.points.size();
  for (const std::size_t most : {vertices - 1, vertices - 20, vertices / 2}) {
    const Result<Meshed> limited = mesh(pslg, goal, {.interior = Interior::fill, .threads = 1, .max_vertices = most});
    ASSERT_TRUE(limited);
    EXPECT_LE(limited->mesh.points.size(), most);
    EXPECT_FALSE(limited->report.goal_met());
    EXPECT_TRUE(std::ranges::all_of(limited->report.exempt,
                                    [](const Exemption& e) { return e.reason == ExemptReason::budget; }));
    const Certificate certificate = check(pslg, limited->mesh, {.min_angle_deg = 0});
    EXPECT_TRUE(certificate.valid) << to_text(certificate);
  }
}

TEST(RefineFilled, shows_the_patches_in_its_progress) {
  std::uint64_t last = 0;
  Options options{.interior = Interior::fill, .threads = 1};
  options.progress = [&](const Progress& progress) {
    EXPECT_TRUE(progress.triangles == 0 || progress.triangles > 700) << "the patches are counted from the start";
    last = progress.triangles;
    return true;
  };
  const Result<Meshed> filled = mesh(domains::square(), {.min_angle_deg = 25, .max_area = 1e-3}, options);
  ASSERT_TRUE(filled);
  EXPECT_GT(filled->report.laid, 700U);
  EXPECT_EQ(last, filled->mesh.triangles.size());
}

TEST(RefineFilled, keeps_the_patches_if_both_meshes_have_the_same_number_of_triangles) {
  const Goal goal{.min_angle_deg = 30, .max_area = 1 / 38.7};
  const Result<Meshed> refined = mesh(domains::square(), goal, {.interior = Interior::refine, .threads = 1});
  const Result<Meshed> filled = mesh(domains::square(), goal, {.interior = Interior::fill, .threads = 1});
  ASSERT_TRUE(refined && filled);
  ASSERT_EQ(filled->mesh.triangles.size(), refined->mesh.triangles.size());
  EXPECT_GT(filled->report.laid, 0U);
}

TEST(RefineFilled, shows_no_patches_any_more_in_the_progress_of_a_refinement_without_them) {
  std::uint64_t last = 0;
  Options options{.interior = Interior::fill, .threads = 1};
  options.progress = [&](const Progress& progress) {
    last = progress.triangles;
    return true;
  };
  const Result<Meshed> filled = mesh(domains::square(), {.min_angle_deg = 30, .max_area = 1 / 38.7}, options);
  ASSERT_TRUE(filled);
  EXPECT_EQ(last, filled->mesh.triangles.size()) << "both meshes have this number";
}

/// The patches of this domain are given up after a round. A vertex is reckoned to need 80 bytes.
TEST(RefineFilled, needs_no_memory_for_patches_that_were_given_up) {
  const Pslg pslg = domains::key();
  const Goal goal{.min_angle_deg = 30, .max_area = 0.02162};
  Options options{.interior = Interior::refine, .threads = 1};
  const Result<Meshed> refined = mesh(pslg, goal, options);
  ASSERT_TRUE(refined);
  options.max_memory = 80 * refined->mesh.points.size();
  EXPECT_TRUE(mesh(pslg, goal, options));
  options.interior = Interior::fill;
  const Result<Meshed> filled = mesh(pslg, goal, options);
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->report.laid, 0U);
  EXPECT_EQ(filled->report.restarts, 1U);
  EXPECT_EQ(filled->mesh, refined->mesh);
  --options.max_memory;
  EXPECT_FALSE(mesh(pslg, goal, options));
}

}  // namespace
}  // namespace pardel::engine
