#include "mesher.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "../core/support/shortest.hpp"
#include "../core/support/stopwatch.hpp"
#include "construction/domain_triangulation.hpp"
#include "construction/hairlines_outside.hpp"
#include "conversion/import_mesh.hpp"
#include "conversion/locate_regions.hpp"
#include "domain/find_problems.hpp"
#include "planning/mesh_valid.hpp"
#include "planning/run_plan.hpp"
#include "planning/supervised.hpp"
#include "quality/criteria.hpp"
#include "quality/exact_goal.hpp"
#include "refinement/goal_met.hpp"
#include "scheduling/progress_monitor.hpp"
#include "scheduling/refine_domain.hpp"
#include "sizing/coverage.hpp"
#include "sizing/graded_size.hpp"
#include "sizing/guarded.hpp"
#include "sizing/local_bound.hpp"

namespace pardel {

using namespace engine;

namespace {

Result<Meshed> validate_and_mesh(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options,
                                 ProgressMonitor& progress) {
  Stopwatch watch;
  progress.expect(static_cast<double>(pslg.points.size()));
  const Threads threads = progress.threads();
  // The triangulation of a point set finds duplicate points, but names only two of them. So all of them are searched
  // for only if it fails.
  const bool leaves_duplicates = is_point_set(pslg) && find_problems_but_duplicates(pslg, threads).empty();
  if (!leaves_duplicates)
    if (Status valid = check_valid(pslg, convex_hull, threads); !valid) return valid.error();
  const double seconds = watch.lap();
  Result<Meshed> result = mesh_valid(pslg, convex_hull, goal, options, progress);
  if (result) result->report.validate_seconds = seconds;
  if (leaves_duplicates && !result && result.error().kind == ErrorKind::invalid_input)
    if (Status valid = check_valid(pslg, convex_hull, threads); !valid) return valid.error();
  return result;
}

Status check_threads(int threads) {
  if (threads >= 0) return Done{};
  return Error{ErrorKind::usage, "the number of threads must be zero or positive, not " + std::to_string(threads)};
}

Status check_sources(std::span<const SizeSource> sources) {
  const auto is_length = [](double length) { return length > 0 && length < INFINITY; };
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const SizeSource& source = sources[i];
    const std::string name = "Goal::sources: source " + std::to_string(i);
    for (const Point p : {source.a, source.b})
      if (!std::isfinite(p.x) || !std::isfinite(p.y))
        return Error{ErrorKind::usage, name + " is not at a finite point"};
    if (!is_length(source.at_a) || !is_length(source.at_b))
      return Error{ErrorKind::usage, name + " at " + shortest(source.a) +
                                         " must have finite lengths greater than 0, not " +
                                         shortest(is_length(source.at_a) ? source.at_b : source.at_a)};
  }
  return Done{};
}

/// The checks of the arguments of refine().
Status check_caps(const Mesh& coarse, std::span<const double> max_areas) {
  if (!max_areas.empty() && max_areas.size() != coarse.triangles.size())
    return Error{ErrorKind::invalid_input, std::to_string(max_areas.size()) + " area caps for a mesh of " +
                                               std::to_string(coarse.triangles.size()) + " triangles"};
  for (std::size_t i = 0; i < max_areas.size(); ++i)
    if (!(max_areas[i] > 0))
      return Error{ErrorKind::invalid_input, "the area cap of triangle " + std::to_string(i + coarse.first_id.value) +
                                                 " must be positive, not " + shortest(max_areas[i])};
  return Done{};
}

Result<Meshed> refine_mesh(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal,
                           const Options& options, ProgressMonitor& progress) {
  Stopwatch watch;
  Meshed result;
  progress.expect(static_cast<double>(coarse.triangles.size()));
  Result<DomainTriangulation> domain = import_mesh(coarse, progress.threads());
  if (!domain) return domain.error();
  InputData input{
      coarse.region_attributes,
      {coarse.points.span(), coarse.attributes_per_point, coarse.point_attributes.span(), coarse.point_markers.span()},
      {}};
  if (!max_areas.empty() || coarse.attributes_per_point > 0)
    for (const Triangle& triangle : coarse.triangles) input.background.push_back(triangle.v);
  std::function<double(Point)> area_cap;
  if (std::ranges::any_of(max_areas, [](double cap) { return cap < INFINITY; })) {
    auto background = std::make_shared<Background>(coarse.points.span(), input.background, progress.threads());
    area_cap = OnBackground<TriangleValues>{std::make_shared<const TriangleValues>(
        TriangleValues{std::move(background), {max_areas.begin(), max_areas.end()}})};
  }
  result.report.triangulate_seconds = watch.lap();

  require_coverage(goal.size, coarse.points.span(), progress.threads());
  const Goal safe = guarded(goal);
  const Criteria criteria(safe, placement_for(goal, options, true), {}, area_cap);
  auto exempt = exemptions_if_met(domain->triangulation, domain->segments, criteria, ExactGoal(safe, area_cap), options,
                                  progress.threads());
  if (exempt)
    result.report.exempt = std::move(*exempt);
  else
    keep_clear(hairlines_outside(domain->triangulation, progress.threads()), domain->triangulation, domain->segments);
  Result<Mesh> mesh =
      exempt ? to_mesh(std::move(*domain), std::move(input), progress.threads())
             : refine_domain(std::move(*domain), criteria, std::move(input), options, progress, result.report);
  if (!mesh) return mesh.error();
  result.mesh = std::move(*mesh);
  if (regions_mix(coarse)) locate_regions(coarse, result.mesh, progress.threads());
  result.report.refine_seconds = watch.lap();
  return result;
}

}  // namespace

