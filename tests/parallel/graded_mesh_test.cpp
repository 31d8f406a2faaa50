// Meshes for a limit on gradation and for edges across narrow places; what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "../../core/digest.hpp"
#include "../../core/raster.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/sizes.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "shapes.hpp"

namespace pardel {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Mesh certified(const Pslg& pslg, const Goal& goal, const Options& options = {}) {
  Result<Meshed> meshed = mesh(pslg, goal, options);
  EXPECT_TRUE(meshed) << meshed.error().message;
  if (!meshed) return {};
  EXPECT_TRUE(meshed->report.goal_met());
  const Certificate certificate = check(pslg, meshed->mesh, goal);
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
  return std::move(meshed->mesh);
}

Pslg rectangle(double width, double height) {
  Pslg pslg;
  testing::add_polygon(pslg, {{0, 0}, {width, 0}, {width, height}, {0, height}});
  return pslg;
}

TEST(GradedMesh, has_as_many_edges_across_a_channel_as_asked) {
  for (const double edges : {2.0, 5.0}) {
    const Mesh made = certified(rectangle(20, 1), {.feature_edges = edges});
    const double triangles = static_cast<double>(made.triangles.size()), across = std::sqrt(triangles / 2 / 20);
    EXPECT_GE(across, 0.8 * edges) << "squares of two triangles each would have this number of edges across";
    EXPECT_LE(across, 2 * edges);
  }
}

TEST(GradedMesh, of_every_domain_is_certified) {
  for (const char* name : {"pipe", "key", "comb", "wedge", "star", "cracks", "touching-holes"}) {
    SCOPED_TRACE(name);
    const auto pslg = domains::generate(name, 0, 1);
    ASSERT_TRUE(pslg);
    certified(*pslg, {.feature_edges = 1.5});
    certified(*pslg, {.grading = 0.3});
  }
}

/// Sizes from 0.01 that grow with the distance from a corner of the unit square.
Goal growing(double slope, double promised) {
  Goal goal;
  goal.size = [slope](Point p) { return 0.01 + slope * std::sqrt(p.x * p.x + p.y * p.y); };
  goal.size_slope = promised;
  return goal;
}

TEST(GradedMesh, is_the_same_with_a_promise_about_the_sizes) {
  for (const double slope : {0.05, 0.3, 0.7}) {
    const auto expected = digest(certified(rectangle(1, 1), growing(slope, infinity)));
    EXPECT_EQ(digest(certified(rectangle(1, 1), growing(slope, slope))), expected) << slope;
  }
}

TEST(GradedMesh, fails_the_check_where_a_promise_about_the_sizes_is_wrong) {
  const Goal goal = growing(0.4, 0);
  const Result<Meshed> meshed = mesh(rectangle(1, 1), goal);
  ASSERT_TRUE(meshed);
  const Certificate certificate = check(rectangle(1, 1), meshed->mesh, goal);
  EXPECT_GT(certificate.violation_counts[static_cast<std::size_t>(ViolationKind::size_exceeded)], 0);
}

TEST(GradedMesh, is_refused_with_a_negative_slope) {
  for (const double slope : {-1.0, std::nan("")}) {
    const Result<Meshed> meshed = mesh(rectangle(1, 1), growing(0.1, slope));
    ASSERT_FALSE(meshed);
    EXPECT_EQ(meshed.error().kind, ErrorKind::usage);
    EXPECT_NE(meshed.error().message.find("slope"), std::string::npos) << meshed.error().message;
  }
}

TEST(GradedMesh, does_not_depend_on_threads) {
  const auto key = domains::generate("key", 0, 1);
  ASSERT_TRUE(key);
  const Goal goal{.grading = 0.2, .feature_edges = 6};
  const auto expected = digest(certified(*key, goal, {.threads = 1}));
  for (const int threads : {2, 3, 8}) EXPECT_EQ(digest(certified(*key, goal, {.threads = threads})), expected);
}

/// The size of the mesh grows with the logarithm of the gap. A wall along which lengths are the least of long pieces
/// would be meshed with 1/gap triangles.
TEST(GradedMesh, near_a_point_that_almost_touches_a_wall_is_small) {
  std::size_t before = 0;
  for (const double gap : {1e-5, 1e-7, 1e-9}) {
    Pslg pslg = rectangle(10, 10);
    pslg.points.push_back({5, gap});
    const std::size_t triangles = certified(pslg, {.feature_edges = 2}).triangles.size();
    EXPECT_LT(triangles, 6000U) << gap;
    EXPECT_GT(triangles, before);
    before = triangles;
  }
}

TEST(GradedMesh, scales_with_the_domain) {
  Pslg pslg = rectangle(7, 1.25);
  pslg.points.push_back({2, 0.125});
  const std::size_t triangles = certified(pslg, {.feature_edges = 3}).triangles.size();
  for (Point& p : pslg.points) p = {p.x * 0x1p-20, p.y * 0x1p-20};
  EXPECT_EQ(certified(pslg, {.feature_edges = 3}).triangles.size(), triangles);
}

TEST(GradedMesh, grows_from_sizes_at_points) {
  Pslg pslg = testing::square(1);
  pslg.points.push_back({0.5, 0.5});
  pslg.points.push_back({0.5, 0.51});
  const std::vector<double> sizes{1, 1, 1, 1, 0.01, 1};
  const auto domain = validate(pslg);
  ASSERT_TRUE(domain.ok());
  Goal goal;
  goal.size = *interpolated_size(*domain, sizes);
  const std::size_t steep = certified(pslg, goal).triangles.size();
  goal.grading = 0.1;
  goal.sources = *size_sources(*domain, sizes, 0.1);
  EXPECT_FALSE(goal.sources.empty());
  const auto allowed = allowed_size(*domain, goal);
  ASSERT_TRUE(allowed);
  EXPECT_NEAR((*allowed)({0.5, 0.5}), 0.01, 1e-12);
  EXPECT_NEAR((*allowed)({0.7, 0.5}), 0.03, 1e-12);
  EXPECT_GT(certified(pslg, goal).triangles.size(), 2 * steep);
}

TEST(GradedMesh, grows_from_a_background_mesh) {
  Mesh background;
  background.points = Array<Point>{};
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) background.points.push_back(p);
  background.triangles.push_back({{0, 1, 2}, {}});
  background.triangles.push_back({{0, 2, 3}, {}});
  const auto sources = size_sources(background, std::vector<double>{0.01, 1, 1, 1}, 0.2);
  ASSERT_TRUE(sources);
  EXPECT_EQ(sources->size(), 5U);
  Goal goal{.grading = 0.2, .sources = *sources};
  const Mesh fine = certified(testing::square(1), goal);
  goal.sources.clear();
  EXPECT_GT(fine.triangles.size(), 3 * certified(testing::square(1), goal).triangles.size());
}

