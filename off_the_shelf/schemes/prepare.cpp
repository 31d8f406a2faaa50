#include "prepare.hpp"

#include <algorithm>
#include <cmath>

#include "../../parallel/planning/expected_size.hpp"
#include "../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../parallel/sizing/graded_size.hpp"

namespace pardel::engine {
namespace {

/// The lengths of the coarse mesh in lengths of the final one. Measured: with 4, the frozen borders of the first sweep
/// keep the mesher from about a tenth of the mesh, and pardel's own refiner makes a fifteenth of the vertices.
constexpr double coarseness = 4;

/// From the segments, lengths grow by this number per unit of distance.
constexpr double growth_from_segments = 0.5;

/// The longest edge of an average triangle is this number times the root of its area.
constexpr double edge_of_unit_area = 1.7;

Goal coarse(Goal goal) {
  goal.max_area *= coarseness * coarseness;
  goal.max_edge *= coarseness;
  goal.size_slope *= coarseness;
  if (goal.size) goal.size = [fine = goal.size](Point p) { return coarseness * fine(p); };
  return goal;
}

/// The pieces of a constrained side, each with its final length.
void add_sources(const MesherRun& run, EdgeRef e, std::vector<SizeSource>& sources) {
  const Triangulation& t = run.mesh.t;
  const Point a = t.points[t.slot(e).from(e.side())], b = t.points[t.slot(e).to(e.side())];
  const Index region = run.mesh.assessor.region_of(e.triangle());
  LocalHints hints;
  const auto length_at = [&](Point p) {
    return edge_of_unit_area * std::sqrt(run.criteria.twice_area_wanted(p, region, hints) / 2);
  };
  // Where sizes depend on the place, a long side gets several lengths.
  const int pieces = run.criteria.depends_on_place() ? 64 : 1;
  const auto place = [&](int i) {
    const double part = static_cast<double>(i) / pieces;
    return Point{std::lerp(a.x, b.x, part), std::lerp(a.y, b.y, part)};
  };
  for (int i = 0; i < pieces; ++i) {
    const SizeSource source{place(i), place(i + 1), length_at(place(i)), length_at(place(i + 1))};
    if (source.at_a < INFINITY && source.at_b < INFINITY) sources.push_back(source);
  }
}

/// Adds lengths that grow from the final ones of the segments.
void grow_from_segments(const MesherRun& run, const Pslg& pslg, Goal& goal) {
  goal.grading = growth_from_segments;
  const Triangulation& t = run.mesh.t;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side)
      if (t.slots[id].n[side].constrained()) add_sources(run, EdgeRef(id, side), goal.sources);
  goal.size = graded_size(goal, pslg, run.threads);
  goal.grading = INFINITY;
  goal.sources.clear();
}

}  // namespace

Status prepare(MesherRun& run, const Pslg& pslg, Triangulation& t, ProgressMonitor& progress, bool split_segments) {
  const double expected = expected_triangles(t, run.criteria, run.options.min_edge, run.threads);
  if (!run.criteria.has_size() || expected <= run.how.triangles_per_task) return Done{};
  Goal goal = coarse(run.goal);
  if (split_segments) grow_from_segments(run, pslg, goal);
  std::vector<double> caps = run.region_caps;
  for (double& cap : caps) cap *= coarseness * coarseness;
  const Criteria criteria(goal, Placement::off_centre, caps);
  Result<RefineCounts> counts =
      refine_by_sweeps(t, run.mesh.segments, criteria, run.options, progress, Schedule{}, Watcher{});
  if (!counts) return counts.error();
  run.report.prepared = counts->inserted + counts->segment_splits;
  return Done{};
}

}  // namespace pardel::engine
