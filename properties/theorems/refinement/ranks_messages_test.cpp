// What ranks tell each other while they refine: when, and whom. And what a division among ranks leaves in the mesh.
#include <mutex>
#include <optional>
#include <set>

#include "../../../distributed/meshing/distribution.hpp"
#include "../../../parallel/planning/run_plan.hpp"
#include "../../../parallel/scheduling/progress_monitor.hpp"
#include "../../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../../parallel/triangulation/flips.hpp"
#include "../framework/local_ranks.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

/// Ranks that note when this rank communicates, and to whom it writes.
class NotingRanks final : public Ranks {
 public:
  explicit NotingRanks(Ranks& ranks) : ranks_(ranks) {}
  [[nodiscard]] int rank() const override { return ranks_.rank(); }
  [[nodiscard]] int count() const override { return ranks_.count(); }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
    ++exchanges;
    for (int to = 0; to < count(); ++to)
      if (to != rank() && !messages[to].empty()) receivers.insert(to);
    return ranks_.exchange(std::move(messages));
  }
  void add_up(std::span<std::uint64_t> values) override {
    ++sums;
    ranks_.add_up(values);
  }
  void forget() {
    exchanges = sums = 0;
    receivers.clear();
  }
  int exchanges = 0, sums = 0;
  std::set<int> receivers;

 private:
  Ranks& ranks_;
};

/// What all ranks have seen together.
struct SeenPhases {
  std::mutex mutex;
  std::uint64_t phases = 0, messages = 0;
  std::uint64_t other_rhythms = 0;       ///< phases with other steps than one exchange before, and one after
  std::uint64_t far_seeds = 0;           ///< messages before a phase to ranks that own no tile that touches an own one
  std::uint64_t far_changes = 0;         ///< messages after a phase to ranks that own no tile near a refined one
  std::uint64_t constrained_inside = 0;  ///< constrained edges that are on no segment, after a phase
  std::uint64_t not_delaunay = 0;        ///< other edges that are not locally Delaunay, after a phase
};

/// The part of one rank, which looks at the messages and at the mesh of every phase.
class WatchedPhases : public engine::Distribution {
 public:
  WatchedPhases(NotingRanks& ranks, engine::DomainTriangulation& domain, SeenPhases& seen)
      : Distribution(ranks, domain.triangulation), noting_(ranks), domain_(domain), seen_(seen) {}

  void divide_by(const engine::Tiles& finest, std::span<const double> work, engine::PhaseRunner& runner) override {
    Distribution::divide_by(finest, work, runner);
    tiles_ = finest;
  }
  void deliver(std::vector<engine::PlannedTask>& tasks) override {
    noting_.forget();
    Distribution::deliver(tasks);
    if (!is_in_parts()) return;
    std::set<int> near;
    for (Index cell = 0; cell < tiles_->cells(); ++cell)
      if (ownership().owner(cell) == noting_.rank()) add_owners_near(cell, near);
    const std::scoped_lock lock(seen_.mutex);
    seen_.other_rhythms += noting_.exchanges == 1 && noting_.sums == 0 ? 0 : 1;
    seen_.far_seeds += far_receivers(near);
  }
  void exchange_changes(std::vector<engine::PlannedTask>& tasks) override {
    std::set<int> near;
    for (const engine::PlannedTask& task : tasks)
      if (is_in_parts() && !task.elsewhere) add_owners_near(task.cell, near);
    noting_.forget();
    Distribution::exchange_changes(tasks);
    if (!is_in_parts()) return;
    const std::scoped_lock lock(seen_.mutex);
    ++seen_.phases;
    seen_.messages += noting_.receivers.size();
    seen_.other_rhythms += noting_.exchanges == 1 && noting_.sums == 0 ? 0 : 1;
    seen_.far_changes += far_receivers(near);
    part().for_each_triangle([&](TriangleId id) { look_at(id); });
  }

 private:
  using Index = pardel::Index;
  using TriangleId = engine::TriangleId;
  using VertexId = engine::VertexId;

