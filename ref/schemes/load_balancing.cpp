#include "load_balancing.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "workers/territory.hpp"

namespace pardel::schemes {
namespace {

class TileLevels {
 public:
  TileLevels(const Problem& problem, const LoadBalancingOptions& options, Start start)
      : problem_(problem),
        options_(options),
        mesh_(std::move(start.mesh)),
        bounds_(std::move(start.bounds)),
        account_(start.account),
        inputs_(mesh_.points.size()),
        territory_(mesh_, bounds_, problem.workers) {
    options_.rules.seed += problem.seed;
    const int workers = options.lattice_for_workers > 0 ? options.lattice_for_workers : problem.workers;
    while (per_side_ < 4096 && per_side_ * per_side_ < options.tiles_per_worker * workers) per_side_ *= 2;
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      if (needs_work(mesh_, t, bounds_)) later_.push_back(known(mesh_, t));
  }

  /// One worker begins. Lattices of 1 or 2 by 2 tiles have no two tiles of a colour.
  void run() {
    int per_side = std::min(per_side_, 4);
    const TileLattice first(mesh_, per_side);
    alone({bounds_, first, options_.share_of_side * first.side(), problem_.most_points}, std::exchange(later_, {}));
    for (; per_side <= per_side_ && has_room(); per_side *= 2) {
      const TileLattice lattice(mesh_, per_side);
      const double least = per_side == per_side_ ? 0 : options_.share_of_side * lattice.side() / 2;
      level({bounds_, lattice, least, problem_.most_points});
    }
  }

  [[nodiscard]] bool has_room() const { return mesh_.points.size() <= problem_.most_points; }

  [[nodiscard]] Balanced result() && {
    compact(mesh_);
    number_by_place(mesh_, inputs_);
    account_.insertions = mesh_.points.size() - inputs_;
    return {{std::move(mesh_), account_}, counts_, std::move(traces_)};
  }

 private:
  void alone(const TileRules& rules, std::vector<KnownTriangle> items) {
    TileReport report = work_alone(mesh_, rules, std::move(items));
    later_.insert(later_.end(), report.later.begin(), report.later.end());
    account_.sequential += report.work;
    account_.critical += report.work;
    if (account_.work == 0) account_.before = account_.critical;
  }

  [[nodiscard]] std::vector<int> placed(const TileLattice& lattice) const {
    std::vector<int> owners(static_cast<std::size_t>(lattice.count()), 0);
    for (int tile = 0; tile < lattice.count(); ++tile) {
      int& owner = owners[static_cast<std::size_t>(tile)];
      if (options_.placement == Placement::territory) owner = territory_.owner(lattice.centre(tile));
      if (options_.placement == Placement::rows)
        owner = static_cast<int>(static_cast<std::int64_t>(tile) * problem_.workers / lattice.count());
    }
    return owners;
  }

  void level(const TileRules& rules) {
    std::vector<std::uint64_t> sizes(static_cast<std::size_t>(rules.lattice.count()), 0);
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      if (mesh_.in_use(t)) ++sizes[static_cast<std::size_t>(rules.lattice.tile_of(mesh_, t))];
    const std::vector<int> owners = placed(rules.lattice);
    if (options_.traces) traces_.push_back({rules.lattice.per_side(), owners, {}});
    Balancer balancer(rules.lattice, owners, std::move(sizes), problem_.workers, options_.rules, account_, counts_);
    std::vector<KnownTriangle> left;
    for (const KnownTriangle& each : std::exchange(later_, {})) {
      if (!is_current(mesh_, each)) continue;
      const int tile = tile_for(mesh_, each.triangle, rules.lattice);
      if (!is_due(mesh_, each.triangle, rules.least_radius)) {
        later_.push_back(each);
      } else if (tile < 0) {
        left.push_back(each);
      } else {
        balancer.add(tile, each);
      }
    }
    const auto work = [&](int tile, std::vector<KnownTriangle> items) {
      TileReport report = work_on_tile(mesh_, rules, tile, std::move(items));
      left.insert(left.end(), report.left.begin(), report.left.end());
      later_.insert(later_.end(), report.later.begin(), report.later.end());
      return report;
    };
    while (has_room() && balancer.run_phase(work, options_.traces ? &traces_.back() : nullptr)) {
    }
    std::vector<std::uint64_t> held(static_cast<std::size_t>(problem_.workers), 0);
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      if (mesh_.in_use(t)) ++held[static_cast<std::size_t>(balancer.owner(rules.lattice.tile_of(mesh_, t)))];
    account_.most_held = std::max(account_.most_held, *std::ranges::max_element(held));
    alone(rules, std::move(left));
  }

  const Problem& problem_;
  LoadBalancingOptions options_;
  LinkedMesh mesh_;
  Bounds bounds_;
  Account account_;
  std::size_t inputs_;
  Territory territory_;
  int per_side_ = 1;
  BalancingCounts counts_;
  std::vector<BalancingTrace> traces_;
  std::vector<KnownTriangle> later_;
};

}  // namespace

Result<Balanced> load_balancing_with_counts(const Problem& problem, const LoadBalancingOptions& options) {
  Result<Start> start = start_of(problem);
  if (!start) return start.error();
  TileLevels levels(problem, options, std::move(start).value());
  levels.run();
  if (!levels.has_room()) return too_many_points(problem);
  return std::move(levels).result();
}

Result<Outcome> load_balancing(const Problem& problem, const LoadBalancingOptions& options) {
  Result<Balanced> balanced = load_balancing_with_counts(problem, options);
  if (!balanced) return balanced.error();
  return std::move(balanced->outcome);
}

}  // namespace pardel::schemes
