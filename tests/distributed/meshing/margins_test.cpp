// After every phase, each rank holds exactly the triangles that it has to hold, all ranks agree on them, and together
// they cover the domain. The same if the ranks began with parts of the domain.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../../../distributed/divided_input/divided_points.hpp"
#include "../../../distributed/meshing/distribution.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "refined_parts.hpp"

namespace pardel::engine {
namespace {

using samples::Case;

/// A triangle as all ranks know it: its corners, from the lexicographically least one on; its region; which of its
/// sides, that after the k-th corner in this order, are constrained.
struct Known {
  std::array<double, 6> corners{};
  Index region = no_index;
  std::array<bool, 3> constrained{};
  friend auto operator<=>(const Known&, const Known&) = default;
};

Known known(const Triangulation& t, TriangleId id) {
  const Slot& slot = t.slots[id];
  const unsigned first = slot.corner_of(least_corner(t, slot));
  Known result;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned corner = (first + i) % 3;
    result.corners[2 * i] = t.points[slot.v[corner]].x;
    result.corners[2 * i + 1] = t.points[slot.v[corner]].y;
    result.constrained[i] = slot.n[corner].constrained();
  }
  if (!t.region.empty()) result.region = t.region[id];
  return result;
}

double area(const Known& triangle) {
  const auto& c = triangle.corners;
  return ((c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1])) / 2;
}

/// What the ranks held after the phases.
struct Observed {
  struct Held {
    Known triangle;
    bool is_own;                ///< it belongs to the piece of this rank
    std::vector<int> watchers;  ///< the ranks that have to hold it
  };
  std::mutex mutex;
  std::vector<std::vector<std::vector<Held>>> held;  ///< [phase][rank]
};

/// Observes the part of its rank after every exchange.
template <class Observable>
class Watched : public Observable {
 public:
  /// `others`: the arguments of Observable.
  template <class... Others>
  Watched(const Triangulation& t, Observed& observed, Others&&... others)
      : Observable(std::forward<Others>(others)...), watched_(t), observed_(observed) {}

  void exchange_changes(std::vector<PlannedTask>& tasks) override {
    Observable::exchange_changes(tasks);
    if (!this->is_in_parts()) return;
    std::vector<Observed::Held> held;
    part().for_each_triangle([&](TriangleId id) {
      const bool is_own = this->owner_of_triangle(id) == network().rank();
      held.push_back({known(watched_, id), is_own, watchers(id)});
      expect_neighbours(id);
    });
    const std::scoped_lock lock(observed_.mutex);
    if (observed_.held.size() <= phase_) observed_.held.resize(phase_ + 1);
    observed_.held[phase_].resize(network().count());
    observed_.held[phase_][network().rank()] = std::move(held);
    ++phase_;
  }

 private:
  using Observable::network;
  using Observable::part;

  [[nodiscard]] std::vector<int> watchers(TriangleId id) const {
    std::vector<int> found;
    for (int rank = 0; rank < network().count(); ++rank)
      if (std::ranges::any_of(watched_.slots[id].v,
                              [&](VertexId v) { return this->ownership().watches(rank, watched_.points[v]); }))
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

void expect_refined(DomainTriangulation& domain, const Case& c, const Options& options, Communicator& communicator) {
  const Result<RefineCounts> counts = samples::refine(domain, c, options, communicator);
  EXPECT_TRUE(counts) << counts.error().message;
}

/// All ranks have the whole domain.
void observe(const Case& c, const Options& options, int count, Observed& observed) {
  properties::on_ranks(count, [&](Ranks& ranks) {
    Result<DomainTriangulation> domain = triangulate_domain(c.pslg, c.goal.convex_hull, 1);
    ASSERT_TRUE(domain);
    Triangulation& t = domain->triangulation;
    Watched<Distribution> distribution(t, observed, ranks, t);
    expect_refined(*domain, c, options, distribution);
  });
}

/// Each rank has a part of the domain.
void observe_divided(const Case& c, const Options& options, int count, Observed& observed) {
  properties::on_ranks(count, [&](Ranks& ranks) {
    samples::with_part_of_domain(c, ranks, [&](PartOfDomain& part, const CurveDivision& division) {
      Watched<DividedPoints> distribution(part.domain.triangulation, observed, ranks, part, division);
      expect_refined(part.domain, c, options, distribution);
    });
  });
}

/// Each triangle is owned by one rank, and held by those that watch one of its corners, and by no other. All ranks know
/// the same of it. Nothing is lost: together they have the area of the domain.
void expect_parts_fit(const std::vector<std::vector<Observed::Held>>& ranks, double area_of_domain) {
  std::set<Known> owned;
  std::vector<std::set<Known>> expected(ranks.size()), found(ranks.size());
  double all = 0;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank)
    for (const Observed::Held& held : ranks[rank]) {
      EXPECT_TRUE(found[rank].insert(held.triangle).second) << "a triangle is held twice";
      if (!held.is_own) continue;
      EXPECT_TRUE(owned.insert(held.triangle).second) << "a triangle is owned twice";
      all += area(held.triangle);
      for (const int watcher : held.watchers) expected[watcher].insert(held.triangle);
    }
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) EXPECT_TRUE(found[rank] == expected[rank]) << "rank " << rank;
  constexpr double rounding = 1e-9;
  EXPECT_NEAR(all, area_of_domain, rounding * area_of_domain);
}

