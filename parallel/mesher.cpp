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

Status check_valid(const Pslg& pslg, bool convex_hull, int threads) {
  const std::vector<Problem> problems = find_problems(pslg, {.convex_hull = convex_hull, .threads = threads});
  if (problems.empty()) return Done{};
  return Error{ErrorKind::invalid_input, messages(problems, pslg.first_id.value)};
}

/// The shortest edge for which double precision suffices: coordinates near 2^k are 2^(k-53) apart. The direction of an
/// edge 2^11 times as long has three correct digits.
double least_min_edge(std::span<const Point> points) {
  double largest = 0;
  for (const Point p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest * 0x1p-42;
}

/// The data of the input that the result contains, too.
struct InputData {
  std::vector<double> region_attributes;
  PointData points;
  std::vector<std::array<Index, 3>> background;  ///< the triangles on which point attributes are interpolated
};

Mesh to_mesh(DomainTriangulation&& domain, InputData input, int threads) {
  return export_mesh(std::move(domain), std::move(input.region_attributes), input.points, std::move(input.background),
                     threads);
}

/// A watcher that converts each snapshot to a mesh and calls options.after_sweep with it.
Watcher watcher(const DomainTriangulation& domain, const InputData& input, const Options& options) {
  if (!options.after_sweep) return {};
  return [&](Triangulation&& snapshot, const Sweep& sweep) {
    DomainTriangulation copy{std::move(snapshot), domain.segments, domain.input_of_vertex, domain.input_segment,
                             domain.segment_marker};
    return options.after_sweep(to_mesh(std::move(copy), input, options.threads), sweep);
  };
}

Status refine_domain(DomainTriangulation& domain, const Criteria& criteria, const InputData& input, Options options,
                     Report& report) {
  Triangulation& t = domain.triangulation;
  options.min_edge = std::max(options.min_edge, least_min_edge(t.points.span()));
  Result<RefineCounts> counts =
      refine_by_sweeps(t, domain.segments, criteria, options, {}, watcher(domain, input, options));
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

/// Makes the mesh of a valid Pslg, or only its constrained Delaunay triangulation if `goal` is null.
Result<Meshed> mesh_valid(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options) {
  Stopwatch watch;
  Meshed result;
  Result<DomainTriangulation> domain = triangulate_domain(pslg, convex_hull, options.threads);
  if (!domain) return domain.error();
  InputData input{{}, {pslg.attributes_per_point, pslg.point_attributes, pslg.point_markers}, {}};
  if (pslg.attributes_per_point > 0) input.background = input_corners(*domain);
  result.report.triangulate_seconds = watch.lap();

  std::vector<double> caps;
  for (const Region& region : pslg.regions) {
    input.region_attributes.push_back(region.attribute);
    caps.push_back(region.max_area);
  }
  if (goal != nullptr) {
    const Criteria criteria(*goal, options.placement, std::move(caps));
    if (Status refined = refine_domain(*domain, criteria, input, options, result.report); !refined)
      return refined.error();
  }
  result.mesh = to_mesh(std::move(domain).value(), std::move(input), options.threads);
  result.report.refine_seconds = watch.lap();
  return result;
}

Result<Meshed> validate_and_mesh(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options) {
  Stopwatch watch;
  if (Status valid = check_valid(pslg, convex_hull, options.threads); !valid) return valid.error();
  const double seconds = watch.lap();
  Result<Meshed> result = mesh_valid(pslg, convex_hull, goal, options);
  if (result) result->report.validate_seconds = seconds;
  return result;
}

Status check_sizes(const Pslg& pslg, std::span<const double> sizes) {
  if (sizes.size() != pslg.points.size())
    return Error{ErrorKind::invalid_input,
                 std::to_string(sizes.size()) + " sizes for " + std::to_string(pslg.points.size()) + " points"};
  for (std::size_t v = 0; v < sizes.size(); ++v)
    if (!(sizes[v] > 0 && sizes[v] < INFINITY))
      return Error{ErrorKind::invalid_input, "the size at point " + std::to_string(v + pslg.first_id.value) +
                                                 " must be positive, not " + shortest(sizes[v])};
  return Done{};
}

/// Precondition: the Pslg is valid and check_sizes() accepts the sizes.
Result<std::function<double(Point)>> interpolate_sizes(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull) {
  const Result<Meshed> meshed = mesh_valid(pslg, convex_hull, nullptr, {});
  if (!meshed) return meshed.error();
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : meshed->mesh.triangles) triangles.push_back(triangle.v);
  auto background = std::make_shared<Background>(pslg.points, std::move(triangles));
  return std::function<double(Point)>([background, values = std::vector<double>(sizes.begin(), sizes.end())](Point p) {
    return background->interpolate(p, values);
  });
}

Error out_of_memory() { return {ErrorKind::resources, "out of memory"}; }

}  // namespace

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

Result<Meshed> mesh(const ValidPslg& domain, const Goal& goal, const Options& options) try {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  return mesh_valid(domain.pslg(), domain.convex_hull() || goal.convex_hull, &goal, options);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<Meshed> mesh(const Pslg& pslg, const Goal& goal, const Options& options) try {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  return validate_and_mesh(pslg, goal.convex_hull, &goal, options);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<Meshed> triangulate(const ValidPslg& domain, const Options& options) try {
  return mesh_valid(domain.pslg(), domain.convex_hull(), nullptr, options);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull, const Options& options) try {
  return validate_and_mesh(pslg, convex_hull, nullptr, options);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal,
                      const Options& options) try {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
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
  InputData input{coarse.region_attributes,
                  {coarse.attributes_per_point, coarse.point_attributes.span(), coarse.point_markers.span()},
                  {}};
  if (!max_areas.empty() || coarse.attributes_per_point > 0)
    for (const Triangle& triangle : coarse.triangles) input.background.push_back(triangle.v);
  std::function<double(Point)> area_cap;
  if (!max_areas.empty()) {
    const auto background = std::make_shared<Background>(coarse.points.span(), input.background);
    area_cap = [background, max_areas](Point p) { return max_areas[background->locate(p).triangle]; };
  }
  result.report.triangulate_seconds = watch.lap();

  const Criteria criteria(goal, options.placement, {}, area_cap);
  if (Status refined = refine_domain(*domain, criteria, input, options, result.report); !refined)
    return refined.error();
  result.mesh = to_mesh(std::move(domain).value(), std::move(input), options.threads);
  result.report.refine_seconds = watch.lap();
  return result;
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<std::function<double(Point)>> interpolated_size(const ValidPslg& domain, std::span<const double> sizes) try {
  if (Status fit = check_sizes(domain.pslg(), sizes); !fit) return fit.error();
  return interpolate_sizes(domain.pslg(), sizes, domain.convex_hull());
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                       bool convex_hull) try {
  if (Status fit = check_sizes(pslg, sizes); !fit) return fit.error();
  if (Status valid = check_valid(pslg, convex_hull, 1); !valid) return valid.error();
  return interpolate_sizes(pslg, sizes, convex_hull);
} catch (const std::bad_alloc&) {
  return out_of_memory();
}

}  // namespace pardel