Status check_goal(const Goal& goal, const Options& options) {
  const auto refuse = [](const std::string& what, double value) {
    return Error{ErrorKind::usage, what + ", not " + shortest(value)};
  };
  const bool bounded = options.max_vertices > 0;
  if (!(goal.min_angle_deg >= 0 && goal.min_angle_deg <= (bounded ? 45 : largest_min_angle_deg)))
    return refuse(std::string("the minimum angle must lie between 0 and ") + (bounded ? "45" : "33") + " degrees",
                  goal.min_angle_deg);
  if (!(goal.max_area > 0)) return refuse("the largest area must be positive", goal.max_area);
  if (!(goal.max_edge > 0)) return refuse("the longest edge must be positive", goal.max_edge);
  if (!(goal.size_slope >= 0))
    return refuse("the promised slope of the sizes must be zero or positive", goal.size_slope);
  if (!(goal.grading >= least_grading)) return refuse("the limit on gradation must be at least 1e-12", goal.grading);
  if (!(goal.feature_edges >= 0 && goal.feature_edges <= most_feature_edges))
    return refuse("the edges across narrow places must lie between 0 and 1e6", goal.feature_edges);
  if (Status fit = check_sources(goal.sources); !fit) return fit;
  if (!(options.min_edge >= 0 && options.min_edge < INFINITY))
    return refuse("the shortest edge must be zero or positive", options.min_edge);
  if (options.triangles_per_tile == 0) return refuse("the triangles of a tile must be positive", 0);
  return check_threads(options.threads);
}

Result<Meshed> mesh(const ValidPslg& domain, const Goal& goal, const Options& options) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  return supervised(options_for(goal, options), [&](const Options& safe, ProgressMonitor& progress) {
    return mesh_valid(domain.pslg(), domain.convex_hull() || goal.convex_hull, &goal, safe, progress);
  });
}

Result<Meshed> mesh(const Pslg& pslg, const Goal& goal, const Options& options) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  return supervised(options_for(goal, options), [&](const Options& safe, ProgressMonitor& progress) {
    return validate_and_mesh(pslg, goal.convex_hull, &goal, safe, progress);
  });
}

Result<Meshed> triangulate(const ValidPslg& domain, const Options& options) {
  if (Status in_range = check_threads(options.threads); !in_range) return in_range.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return mesh_valid(domain.pslg(), domain.convex_hull(), nullptr, safe, progress);
  });
}

Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull, const Options& options) {
  if (Status in_range = check_threads(options.threads); !in_range) return in_range.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return validate_and_mesh(pslg, convex_hull, nullptr, safe, progress);
  });
}

Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal, const Options& options) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (is_graded(goal))
    return Error{ErrorKind::usage, "a limit on gradation and edges across narrow places need a domain, not a mesh"};
  if (Status fit = check_caps(coarse, max_areas); !fit) return fit.error();
  return supervised(options_for(goal, options), [&](const Options& safe, ProgressMonitor& progress) {
    return refine_mesh(coarse, max_areas, goal, safe, progress);
  });
}

}  // namespace pardel
