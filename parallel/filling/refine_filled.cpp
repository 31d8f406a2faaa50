#include "refine_filled.hpp"

#include <algorithm>
#include <utility>

#include "../scheduling/limits.hpp"
#include "hemmed_in.hpp"
#include "rounds.hpp"

namespace pardel::engine {
namespace {

/// The refinement beside patches makes far fewer vertices than this, unless it splits ever shorter edges beside a
/// border.
std::uint64_t most_vertices(std::uint64_t present, std::uint64_t laid) { return 5 * present + 2 * laid + 100'000; }

/// A round: a filling, and the domain without its patches.
class Round {
 public:
  Round(Filling filling, const Criteria& criteria, std::span<const double> edges, const Options& options)
      : filling_(std::move(filling)),
        domain_(filling_.take_domain()),
        criteria_(criteria.with_patches({edges.begin(), edges.end()})),
        options_(resolvable(options, domain_.triangulation)) {
    const std::uint64_t allowed =
        options.max_vertices > 0 ? options.max_vertices - filling_.inner_points() : UINT64_MAX;
    const std::uint64_t wanted = most_vertices(domain_.triangulation.points.size(), filling_.triangles());
    options_.max_vertices = std::min(allowed, wanted);
    may_run_away_ = wanted < allowed;
  }

  [[nodiscard]] Status refine(const InputData& input, ProgressMonitor& progress) {
    const Threads threads = progress.threads();
    progress.set_aside(filling_.inner_points(), filling_.triangles());
    const auto convert = [&](DomainTriangulation&& snapshot) { return laid_into(std::move(snapshot), input, threads); };
    Result<RefineCounts> counts = refine_by_sweeps(domain_.triangulation, domain_.segments, criteria_, options_,
                                                   progress, {}, watcher(domain_, options_, convert));
    progress.set_aside(0, 0);
    if (!counts) return counts.error();
    counts_ = std::move(*counts);
    // At the caller's limit on vertices, triangles are left with and without patches.
    if (counts_.left_alone && !counts_.budget_reached)
      stuck_ = hemmed_in(domain_.triangulation, domain_.segments, criteria_, options_, threads);
    return Done{};
  }
  [[nodiscard]] bool has_run_away() const { return may_run_away_ && counts_.budget_reached; }
  [[nodiscard]] const std::vector<TriangleId>& stuck() const { return stuck_; }
  [[nodiscard]] const Triangulation& triangulation() const { return domain_.triangulation; }
  [[nodiscard]] std::uint64_t laid() const { return filling_.triangles(); }
  [[nodiscard]] std::uint64_t triangles() const { return domain_.triangulation.slots.size() + filling_.triangles(); }

  void write_report(const Threads& threads, Report& report) {
    engine::write_report(domain_, criteria_, options_, std::move(counts_), threads, report);
    report.laid = filling_.triangles();
  }
  /// The mesh with the patches; only once.
  [[nodiscard]] Result<Mesh> take_mesh(const InputData& input, const Threads& threads) {
    return laid_into(std::move(domain_), input, threads);
  }

 private:
  [[nodiscard]] Result<Mesh> laid_into(DomainTriangulation&& domain, const InputData& input,
                                       const Threads& threads) const {
    Mesh mesh = export_triangulation(domain, input.region_attributes, filling_.points(), threads);
    if (Status laid = filling_.lay(mesh, threads); !laid) return laid.error();
    add_point_data(mesh, domain, input.points, input.background, threads);
    return mesh;
  }

  Filling filling_;
  DomainTriangulation domain_;
  Criteria criteria_;
  Options options_;
  RefineCounts counts_;
  std::vector<TriangleId> stuck_;
  bool may_run_away_ = false;
};

/// The first round after which no triangle is stuck; nothing if the patches have to be given up.
Result<std::optional<Round>> successful_round(const ToFill& what, const DomainTriangulation& coarse,
                                              const Criteria& criteria, const InputData& input, const Options& options,
                                              ProgressMonitor& progress, Report& report) {
  for (Rounds rounds(what.edges);;) {
    Result<std::optional<Filling>> filling = Filling::make(what.pslg, what.convex_hull, coarse, rounds.edges(),
                                                           rounds.clearings(), options, progress.threads());
    if (!filling) return filling.error();
    if (!filling->has_value()) return std::optional<Round>();
    Round round(std::move(**filling), criteria, rounds.edges(), options);
    if (Status refined = round.refine(input, progress); !refined) return refined.error();
    if (round.stuck().empty() && !round.has_run_away()) return std::optional(std::move(round));
    const bool may_go_on = rounds.go_on(round.triangulation(), round.stuck(), round.laid());
    report.restarts = rounds.failed();
    if (!may_go_on || round.has_run_away()) return std::optional<Round>();
  }
}

}  // namespace

Result<Mesh> refine_filled(const ToFill& what, DomainTriangulation domain, const Criteria& criteria,
                           const InputData& input, const Options& options, ProgressMonitor& progress, Report& report) {
  Result<std::optional<Round>> filled = successful_round(what, domain, criteria, input, options, progress, report);
  if (!filled) return filled.error();
  if (!filled->has_value()) return refine_domain(std::move(domain), criteria, input, options, progress, report);
  Report without_patches = report;
  Round& round = **filled;
  const std::uint64_t triangles = round.triangles();
  round.write_report(progress.threads(), report);
  // Where patches are small, they can make more triangles than they save.
  const bool may_be_worse = 2 * round.laid() < triangles || !report.goal_met();
  const std::uint64_t twice_the_vertices = triangles;
  if (may_be_worse && !outgrows_memory(twice_the_vertices, options)) {
    Result<Mesh> refined = refine_domain(std::move(domain), criteria, input, options, progress, without_patches);
    if (!refined) return refined;
    const bool is_better = without_patches.goal_met() != report.goal_met() ? without_patches.goal_met()
                                                                           : refined->triangles.size() < triangles;
    if (is_better) {
      report = std::move(without_patches);
      return refined;
    }
  }
  return round.take_mesh(input, progress.threads());
}

}  // namespace pardel::engine
