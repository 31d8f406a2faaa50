#include "run_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../diagnosis/find_least_size.hpp"
#include "../filling/filling.hpp"
#include "../mesher.hpp"
#include "../sizing/coverage.hpp"
#include "../sizing/graded_size.hpp"
#include "../sizing/guarded.hpp"
#include "../threads/parallel_for.hpp"
#include "expected_size.hpp"

namespace pardel::engine {
namespace {

/// The corners of the triangles.
std::vector<Point> corners_of(const Triangulation& t, const Threads& threads) {
  SparseAsk ask(threads.stop);
  std::vector<char> is_corner(t.points.size());
  for (const Slot& slot : t.slots) {
    ask();
    for (const VertexId v : slot.v) is_corner[v] = 1;
  }
  std::vector<Point> corners;
  for (VertexId v = 0; v < is_corner.size(); ++v)
    if (is_corner[v] != 0) corners.push_back(t.points[v]);
  return corners;
}

/// Calls options.before_refinement, if there is one. Its error ends the run.
Status announce_size(const DomainTriangulation& domain, const Goal& goal, const Criteria& criteria,
                     const Options& options, const Threads& threads) {
  if (!options.before_refinement) return Done{};
  LeastSize size =
      find_least_size(domain, may_split_all_segments(options) ? goal.min_angle_deg : 0, options.min_edge, threads);
  size.expected =
      std::max(size.expected, expected_triangles(domain.triangulation, criteria, options.min_edge, threads));
  return options.before_refinement(size);
}

bool bounds_lengths(const Goal& goal) { return goal.max_edge < INFINITY || goal.size || is_graded(goal); }

}  // namespace

Placement placement_for(const Goal& goal, const Options& options, bool refines) {
  if (options.placement != Placement::automatic) return options.placement;
  constexpr double critical_angle_deg = 30;  // of the triangles around the centre of an equilateral triangle
  // Measured: where lengths are bounded, off-centres make smaller meshes up to about 32 degrees.
  const bool searches = refines ? goal.min_angle_deg >= critical_angle_deg
                                : goal.min_angle_deg > critical_angle_deg && !bounds_lengths(goal);
  return searches ? Placement::search : Placement::off_centre;
}

namespace {

/// True if the interior is to be filled, where there is a bound on size.
bool is_filled(const Goal& goal, const Options& options) {
  if (goal.size || is_graded(goal) || goal.user_test) return false;
  if (options.interior != Interior::automatic) return options.interior == Interior::fill;
  // For larger angles, patches often have to give way, except for a search under bounds on areas.
  constexpr double largest_angle_deg = 30;
  const bool searches = placement_for(goal, options, false) == Placement::search && !bounds_lengths(goal);
  return goal.min_angle_deg <= (searches ? largest_min_angle_deg : largest_angle_deg) &&
         !is_of_the_paper(options.decomposition) && may_split_all_segments(options);
}

/// The lengths of the edges of patches that keep the goal: in each region, and last in triangles without a region.
/// Empty if the interior is to be refined.
std::vector<double> edges_of_patches(const Pslg& pslg, const Goal& goal, const Options& options) {
  std::vector<double> edges;
  if (!is_filled(goal, options)) return edges;
  for (const Region& region : pslg.regions)
    edges.push_back(
        edge_of_patch(goal.region_caps ? std::min(goal.max_area, region.max_area) : goal.max_area, goal.max_edge));
  edges.push_back(edge_of_patch(goal.max_area, goal.max_edge));
  if (std::ranges::all_of(edges, [](double edge) { return edge == INFINITY; })) edges.clear();
  return edges;
}

}  // namespace

Result<RunPlan> plan_run(const Pslg& pslg, const Goal& goal, const DomainTriangulation& domain, const Options& options,
                         const Threads& threads) {
  if (ends_somewhere(goal.size)) require_coverage(goal.size, corners_of(domain.triangulation, threads), threads);
  Goal graded = guarded(goal);
  if (is_graded(graded)) {
    graded.size = graded_size(graded, pslg, threads);
    graded.grading = INFINITY;
    graded.feature_edges = 0;
    graded.sources.clear();
  }
  std::vector<double> caps;
  if (goal.region_caps)
    for (const Region& region : pslg.regions) caps.push_back(region.max_area);
  Criteria criteria(graded, placement_for(goal, options, false), caps);
  if (Status wanted = announce_size(domain, goal, criteria, options, threads); !wanted) return wanted.error();
  return RunPlan{std::move(graded), std::move(caps), std::move(criteria), edges_of_patches(pslg, goal, options)};
}

}  // namespace pardel::engine
