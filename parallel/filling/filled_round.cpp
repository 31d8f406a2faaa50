#include "filled_round.hpp"

#include <algorithm>
#include <utility>

#include "hemmed_in.hpp"
#include "rounds.hpp"

namespace pardel::engine {
namespace {

/// The refinement beside patches makes far fewer vertices than this, unless it splits ever shorter edges beside a
/// border.
std::uint64_t most_vertices(std::uint64_t present, std::uint64_t laid) { return 5 * present + 2 * laid + 100'000; }

}  // namespace

FilledRound::FilledRound(Filling filling, const Criteria& criteria, std::span<const double> edges,
                         const Options& options, std::uint64_t pieces)
    : filling_(std::move(filling)),
      domain_(filling_.take_domain()),
      criteria_(criteria.with_patches({edges.begin(), edges.end()})),
      options_(options),
      pieces_(pieces) {
  const std::uint64_t allowed = options.max_vertices > 0 ? options.max_vertices - filling_.inner_points() : UINT64_MAX;
  const std::uint64_t wanted = most_vertices(domain_.triangulation.points.size(), filling_.triangles());
  options_.max_vertices = std::min(allowed, wanted);
  may_run_away_ = wanted < allowed;
}

Status FilledRound::refine(const InputData& input, ProgressMonitor& progress) {
  const Threads threads = progress.threads();
  progress.set_aside(filling_.inner_points() / pieces_, filling_.triangles() / pieces_);  // what is in memory at once
  const auto convert = [&](DomainTriangulation&& snapshot) { return laid_into(std::move(snapshot), input, threads); };
  Result<RefineCounts> counts = refine_by_sweeps(domain_.triangulation, domain_.segments, criteria_, options_, progress,
                                                 {}, watcher(domain_, options_, convert));
  progress.set_aside(0, 0);
  if (!counts) return counts.error();
  counts_ = std::move(*counts);
  // At the caller's limit on vertices, triangles are left with and without patches.
  if (counts_.left_alone && !counts_.budget_reached)
    stuck_ = hemmed_in(domain_.triangulation, domain_.segments, criteria_, options_, threads);
  return Done{};
}

void FilledRound::write_report(const Threads& threads, Report& report) {
  engine::write_report(domain_, criteria_, options_, std::move(counts_), threads, report);
  name_apexes(domain_, report);
  report.laid = filling_.triangles();
}

Mesh FilledRound::take_mesh_around(const InputData& input, const Threads& threads) {
  Mesh mesh = export_triangulation(domain_, input.region_attributes, filling_.points(), threads);
  add_point_data(mesh, domain_, input.points, input.background, threads);
  return mesh;
}

Result<Mesh> FilledRound::laid_into(DomainTriangulation&& domain, const InputData& input,
                                    const Threads& threads) const {
  Mesh mesh = export_triangulation(domain, input.region_attributes, filling_.points(), threads);
  if (Status laid = filling_.lay(mesh, threads); !laid) return laid.error();
  add_point_data(mesh, domain, input.points, input.background, threads);
  return mesh;
}

Result<std::optional<FilledRound>> successful_round(const ToFill& what, const DomainTriangulation& coarse,
                                                    const Criteria& criteria, const InputData& input,
                                                    const Options& options, ProgressMonitor& progress, Report& report) {
  for (Rounds rounds(what.edges);;) {
    Result<std::optional<Filling>> filling =
        Filling::make(what.pslg, what.convex_hull, coarse, rounds.edges(), rounds.clearings(), options,
                      progress.threads(), what.pieces);
    if (!filling) return filling.error();
    if (!filling->has_value()) return std::optional<FilledRound>();
    FilledRound round(std::move(**filling), criteria, rounds.edges(), options, what.pieces);
    if (Status refined = round.refine(input, progress); !refined) return refined.error();
    if (round.stuck().empty() && !round.has_run_away()) return std::optional(std::move(round));
    const bool may_go_on = rounds.go_on(round.triangulation(), round.stuck(), round.laid());
    report.restarts = rounds.failed();
    if (!may_go_on || round.has_run_away()) return std::optional<FilledRound>();
  }
}

bool may_be_worse(const Candidate& filled, std::uint64_t laid) {
  return 2 * laid < filled.triangles || !filled.goal_met;
}

bool is_better(const Candidate& refined, const Candidate& filled) {
  return refined.goal_met != filled.goal_met ? refined.goal_met : refined.triangles < filled.triangles;
}

}  // namespace pardel::engine