double area_of(const Case& c) {
  const Result<DomainTriangulation> domain = triangulate_domain(c.pslg, c.goal.convex_hull, 1);
  EXPECT_TRUE(domain);
  const Triangulation& t = domain->triangulation;
  double all = 0;
  for (TriangleId id = 0; id < t.slots.size(); ++id) all += area(known(t, id));
  return all;
}

class Margins : public testing::TestWithParam<std::size_t> {};

TEST_P(Margins, are_the_same_on_all_ranks_after_every_phase) {
  const Case& c = samples::cases()[GetParam()];
  const double area = area_of(c);
  for (const int count : {2, 3, 5}) {
    Observed on_lattice, on_leaves;
    observe(c, samples::options_for(c), count, on_lattice);
    observe(samples::graded(c), samples::options_for_leaves(c), count, on_leaves);
    EXPECT_GE(on_lattice.held.size(), 4U);
    EXPECT_GE(on_leaves.held.size(), 4U);
    for (const Observed* observed : {&on_lattice, &on_leaves})
      for (const auto& phase : observed->held) expect_parts_fit(phase, area);
  }
}

TEST_P(Margins, of_divided_domains_are_the_same_on_all_ranks_after_every_phase) {
  const Case& c = samples::cases()[GetParam()];
  const double area = area_of(c);
  for (const int count : {2, 3, 5}) {
    Observed observed;
    observe_divided(c, samples::options_for(c), count, observed);
    EXPECT_GE(observed.held.size(), 4U);
    for (const auto& phase : observed.held) expect_parts_fit(phase, area);
  }
}

/// On the first rank, a task seems to have changed a triangle that lies elsewhere.
class Meddling : public Distribution {
 public:
  Meddling(Ranks& ranks, Triangulation& t) : Distribution(ranks, t), meddled_(t) {}

  void exchange_changes(std::vector<PlannedTask>& tasks) override {
    for (PlannedTask& task : tasks) {
      if (!is_in_parts() || network().rank() > 0 || !task.lists_changes) continue;
      const Box box = ownership().box_of(task.cell);
      part().for_each_triangle([&](TriangleId id) {
        const auto is_outside = [&](VertexId v) { return !box.contains_half_open(meddled_.points[v]); };
        if (task.result.changed.empty() || !std::ranges::all_of(meddled_.slots[id].v, is_outside)) return;
        task.result.changed.assign(1, id);
      });
    }
    Distribution::exchange_changes(tasks);
  }

 private:
  const Triangulation& meddled_;
};

/// The first rank loses the triangles of its margin that have no corner of its own.
class Forgetful : public Distribution {
 public:
  using Distribution::Distribution;

  void divide_by(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) override {
    Distribution::divide_by(tiles, work, runner);
    if (network().rank() > 0) return;
    std::vector<TriangleId> lost;
    part().for_each_triangle([&](TriangleId id) {
      if (std::ranges::none_of(t_.slots[id].v, [&](VertexId v) { return owner_of(v) == 0; })) lost.push_back(id);
    });
    for (const TriangleId id : lost) part_->drop(id);
  }
};

/// What the first of two ranks says.
template <class Wrong>
std::string error_of() {
  const Case& c = samples::cases().front();
  const Options options = samples::options_for(c);
  std::string message;
  properties::on_ranks(2, [&](Ranks& ranks) {
    Result<DomainTriangulation> domain = triangulate_domain(c.pslg, c.goal.convex_hull, 1);
    ASSERT_TRUE(domain);
    Wrong wrong(ranks, domain->triangulation);
    const Result<RefineCounts> counts = samples::refine(*domain, c, options, wrong);
    ASSERT_FALSE(counts);
    EXPECT_EQ(counts.error().kind, ErrorKind::internal);
    if (ranks.rank() == 0) message = counts.error().message;
  });
  return message;
}

TEST(MarginsOfATask, end_the_run_if_it_has_changed_a_triangle_beyond_its_box) {
  const std::string message = error_of<Meddling>();
  EXPECT_NE(message.find("has made a triangle with a corner outside its box"), std::string::npos) << message;
}

TEST(MarginsOfATask, end_the_run_if_they_lack_a_triangle) {
  const std::string message = error_of<Forgetful>();
  EXPECT_NE(message.find("a task needed a triangle that its rank does not hold"), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Every, Margins, testing::Range(std::size_t{0}, samples::cases().size()),
                         [](const auto& parameter) { return samples::cases()[parameter.param].name; });

}  // namespace
}  // namespace pardel::engine
