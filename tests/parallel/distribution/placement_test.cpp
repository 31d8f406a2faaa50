// The mesh does not depend on which rank owns which cells: cells are given to ranks at random, without any order along
// a curve, and messages are delayed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <vector>

#include "../../../parallel/distribution/distribution.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../scheduling/many_tasks.hpp"

namespace pardel::engine {
namespace {

using samples::Case;

/// A triangle, independent of numbers: its corners in ascending order.
using Place = std::array<std::pair<double, double>, 3>;

Place place_of(const Triangulation& t, TriangleId id) {
  Place corners;
  for (unsigned i = 0; i < 3; ++i) corners[i] = {t.points[t.slots[id].v[i]].x, t.points[t.slots[id].v[i]].y};
  std::ranges::sort(corners);
  return corners;
}

/// How cells get their owners.
enum class Placed { on_any_rank, on_a_rank_of_the_curve_in_another_order };

class PlacedDistribution : public Distribution {
 public:
  PlacedDistribution(Ranks& ranks, Triangulation& t, Placed placed, std::uint64_t seed)
      : Distribution(ranks, t), placed_(placed), seed_(seed) {}

 protected:
  [[nodiscard]] Ownership ownership_of(const Tiles& tiles, std::span<const double> work) const override {
    generators::Random random(seed_);
    const Ownership usual = Distribution::ownership_of(tiles, work);
    std::vector<int> order(static_cast<std::size_t>(ranks())), owner;
    for (int rank = 0; rank < ranks(); ++rank) order[static_cast<std::size_t>(rank)] = rank;
    random.shuffle(order);
    for (Index cell = 0; cell < usual.cells(); ++cell)
      owner.push_back(placed_ == Placed::on_any_rank ? random.one_of(order)
                                                     : order[static_cast<std::size_t>(usual.owner(cell))]);
    return {tiles, owner};
  }

 private:
  Placed placed_;
  std::uint64_t seed_;
};

/// The triangles of the mesh, each as often as it belongs to a rank, in ascending order.
std::vector<Place> refined_on(int count, const Case& c, const Options& options, Placed placed, std::uint64_t seed) {
  std::mutex mutex;
  std::vector<Place> all;
  std::vector<double> caps;
  for (const Region& region : c.pslg.regions) caps.push_back(region.max_area);
  properties::on_ranks(
      count,
      [&](Ranks& ranks) {
        Result<DomainTriangulation> domain = triangulate_domain(c.pslg, c.goal.convex_hull, 1);
        ASSERT_TRUE(domain);
        const Criteria criteria(c.goal, options.placement, caps);
        ProgressMonitor progress(options);
        PlacedDistribution distribution(ranks, domain->triangulation, placed, seed);
        const Result<RefineCounts> counts = refine_by_sweeps(domain->triangulation, domain->segments, criteria, options,
                                                             progress, {}, {}, &distribution);
        ASSERT_TRUE(counts) << counts.error().message;
        const std::scoped_lock lock(mutex);
        distribution.part().for_each_triangle([&](TriangleId id) {
          if (distribution.owner_of_triangle(id) == ranks.rank()) all.push_back(place_of(domain->triangulation, id));
        });
      },
      seed);
  std::ranges::sort(all);
  return all;
}

std::vector<Place> refined_alone(const Case& c, const Options& options) {
  const Mesh mesh = samples::refined(c, options, {}).mesh;
  std::vector<Place> all;
  for (const Triangle& triangle : mesh.triangles) {
    Place& corners = all.emplace_back();
    for (unsigned i = 0; i < 3; ++i) corners[i] = {mesh.points[triangle.v[i]].x, mesh.points[triangle.v[i]].y};
    std::ranges::sort(corners);
  }
  std::ranges::sort(all);
  return all;
}

class Placements : public testing::TestWithParam<std::size_t> {};

TEST_P(Placements, of_cells_on_ranks_at_random_do_not_change_the_mesh) {
  const Case& c = samples::cases()[GetParam()];
  const std::array<std::pair<Case, Options>, 2> runs = {
      {{c, samples::options_for(c)}, {samples::graded(c), samples::options_for_leaves(c)}}};
  for (const auto& [sample, options] : runs) {
    const std::vector<Place> alone = refined_alone(sample, options);
    for (const Placed placed : {Placed::on_any_rank, Placed::on_a_rank_of_the_curve_in_another_order})
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const int count = 2 + static_cast<int>(seed);
        EXPECT_TRUE(refined_on(count, sample, options, placed, seed) == alone) << count << " ranks, seed " << seed;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Placements, testing::Range(std::size_t{0}, samples::cases().size()),
                         [](const auto& parameter) { return samples::cases()[parameter.param].name; });

}  // namespace
}  // namespace pardel::engine
