#include "mesher.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "../core/support/shortest.hpp"
#include "../core/support/stopwatch.hpp"
#include "conversion/background.hpp"
#include "conversion/domain_triangulation.hpp"
#include "conversion/export_mesh.hpp"
#include "conversion/import_mesh.hpp"
#include "refinement/criteria.hpp"
#include "refinement/exemptions.hpp"
#include "scheduling/refine_by_sweeps.hpp"
#include "validate.hpp"

namespace pardel {

using namespace engine;

namespace {

constexpr double largest_min_angle_deg = 33;

Status check_goal(const Goal& goal, const Options& options) {
  const auto refuse = [](const std::string& what, double value) {
    return Error{ErrorKind::usage, what + ", not " + shortest(value)};
  };
  if (!(goal.min_angle_deg >= 0 && goal.min_angle_deg <= largest_min_angle_deg))
    return refuse("the minimum angle must lie between 0 and 33 degrees", goal.min_angle_deg);
  if (!(goal.max_area > 0)) return refuse("the largest area must be positive", goal.max_area);
  if (!(goal.max_edge > 0)) return refuse("the longest edge must be positive", goal.max_edge);
  if (!(options.min_edge >= 0 && options.min_edge < INFINITY))
    return refuse("the shortest edge must be zero or positive", options.min_edge);
  if (options.triangles_per_tile == 0) return refuse("the triangles of a tile must be positive", 0);
  return Done{};
}

Status check_pslg(const Pslg& pslg, bool convex_hull, int threads) {
  const std::vector<Problem> problems = validate(pslg, {.convex_hull = convex_hull, .threads = threads});
  if (problems.empty()) return Done{};
  std::string message;
  for (const Problem& problem : problems) message += (message.empty() ? "" : "\n") + problem.message();
  return Error{ErrorKind::invalid_input, message};
}

/// Coordinates near 2^k are 2^(k-53) apart. An edge 2^11 times as long as that still has an angle with 3 digits.
double least_min_edge(std::span<const Point> points) {
  double largest = 0;
  for (const Point p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest * 0x1p-42;
}

/// What the result has from its input.
struct Heritage {
  std::vector<double> region_attributes;
  PointData points;
  std::vector<std::array<Index, 3>> background;
};

Mesh to_mesh(DomainTriangulation&& domain, Heritage heritage, int threads) {
  return export_mesh(std::move(domain), std::move(heritage.region_attributes), heritage.points,
                     std::move(heritage.background), threads);
}

/// Shows each snapshot, made a mesh, to options.after_sweep.
Watcher watcher(const DomainTriangulation& domain, const Heritage& heritage, const Options& options) {
  if (!options.after_sweep) return {};
  return [&](Triangulation&& snapshot, const Sweep& sweep) {
    DomainTriangulation copy{std::move(snapshot), domain.segments, domain.input_of_vertex, domain.input_segment,
                             domain.segment_marker};
    return options.after_sweep(to_mesh(std::move(copy), heritage, options.threads), sweep);
  };
}

Status refine_domain(DomainTriangulation& domain, const Criteria& criteria, const Heritage& heritage, Options options,
                     Report& report) {
  Triangulation& t = domain.triangulation;
  options.min_edge = std::max(options.min_edge, least_min_edge(t.points.span()));
  Result<RefineCounts> counts =
      refine_by_sweeps(t, domain.segments, criteria, options, {}, watcher(domain, heritage, options));
  if (!counts) return counts.error();
  report.inserted = counts->inserted;
  report.segment_splits = counts->segment_splits;
  report.refused = counts->refused;
  report.tiling = std::move(counts->tiling);
  if (counts->left_alone) report.exempt = exemptions(t, domain.segments, criteria, options, counts->budget_reached);
  for (Exemption& e : report.exempt)
    if (e.apex < domain.input_of_vertex.size()) e.apex = domain.input_of_vertex[e.apex];
  return Done{};
}

Result<Meshed> mesh_pslg(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options) {
  Stopwatch watch;
  Meshed result;
  if (Status valid = check_pslg(pslg, convex_hull, options.threads); !valid) return valid.error();
  result.report.validate_seconds = watch.lap();

  Result<DomainTriangulation> domain = triangulate_domain(pslg, convex_hull, options.threads);
  if (!domain) return domain.error();
  Heritage heritage{{}, {pslg.attributes_per_point, pslg.point_attributes, pslg.point_markers}, {}};
  if (pslg.attributes_per_point > 0) heritage.background = input_corners(*domain);
  result.report.triangulate_seconds = watch.lap();

  std::vector<double> caps;
  for (const Region& region : pslg.regions) {
    heritage.region_attributes.push_back(region.attribute);
    caps.push_back(region.max_area);
  }
  if (goal != nullptr) {
    const Criteria criteria(*goal, options.placement, std::move(caps));
    if (Status refined = refine_domain(*domain, criteria, heritage, options, result.report); !refined)
      return refined.error();
  }
  result.mesh = to_mesh(std::move(domain).value(), std::move(heritage), options.threads);
  result.report.refine_seconds = watch.lap();
  return result;
}

Error out_of_memory() { return {ErrorKind::resources, "out of memory"}; }

}  // namespace

Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull, const Options& options) try {
  return mesh_pslg(pslg, convex_hull, nullptr, options);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<Meshed> mesh(const Pslg& pslg, const Goal& goal, const Options& options) try {
  if (Status sensible = check_goal(goal, options); !sensible) return sensible.error();
  return mesh_pslg(pslg, goal.convex_hull, &goal, options);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal,
                      const Options& options) try {
  if (Status sensible = check_goal(goal, options); !sensible) return sensible.error();
  if (!max_areas.empty() && max_areas.size() != coarse.triangles.size())
    return Error{ErrorKind::invalid_input, std::to_string(max_areas.size()) + " area caps for a mesh of " +
                                               std::to_string(coarse.triangles.size()) + " triangles"};
  for (std::size_t i = 0; i < max_areas.size(); ++i)
    if (!(max_areas[i] > 0))
      return Error{ErrorKind::invalid_input, "the area cap of triangle " + std::to_string(i) +
                                                 " must be positive, not " + shortest(max_areas[i])};
  Stopwatch watch;
  Meshed result;
  Result<DomainTriangulation> domain = import_mesh(coarse);
  if (!domain) return domain.error();
  Heritage heritage{coarse.region_attributes,
                    {coarse.attributes_per_point, coarse.point_attributes.span(), coarse.point_markers.span()},
                    {}};
  if (!max_areas.empty() || coarse.attributes_per_point > 0)
    for (const Triangle& triangle : coarse.triangles) heritage.background.push_back(triangle.v);
  std::function<double(Point)> area_cap;
  if (!max_areas.empty()) {
    const auto on = std::make_shared<Background>(coarse.points.span(), heritage.background);
    area_cap = [on, max_areas](Point p) { return max_areas[on->locate(p).triangle]; };
  }
  result.report.triangulate_seconds = watch.lap();

  const Criteria criteria(goal, options.placement, {}, area_cap);
  if (Status refined = refine_domain(*domain, criteria, heritage, options, result.report); !refined)
    return refined.error();
  result.mesh = to_mesh(std::move(domain).value(), std::move(heritage), options.threads);
  result.report.refine_seconds = watch.lap();
  return result;
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull) {
  if (sizes.size() != pslg.points.size())
    return Error{ErrorKind::invalid_input,
                 std::to_string(sizes.size()) + " sizes for " + std::to_string(pslg.points.size()) + " points"};
  for (std::size_t v = 0; v < sizes.size(); ++v)
    if (!(sizes[v] > 0 && sizes[v] < INFINITY))
      return Error{ErrorKind::invalid_input,
                   "the size at point " + std::to_string(v) + " must be positive, not " + shortest(sizes[v])};
  Result<Meshed> meshed = triangulate(pslg, convex_hull);
  if (!meshed) return meshed.error();
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : meshed->mesh.triangles) triangles.push_back(triangle.v);
  auto on = std::make_shared<Background>(pslg.points, std::move(triangles));
  return std::function<double(Point)>(
      [on, values = std::vector<double>(sizes.begin(), sizes.end())](Point p) { return on->interpolate(p, values); });
}

}  // namespace pardel
