// Pending triangles go to the cells of their split points, or are deferred again if a rule requires it. None is lost.
#include "../../../parallel/scheduling/pending_triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../../../parallel/scheduling/initial_assessment.hpp"
#include "../refinement/assessed_sample.hpp"

namespace pardel::engine {
namespace {

/// Random points in the unit square, with most triangles bad.
struct PendingScene : samples::AssessedSample {
  Tiles lattice{Lattice({0, 0, 1, 1}, 4, 4)};

  PendingScene() : AssessedSample(samples::uniform_points(2000, 3), {.min_angle_deg = 30}, Placement::circumcentre) {}
  [[nodiscard]] const Triangulation& t() const { return sample.triangulation; }
  [[nodiscard]] PendingTriangles all_bad(int threads) const {
    PendingTriangles pending(t(), assessor, threads);
    pending.defer(assess_all(t(), criteria, assessor, threads).bad);
    return pending;
  }
};

std::vector<TriangleId> ids(const SeedsByCell& seeds) {
  std::vector<TriangleId> all;
  for (const auto& of_cell : seeds)
    for (const QueuedTriangle seed : of_cell) all.push_back(seed.id());
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<TriangleId> bad_triangles(const PendingScene& scene) {
  std::vector<TriangleId> bad;
  for (TriangleId id = 0; id < scene.t().slots.size(); ++id)
    if (scene.assessor.assess(id).need != Assessment::Need::nothing) bad.push_back(id);
  return bad;
}

TEST(PendingTriangles, go_to_the_cells_of_their_split_points_on_any_number_of_threads) {
  const PendingScene scene;
  const SeedsByCell one = scene.all_bad(1).take_due_by_cell(scene.lattice, {});
  ASSERT_EQ(one.size(), scene.lattice.cells());
  EXPECT_EQ(ids(one), bad_triangles(scene));
  EXPECT_GT(ids(one).size(), 100U);
  for (Index cell = 0; cell < one.size(); ++cell)
    for (const QueuedTriangle seed : one[cell]) {
      const Assessment a = scene.assessor.assess(seed.id());
      EXPECT_EQ(scene.lattice.cell_of(scene.assessor.point_for(seed.id(), a)), cell);
    }
  const SeedsByCell three = scene.all_bad(3).take_due_by_cell(scene.lattice, {});
  for (Index cell = 0; cell < one.size(); ++cell)
    EXPECT_TRUE(std::ranges::equal(one[cell], three[cell], {}, &QueuedTriangle::id, &QueuedTriangle::id));
}

TEST(PendingTriangles, are_deferred_where_the_rule_says_so_and_are_due_later) {
  const PendingScene scene;
  PendingTriangles pending = scene.all_bad(2);
  const Deferral later{.last_key = PendingTriangles::median_key(pending.count_keys())};
  std::vector<TriangleId> seen = ids(pending.take_due_by_cell(scene.lattice, later));
  const std::vector<TriangleId> rest = ids(pending.take_due_by_cell(scene.lattice, {}));
  EXPECT_GE(3 * seen.size(), rest.size());
  EXPECT_GE(3 * rest.size(), seen.size());
  for (const TriangleId id : seen) EXPECT_LE(scene.assessor.assess(id).key, later.last_key);
  for (const TriangleId id : rest) EXPECT_GT(scene.assessor.assess(id).key, later.last_key);
  seen.insert(seen.end(), rest.begin(), rest.end());
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, bad_triangles(scene));
}

/// Each cell has a rule of its own.
TEST(PendingTriangles, are_deferred_by_the_rule_of_their_cell) {
  const PendingScene scene;
  const Tiles leaves{Quadtree({0, 0, 1, 1}).divided(std::vector<double>{1}, 0)};
  PendingTriangles pending = scene.all_bad(2);
  const std::vector<unsigned> medians = pending.median_keys(leaves);
  ASSERT_EQ(medians.size(), 4U);
  std::vector<Deferral> rules{{}, {.longest_squared = INFINITY}};
  rules.push_back({.last_key = medians[2]});
  rules.push_back({.last_key = medians[3]});
  const SeedsByCell seeds = pending.take_due_by_cell(leaves, Deferrals(rules));
  EXPECT_FALSE(seeds[0].empty());
  EXPECT_TRUE(seeds[1].empty());
  for (const Index cell : {2U, 3U})
    for (const QueuedTriangle seed : seeds[cell]) EXPECT_LE(scene.assessor.assess(seed.id()).key, medians[cell]);
  const SeedsByCell rest = pending.take_due_by_cell(leaves, {});
  EXPECT_TRUE(rest[0].empty());
  for (const Index cell : {2U, 3U}) {
    EXPECT_GT(3 * rest[cell].size(), seeds[cell].size());
    EXPECT_GT(3 * seeds[cell].size(), rest[cell].size());
  }
  EXPECT_EQ(ids(seeds).size() + ids(rest).size(), bad_triangles(scene).size());
}

TEST(PendingTriangles, have_the_work_that_is_estimated_on_any_number_of_threads) {
  const PendingScene scene;
  const Array<WorkAt> one = scene.all_bad(1).work(scene.criteria), three = scene.all_bad(3).work(scene.criteria);
  const std::vector<TriangleId> bad = bad_triangles(scene);
  ASSERT_EQ(one.size(), bad.size());
  ASSERT_EQ(three.size(), bad.size());
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_EQ(one[i].place, Shape(scene.t(), scene.t().slots[bad[i]]).centroid());
    EXPECT_EQ(one[i].triangles, 2) << "a goal without bounds on size";
    EXPECT_EQ(three[i].place, one[i].place);
  }
}

TEST(PendingTriangles, come_back_after_they_were_set_aside) {
  const PendingScene scene;
  PendingTriangles pending = scene.all_bad(2);
  pending.set_aside({.longest_squared = 0.002});
  const std::vector<TriangleId> before = ids(pending.take_due_by_cell(scene.lattice, {}));
  pending.bring_back();
  const std::vector<TriangleId> after = ids(pending.take_due_by_cell(scene.lattice, {}));
  EXPECT_FALSE(before.empty());
  EXPECT_FALSE(after.empty());
  EXPECT_EQ(before.size() + after.size(), bad_triangles(scene).size());
}

TEST(PendingTriangles, that_are_stale_or_good_are_dropped) {
  const PendingScene scene;
  PendingTriangles pending(scene.t(), scene.assessor, 1);
  const std::vector<TriangleId> bad = bad_triangles(scene);
  TriangleId good = 0;
  while (std::binary_search(bad.begin(), bad.end(), good)) ++good;
  QueuedTriangle stale = QueuedTriangle::now(scene.t(), EdgeRef(bad[1], 0));
  ++stale.first_corner;
  EXPECT_FALSE(pending.any_needs_larger_box());
  pending.add_needing_larger_box(std::vector{QueuedTriangle::now(scene.t(), EdgeRef(bad[0], 0)), stale,
                                             QueuedTriangle::now(scene.t(), EdgeRef(good, 0))});
  EXPECT_TRUE(pending.any_needs_larger_box());
  EXPECT_EQ(ids(pending.take_needing_larger_box_by_cell(scene.lattice)), std::vector{bad[0]});
  EXPECT_FALSE(pending.any_needs_larger_box());
}

}  // namespace
}  // namespace pardel::engine
