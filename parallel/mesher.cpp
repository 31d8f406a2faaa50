#include "mesher.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "../core/support/shortest.hpp"
#include "../core/support/stopwatch.hpp"
#include "arithmetic/predicates.hpp"
#include "concurrency/parallel_for.hpp"
#include "conversion/domain_triangulation.hpp"
#include "conversion/guarded.hpp"
#include "conversion/hairlines_outside.hpp"
#include "conversion/import_mesh.hpp"
#include "conversion/locate_regions.hpp"
#include "criteria/criteria.hpp"
#include "criteria/exact_goal.hpp"
#include "diagnosis/find_gaps.hpp"
#include "filling/refine_domain.hpp"
#include "filling/refine_filled.hpp"
#include "input/findings.hpp"
#include "interpolation/coverage.hpp"
#include "interpolation/graded_size.hpp"
#include "interpolation/local_bound.hpp"
#include "interpolation/steep_edges.hpp"
#include "planning/region_sizes.hpp"
#include "planning/run_plan.hpp"
#include "planning/supervised.hpp"
#include "refinement/goal_met.hpp"
#include "scheduling/limits.hpp"
#include "scheduling/progress_monitor.hpp"

namespace pardel {

using namespace engine;

namespace {

Status check_valid(const Pslg& pslg, bool convex_hull, const Threads& threads) {
  const std::vector<Problem> problems = find_problems(pslg, {.convex_hull = convex_hull}, threads);
  if (problems.empty()) return Done{};
  return Error{ErrorKind::invalid_input, messages(problems, pslg.first_id.value)};
}

/// Refines the triangulation of a valid Pslg until it meets the goal.
Result<Mesh> refined_mesh(const Pslg& pslg, bool convex_hull, const Goal& goal, DomainTriangulation domain,
                          InputData input, const Options& options, ProgressMonitor& progress, Report& report) {
  report.gaps = find_gaps(domain, progress.threads());
  Result<RunPlan> plan = plan_run(pslg, goal, domain, options, progress.threads());
  if (!plan) return plan.error();
  if (plan->edges_of_patches.empty())
    return refine_domain(std::move(domain), plan->criteria, std::move(input), options, progress, report);
  return refine_filled({pslg, convex_hull, std::move(plan->edges_of_patches)}, std::move(domain), plan->criteria, input,
                       options, progress, report);
}

/// Makes the mesh of a valid Pslg, or only its constrained Delaunay triangulation if `goal` is null.
Result<Meshed> mesh_valid(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options,
                          ProgressMonitor& progress) {
  Stopwatch watch;
  Meshed result;
  if (outgrows_memory(pslg.points.size(), options)) return too_much_memory(options);
  Result<DomainTriangulation> domain = triangulate_domain(pslg, convex_hull, progress.threads());
  if (!domain) return domain.error();
  InputData input = input_data(pslg, *domain, progress.threads());
  result.report.triangulate_seconds = watch.lap();

  Result<Mesh> mesh = goal == nullptr ? Result<Mesh>(to_mesh(std::move(*domain), std::move(input), progress.threads()))
                                      : refined_mesh(pslg, convex_hull, *goal, std::move(*domain), std::move(input),
                                                     options, progress, result.report);
  if (!mesh) return mesh.error();
  result.mesh = std::move(*mesh);
  result.report.refine_seconds = watch.lap();
  return result;
}

Result<Meshed> validate_and_mesh(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options,
                                 ProgressMonitor& progress) {
  Stopwatch watch;
  const Threads& threads = progress.threads();
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

template <class Points>
Status check_sizes(const Points& of, std::span<const double> sizes) {
  if (sizes.size() != of.points.size())
    return Error{ErrorKind::invalid_input,
                 std::to_string(sizes.size()) + " sizes for " + std::to_string(of.points.size()) + " points"};
  for (std::size_t v = 0; v < sizes.size(); ++v)
    if (!(sizes[v] > 0 && sizes[v] < INFINITY))
      return Error{ErrorKind::invalid_input, "the size at point " + std::to_string(v + of.first_id.value) +
                                                 " must be positive, not " + shortest(sizes[v])};
  return Done{};
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

/// The triangles of a background, counter-clockwise.
Result<std::vector<std::array<Index, 3>>> triangles_of_background(const Mesh& mesh) {
  if (mesh.triangles.empty()) return Error{ErrorKind::invalid_input, "the mesh of the sizes has no triangles"};
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Index, 3> v = triangle.v;
    const auto fault = [&](const char* what) {
      return Error{ErrorKind::invalid_input, "triangle " + std::to_string(triangles.size() + mesh.first_id.value) +
                                                 " of the mesh of the sizes " + what};
    };
    if (std::ranges::any_of(v, [&](Index i) { return i >= mesh.points.size(); }))
      return fault("has a corner that does not exist");
    const double area = orient2d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]);
    if (area == 0) return fault("is flat");
    if (area < 0) std::swap(v[0], v[1]);
    triangles.push_back(v);
  }
  return triangles;
}

/// The function that interpolates the sizes at the points of a background.
std::function<double(Point)> size_on(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles,
                                     std::span<const double> sizes, bool limited, std::string name,
                                     const Threads& threads) {
  PointValues field{std::make_shared<Background>(points, std::move(triangles), threads),
                    {sizes.begin(), sizes.end()},
                    limited,
                    std::move(name)};
  return OnBackground<PointValues>{std::make_shared<const PointValues>(std::move(field))};
}

Status check_grading(double grading) {
  if (grading > 0 && grading < INFINITY) return Done{};
  return Error{ErrorKind::usage, "the limit on gradation must be finite and positive, not " + shortest(grading)};
}

/// Precondition: the Pslg is valid and check_sizes() accepts the sizes.
Result<std::function<double(Point)>> interpolate_sizes(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull, const Options& options,
                                                       ProgressMonitor& progress) {
  const Result<Meshed> meshed = mesh_valid(pslg, convex_hull, nullptr, options, progress);
  if (!meshed) return meshed.error();
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : meshed->mesh.triangles) triangles.push_back(triangle.v);
  return size_on(pslg.points, std::move(triangles), sizes, false, {}, progress.threads());
}

