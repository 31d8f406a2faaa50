// After every phase, each rank holds exactly the triangles that it has to hold, and all ranks agree on them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>
#include <vector>

#include "../../../parallel/distribution/distribution.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../scheduling/many_tasks.hpp"

namespace pardel::engine {
namespace {

using samples::Case;

/// The corners of a triangle, from the lexicographically least one on.
using Corners = std::array<double, 6>;

Corners corners_of(const Triangulation& t, TriangleId id) {
  std::array<Point, 3> p;
  for (unsigned i = 0; i < 3; ++i) p[i] = t.points[t.slots[id].v[i]];
  const auto least = std::ranges::min_element(p, {}, [](Point c) { return std::pair(c.x, c.y); });
  std::rotate(p.begin(), least, p.end());
  return {p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y};
}

/// What the ranks held after the phases.
struct Observed {
  struct Held {
    Corners corners;
    bool is_own;                ///< it belongs to the piece of this rank
    std::vector<int> watchers;  ///< the ranks that have to hold it
  };
  std::mutex mutex;
  std::vector<std::vector<std::vector<Held>>> held;  ///< [phase][rank]
};

/// Observes the part of its rank after every exchange.
class WatchedDistribution : public Distribution {
 public:
  WatchedDistribution(Ranks& ranks, Triangulation& t, Observed& observed)
      : Distribution(ranks, t), watched_(t), observed_(observed) {}

  void exchange_changes(std::vector<PlannedTask>& tasks) override {
    Distribution::exchange_changes(tasks);
    std::vector<Observed::Held> held;
    part().for_each_triangle([&](TriangleId id) {
      const bool is_own = owner_of_triangle(id) == network().rank();
      held.push_back({corners_of(watched_, id), is_own, watchers(id)});
      expect_neighbours(id);
    });
    const std::scoped_lock lock(observed_.mutex);
    if (observed_.held.size() <= phase_) observed_.held.resize(phase_ + 1);
    observed_.held[phase_].resize(network().count());
    observed_.held[phase_][network().rank()] = std::move(held);
    ++phase_;
  }

 private:
  [[nodiscard]] std::vector<int> watchers(TriangleId id) const {
    std::vector<int> found;
    for (int rank = 0; rank < network().count(); ++rank)
      if (std::ranges::any_of(watched_.slots[id].v,
                              [&](VertexId v) { return ownership().watches(rank, watched_.points[v]); }))
        found.push_back(rank);
    return found;
  }
  /// Neighbours refer to each other, and share two corners.
  void expect_neighbours(TriangleId id) const {
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = watched_.slots[id].n[side];
      if (across.none() || part().is_beyond(across)) continue;
      const Slot &here = watched_.slots[id], &there = watched_.slot(across);
      EXPECT_TRUE(part().holds(across.triangle()));
      EXPECT_EQ(there.n[across.side()].triangle(), id);
      EXPECT_EQ(here.from(side), there.to(across.side()));
      EXPECT_EQ(here.to(side), there.from(across.side()));
    }
  }

  const Triangulation& watched_;
  Observed& observed_;
  std::size_t phase_ = 0;
};

void observe(const Case& c, const Options& options, int count, Observed& observed) {
  std::vector<double> caps;
  for (const Region& region : c.pslg.regions) caps.push_back(region.max_area);
  properties::on_ranks(count, [&](Ranks& ranks) {
    Result<DomainTriangulation> domain = triangulate_domain(c.pslg, c.goal.convex_hull, 1);
    ASSERT_TRUE(domain);
    const Criteria criteria(c.goal, options.placement, caps);
    ProgressMonitor progress(options);
    WatchedDistribution distribution(ranks, domain->triangulation, observed);
    const Result<RefineCounts> counts =
        refine_by_sweeps(domain->triangulation, domain->segments, criteria, options, progress, {}, {}, &distribution);
    EXPECT_TRUE(counts) << counts.error().message;
  });
}

/// Each triangle is owned by one rank, and held by those that watch one of its corners, and by no other.
void expect_parts_fit(const std::vector<std::vector<Observed::Held>>& ranks) {
  std::set<Corners> owned;
  std::vector<std::set<Corners>> expected(ranks.size()), found(ranks.size());
  for (std::size_t rank = 0; rank < ranks.size(); ++rank)
    for (const Observed::Held& triangle : ranks[rank]) {
      EXPECT_TRUE(found[rank].insert(triangle.corners).second) << "a triangle is held twice";
      if (!triangle.is_own) continue;
      EXPECT_TRUE(owned.insert(triangle.corners).second) << "a triangle is owned twice";
      for (const int watcher : triangle.watchers) expected[watcher].insert(triangle.corners);
    }
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) EXPECT_TRUE(found[rank] == expected[rank]) << "rank " << rank;
}

class Margins : public testing::TestWithParam<std::size_t> {};

TEST_P(Margins, are_the_same_on_all_ranks_after_every_phase) {
  const Case& c = samples::cases()[GetParam()];
  for (const int count : {2, 3, 5}) {
    Observed on_lattice, on_leaves;
    observe(c, samples::options_for(c), count, on_lattice);
    observe(samples::graded(c), samples::options_for_leaves(c), count, on_leaves);
    EXPECT_GE(on_lattice.held.size(), 4U);
    EXPECT_GE(on_leaves.held.size(), 4U);
    for (const Observed* observed : {&on_lattice, &on_leaves})
      for (const auto& phase : observed->held) expect_parts_fit(phase);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Margins, testing::Range(std::size_t{0}, samples::cases().size()),
                         [](const auto& parameter) { return samples::cases()[parameter.param].name; });

}  // namespace
}  // namespace pardel::engine
