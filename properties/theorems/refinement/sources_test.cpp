// Lengths at points, on segments and in regions, from which lengths grow.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../../../parallel/sizes.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

double distance(const SizeSource& source, Point p) {
  const double x = source.b.x - source.a.x, y = source.b.y - source.a.y, squared = x * x + y * y;
  const double along = (p.x - source.a.x) * x + (p.y - source.a.y) * y;
  const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
  return distance(p, {source.a.x + share * x, source.a.y + share * y});
}

double some_length(double extent) { return extent * std::ldexp(1.0, -*rc::gen::inRange(3, 7)); }

/// Lengths at up to two input points and on up to two segments.
std::vector<SizeSource> some_sources(const Pslg& pslg, double extent) {
  std::vector<SizeSource> sources;
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    const Point p = pslg.points[*rc::gen::inRange<std::size_t>(0, pslg.points.size())];
    const double length = some_length(extent);
    sources.push_back({p, p, length, length});
  }
  for (int i = pslg.segments.empty() ? 0 : *rc::gen::inRange(0, 3); i > 0; --i) {
    const Segment& s = pslg.segments[*rc::gen::inRange<std::size_t>(0, pslg.segments.size())];
    const double length = some_length(extent);
    sources.push_back({pslg.points[s.a], pslg.points[s.b], length, length});
  }
  return sources;
}

/// A length in about every second region; infinity in the others.
std::vector<double> some_lengths_in_regions(const Pslg& pslg, double extent) {
  std::vector<double> lengths;
  for (std::size_t r = 0; r < pslg.regions.size(); ++r)
    lengths.push_back(*rc::gen::inRange(0, 2) == 0 ? infinity : some_length(extent));
  return lengths;
}

PARDEL_PROPERTY(Sources, bound_each_edge_by_the_least_length_that_grows_from_them,
                {.statement = "Give lengths at points, on segments and in regions. At the centroid of a triangle with "
                              "the longest edge e, each length at a source plus the limit on growth times the distance "
                              "from it is at least e; in a region with a length, e is at most this length. The mesh is "
                              "certified. Two threads make the same mesh.",
                 .source = "docs/sizes.md",
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  const double extent = extent_of(problem.pslg), growth = 0.125 * *rc::gen::inRange(2, 9);
  problem.goal = {.min_angle_deg = 20, .grading = growth, .convex_hull = problem.goal.convex_hull};
  const std::vector<SizeSource> given = some_sources(problem.pslg, extent);
  const std::vector<double> lengths = some_lengths_in_regions(problem.pslg, extent);
  const auto domain = validate(problem.pslg, {.convex_hull = problem.goal.convex_hull});
  if (!domain) RC_FAIL(domain.error().front().message());
  Result<RegionSizes> in_regions = region_sizes(*domain, lengths);
  if (!in_regions) RC_FAIL(in_regions.error().message);
  problem.goal.size = in_regions->size;
  problem.goal.sources = given;
  for (const SizeSource& border : in_regions->borders) problem.goal.sources.push_back(border);

  Options options = some_options();
  const Meshed result = meshed(problem, exhibit, options);
  require_valid(check(problem.pslg, result.mesh, problem.goal));
  bool has_length = false;
  for (std::size_t t = 0; t < result.mesh.triangles.size(); ++t) {
    const auto& v = result.mesh.triangles[t].v;
    const Point a = result.mesh.points[v[0]], b = result.mesh.points[v[1]], c = result.mesh.points[v[2]];
    const Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    double allowed = infinity;
    for (const SizeSource& source : given)
      allowed = std::min(allowed, source.at_a + growth * distance(source, centroid));
    const Index region = result.mesh.region.empty() ? no_index : result.mesh.region[t];
    if (region != no_index) allowed = std::min(allowed, lengths[region]);
    has_length = has_length || (region != no_index && lengths[region] < infinity);
    RC_ASSERT(std::max({distance(a, b), distance(b, c), distance(c, a)}) <= allowed * (1 + rounding));
  }
  classify(!given.empty(), "points or segments have lengths", 50);
  classify(has_length, "a region has a length", 5);
  options.threads = 2;
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == result.mesh);
}

PARDEL_PROPERTY(Sources, at_the_borders_of_regions_let_lengths_grow_outside,
                {.statement = "The lengths in regions, with their borders as sources: no triangle outside has an edge "
                              "longer than the length in a region plus the limit on growth times the distance of its "
                              "centroid from each segment on the border of the region.",
                 .source = "docs/sizes.md",
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  RC_PRE(!problem.pslg.regions.empty());
  const double growth = 0.25;
  problem.goal = {.min_angle_deg = 20, .grading = growth, .convex_hull = problem.goal.convex_hull};
  const double length = extent_of(problem.pslg) * std::ldexp(1.0, -*rc::gen::inRange(2, 5));
  std::vector<double> lengths(problem.pslg.regions.size(), infinity);
  lengths[*rc::gen::inRange<std::size_t>(0, lengths.size())] = length;
  const auto domain = validate(problem.pslg, {.convex_hull = problem.goal.convex_hull});
  if (!domain) RC_FAIL(domain.error().front().message());
  Result<RegionSizes> in_regions = region_sizes(*domain, lengths);
  if (!in_regions) RC_FAIL(in_regions.error().message);
  problem.goal.size = in_regions->size;
  problem.goal.sources = in_regions->borders;
  const Mesh mesh = meshed(problem, exhibit, some_options()).mesh;

  // The border, found in the mesh: sides of triangles with the length, where it ends.
  const auto has_length = [&](Index t) {
    return t != no_index && mesh.region[t] != no_index && lengths[mesh.region[t]] < infinity;
  };
  std::vector<SizeSource> border;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (unsigned i = 0; i < 3; ++i)
      if (has_length(t) && !has_length(mesh.triangles[t].n[i])) {
        const auto& v = mesh.triangles[t].v;
        border.push_back({mesh.points[v[(i + 1) % 3]], mesh.points[v[(i + 2) % 3]], length, length});
      }
  for (const Triangle& t : mesh.triangles) {
    const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
    const Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    for (const SizeSource& side : border)
      RC_ASSERT(std::max({distance(a, b), distance(b, c), distance(c, a)}) <=
                (length + growth * distance(side, centroid)) * (1 + rounding));
  }
  classify(!border.empty(), "the region has triangles", 80);
}

}  // namespace
}  // namespace pardel::properties