/// The checks of the arguments of refine().
Status check_caps(const Mesh& coarse, std::span<const double> max_areas) {
  if (!max_areas.empty() && max_areas.size() != coarse.triangles.size())
    return Error{ErrorKind::invalid_input, std::to_string(max_areas.size()) + " area caps for a mesh of " +
                                               std::to_string(coarse.triangles.size()) + " triangles"};
  for (std::size_t i = 0; i < max_areas.size(); ++i)
    if (!(max_areas[i] > 0))
      return Error{ErrorKind::invalid_input, "the area cap of triangle " + std::to_string(i) +
                                                 " must be positive, not " + shortest(max_areas[i])};
  return Done{};
}

Result<Meshed> refine_mesh(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal,
                           const Options& options, ProgressMonitor& progress) {
  Stopwatch watch;
  Meshed result;
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
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return mesh_valid(domain.pslg(), domain.convex_hull() || goal.convex_hull, &goal, safe, progress);
  });
}

Result<Meshed> mesh(const Pslg& pslg, const Goal& goal, const Options& options) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
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
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return refine_mesh(coarse, max_areas, goal, safe, progress);
  });
}

Result<std::function<double(Point)>> interpolated_size(const ValidPslg& domain, std::span<const double> sizes,
                                                       const Options& options) {
  if (Status fit = check_sizes(domain.pslg(), sizes); !fit) return fit.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return interpolate_sizes(domain.pslg(), sizes, domain.convex_hull(), safe, progress);
  });
}