TEST(GradedMesh, without_the_two_bounds_is_the_mesh_as_before) {
  const auto domain = validate(testing::square(1));
  ASSERT_TRUE(domain.ok());
  EXPECT_FALSE(*allowed_size(*domain, {}));
  const Goal sized{.size = [](Point p) { return 1 + p.x; }};
  EXPECT_EQ((*allowed_size(*domain, sized))({2, 0}), 3);
}

TEST(GradedMesh, is_refused_for_useless_numbers) {
  const auto refused = [](const Goal& goal, const std::string& what) {
    const Status checked = check_goal(goal);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().kind, ErrorKind::usage);
    EXPECT_NE(checked.error().message.find(what), std::string::npos) << checked.error().message;
    EXPECT_FALSE(mesh(testing::square(1), goal));
  };
  for (const double wrong : {0.0, -1.0, 1e-200, -infinity, std::nan("")})
    refused({.grading = wrong}, "limit on gradation");
  for (const double wrong : {-1.0, 1e7, infinity, std::nan("")}) refused({.feature_edges = wrong}, "edges across");
  for (const double wrong : {0.0, -0.5, infinity, std::nan("")}) {
    refused({.grading = 1, .sources = {{{0, 0}, {1, 0}, 1, wrong}}}, "source 0 at (0, 0)");
    refused({.grading = 1, .sources = {{{0, 0}, {1, 0}, 1, 1}, {{0, 0}, {1, 0}, wrong, 1}}}, "source 1 at (0, 0)");
  }
  refused({.grading = 1, .sources = {{{0, infinity}, {1, 0}, 1, 1}}}, "source 0 is not at a finite point");
  const auto domain = validate(testing::square(1));
  ASSERT_TRUE(domain.ok());
  const std::vector<double> sizes(4, 1.0), few(3, 1.0), zero{1, 1, 0, 1};
  for (const double wrong : {0.0, -1.0, infinity, std::nan("")})
    EXPECT_EQ(size_sources(*domain, sizes, wrong).error().kind, ErrorKind::usage);
  EXPECT_EQ(size_sources(*domain, few, 1).error().kind, ErrorKind::invalid_input);
  EXPECT_EQ(size_sources(*domain, zero, 1).error().kind, ErrorKind::invalid_input);
  EXPECT_EQ(size_sources(Mesh{}, {}, 1).error().kind, ErrorKind::invalid_input);
}

TEST(GradedMesh, cannot_be_refined_from_a_mesh) {
  const auto coarse = triangulate(testing::square(1));
  ASSERT_TRUE(coarse);
  for (const Goal& goal : {Goal{.grading = 0.5}, Goal{.feature_edges = 2}}) {
    const auto refined = refine(coarse->mesh, {}, goal);
    ASSERT_FALSE(refined);
    EXPECT_EQ(refined.error().kind, ErrorKind::usage);
  }
}

TEST(GradedMesh, of_a_domain_with_few_points_is_made_by_many_tasks) {
  // The size is small in the left quarter, far from the centroids of the two triangles of the domain.
  Raster raster{16, 16, {1.0 / 32, 1.0 / 32}, 1.0 / 16, 1.0 / 16, {}};
  for (int k = 0; k < 256; ++k) raster.values.push_back(k % 16 < 4 ? 0.004 : 0.5);
  Goal goal;
  goal.size = *interpolated_size(raster);
  const Result<Meshed> meshed = mesh(rectangle(1, 1), goal, {.triangles_per_tile = 200});
  ASSERT_TRUE(meshed);
  const auto& tiling = meshed->report.tiling;
  EXPECT_GT(meshed->mesh.triangles.size(), 30'000U);
  EXPECT_GT(tiling.leaves.size(), 50U);
  std::uint64_t inserted = 0, largest = 0;
  for (const Sweep& sweep : tiling.sweeps) {
    inserted += sweep.inserted;
    largest = std::max(largest, sweep.largest_task);
  }
  EXPECT_LT(10 * largest, inserted);
}

TEST(GradedMesh, around_a_point_where_the_cells_of_a_lattice_meet_is_made_on_a_quadtree) {
  for (const int decades : {5, 6}) {
    const Pslg pslg = domains::radial(decades);
    Goal goal{.min_angle_deg = 25};
    goal.size = *interpolated_size(pslg, domains::radial_sizes(pslg, 0.05));
    const Result<Meshed> meshed = mesh(pslg, goal);
    ASSERT_TRUE(meshed);
    EXPECT_FALSE(meshed->report.tiling.leaves.empty()) << decades << " decades";
  }
}

}  // namespace
}  // namespace pardel