  /// On a lattice, a rank holds triangles in boxes of its tiles. On a quadtree, it holds those in leaves that touch its
  /// own, so a task concerns the owners of leaves that touch one which touches its own.
  void add_owners_near(Index cell, std::set<int>& owners) const {
    for (const Index near : tiles_->touching(cell)) {
      owners.insert(ownership().owner(near));
      if (tiles_->lattice() == nullptr)
        for (const Index next : tiles_->touching(near)) owners.insert(ownership().owner(next));
    }
  }
  [[nodiscard]] std::uint64_t far_receivers(const std::set<int>& near) const {
    return static_cast<std::uint64_t>(
        std::ranges::count_if(noting_.receivers, [&](int rank) { return !near.contains(rank); }));
  }
  void look_at(TriangleId id) {
    const engine::Triangulation& t = domain_.triangulation;
    const engine::Slot& slot = t.slots[id];
    for (unsigned side = 0; side < 3; ++side) {
      const engine::EdgeRef across = slot.n[side];
      if (across.constrained()) {
        seen_.constrained_inside += is_on_a_segment(slot.from(side), slot.to(side)) ? 0 : 1;
      } else if (!part().is_beyond(across)) {
        seen_.not_delaunay += engine::delaunay_across(t, engine::EdgeRef(id, side)) ? 0 : 1;
      }
    }
  }
  [[nodiscard]] bool is_on_a_segment(VertexId a, VertexId b) const {
    const auto& segments = domain_.segments;
    for (Index s = 0; s < segments.size(); ++s) {
      const auto touches = [&](VertexId v) {
        return v == segments[s].a || v == segments[s].b || domain_.triangulation.origin[v] == origin_on_segment(s);
      };
      if (touches(a) && touches(b)) return true;
    }
    return false;
  }

  NotingRanks& noting_;
  engine::DomainTriangulation& domain_;
  SeenPhases& seen_;
  std::optional<engine::Tiles> tiles_;
};

/// Refines a random domain on two to six ranks.
void refine_on_watched_ranks(Exhibit& exhibit, SeenPhases& seen) {
  Problem problem = some_problem(exhibit);
  const double extent = extent_of(problem.pslg);
  if (*rc::gen::inRange(0, 4) != 0)
    problem.goal.max_area = std::min(problem.goal.max_area, extent * extent / *rc::gen::inRange(100, 400));
  Options options = some_options();
  options.triangles_per_tile = *rc::gen::inRange(2U, 20U);
  options.decomposition = *rc::gen::element(Decomposition::automatic, Decomposition::paper, Decomposition::quadtree,
                                            Decomposition::paper_quadtree);
  const auto valid = validate(problem.pslg, {.convex_hull = problem.goal.convex_hull});
  RC_ASSERT(valid.ok());
  on_ranks(*rc::gen::inRange(2, 7), [&](Ranks& local) {
    NotingRanks ranks(local);
    engine::ProgressMonitor progress(options);
    auto domain = engine::triangulate_domain(valid->pslg(), valid->convex_hull(), progress.threads());
    if (!domain) throw Stopped{domain.error()};
    const auto plan = engine::plan_run(valid->pslg(), problem.goal, *domain, options, progress.threads());
    if (!plan) throw Stopped{plan.error()};
    WatchedPhases part(ranks, *domain, seen);
    const auto counts = engine::refine_by_sweeps(domain->triangulation, domain->segments, plan->criteria, options,
                                                 progress, {}, {}, part);
    if (!counts) throw Stopped{counts.error()};
  });
}

PARDEL_PROPERTY(
    Ranks, write_once_in_a_phase_and_only_to_owners_of_touching_tiles,
    {.statement = "In a phase of a divided mesh, a rank sends triangles that wait once before its tasks, and what they "
                  "have changed once after them. It writes only to owners of tiles that touch its own or, for changes, "
                  "those which it has refined; on a quadtree also to those of leaves that touch these.",
     .source = "[CC], structured bulk communication; properties/THEORY_OF_RANKS.md, Ranks (b)",
     .families = every_family}) {
  SeenPhases seen;
  refine_on_watched_ranks(exhibit, seen);
  classify(seen.messages > 0, "changes are sent", 15);
  RC_ASSERT(seen.other_rhythms == 0U);
  RC_ASSERT(seen.far_changes == 0U);
  RC_ASSERT(seen.far_seeds == 0U);
}

PARDEL_PROPERTY(
    Ranks, have_no_border_of_a_tile_or_a_rank_in_the_mesh_after_any_phase,
    {.statement = "After each phase every constrained edge lies on a segment of the domain, and every other edge is "
                  "locally Delaunay: no border of a tile or of a rank's part is ever an edge that has to stay.",
     .source = "[CC], decomposition independence",
     .families = every_family}) {
  SeenPhases seen;
  refine_on_watched_ranks(exhibit, seen);
  classify(seen.messages > 0, "divided among ranks", 15);
  RC_ASSERT(seen.constrained_inside == 0U);
  RC_ASSERT(seen.not_delaunay == 0U);
}

}  // namespace
}  // namespace pardel::properties