Result<std::function<double(Point)>> interpolated_size(const Mesh& background, std::span<const double> sizes,
                                                       const Options& options, std::string name) {
  using Size = Result<std::function<double(Point)>>;
  if (Status fit = check_sizes(background, sizes); !fit) return fit.error();
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Size {
    Result<std::vector<std::array<Index, 3>>> triangles = triangles_of_background(background);
    if (!triangles) return triangles.error();
    return size_on(background.points.span(), std::move(*triangles), sizes, true, std::move(name), progress.threads());
  });
}

Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull, const Options& options) {
  if (Status fit = check_sizes(pslg, sizes); !fit) return fit.error();
  using Size = Result<std::function<double(Point)>>;
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) -> Size {
    if (Status valid = check_valid(pslg, convex_hull, progress.threads()); !valid) return valid.error();
    return interpolate_sizes(pslg, sizes, convex_hull, safe, progress);
  });
}

Result<std::vector<SizeSource>> size_sources(const ValidPslg& domain, std::span<const double> sizes, double grading,
                                             const Options& options) {
  using Sources = Result<std::vector<SizeSource>>;
  if (Status fit = check_sizes(domain.pslg(), sizes); !fit) return fit.error();
  if (Status in_range = check_grading(grading); !in_range) return in_range.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) -> Sources {
    const Result<Meshed> meshed = mesh_valid(domain.pslg(), domain.convex_hull(), nullptr, safe, progress);
    if (!meshed) return meshed.error();
    std::vector<std::array<Index, 3>> triangles;
    for (const Triangle& triangle : meshed->mesh.triangles) triangles.push_back(triangle.v);
    return steep_edges(domain.pslg().points, triangles, sizes, grading);
  });
}

Result<std::vector<SizeSource>> size_sources(const Mesh& background, std::span<const double> sizes, double grading) {
  using Sources = Result<std::vector<SizeSource>>;
  if (Status fit = check_sizes(background, sizes); !fit) return fit.error();
  if (Status in_range = check_grading(grading); !in_range) return in_range.error();
  return supervised(Options{}, [&](const Options&, ProgressMonitor&) -> Sources {
    Result<std::vector<std::array<Index, 3>>> triangles = triangles_of_background(background);
    if (!triangles) return triangles.error();
    return steep_edges(background.points.span(), *triangles, sizes, grading);
  });
}

Result<RegionSizes> region_sizes(const ValidPslg& domain, std::span<const double> lengths, const Options& options) {
  const std::size_t regions = domain.pslg().regions.size();
  if (lengths.size() != regions)
    return Error{ErrorKind::invalid_input,
                 std::to_string(lengths.size()) + " lengths for " + std::to_string(regions) + " regions"};
  for (std::size_t r = 0; r < regions; ++r)
    if (!(lengths[r] > 0))
      return Error{ErrorKind::invalid_input, "the length in region " +
                                                 std::to_string(r + domain.pslg().first_id.value) +
                                                 " must be positive, not " + shortest(lengths[r])};
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Result<RegionSizes> {
    constexpr std::uint64_t usual = 8, at_least = 1000;
    Options bounded;
    bounded.threads = options.threads;
    bounded.max_vertices = usual * domain.pslg().points.size() + at_least;
    const Goal no_thin_triangles;
    const Result<Meshed> meshed =
        mesh_valid(domain.pslg(), domain.convex_hull(), &no_thin_triangles, bounded, progress);
    if (!meshed) return meshed.error();
    return sizes_of_faces(domain.pslg(), domain.convex_hull(), lengths, meshed->mesh, progress.threads());
  });
}

Result<std::function<double(Point)>> allowed_size(const ValidPslg& domain, const Goal& goal, const Options& options) {
  using Size = Result<std::function<double(Point)>>;
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (!is_graded(goal)) return goal.size;
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Size {
    return graded_size(goal, domain.pslg(), progress.threads());
  });
}

}  // namespace pardel
