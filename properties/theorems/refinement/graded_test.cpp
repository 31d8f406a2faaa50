// Meshes of every family of domains for random fields of sizes, made by the engine on tiles of every kind. `exhibit` is
// a parameter that the macro declares (framework/property.hpp).
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "../../../core/raster.hpp"
#include "../../../parallel/sizes.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

constexpr const char* families = "lattice domains of every family, random goals and fields of sizes";

/// Lengths that grow linearly with the distance from the nearest of up to three input points.
std::function<double(Point)> some_cones(const Pslg& pslg) {
  struct Cone {
    Point tip;
    double least, slope;
  };
  std::vector<Cone> cones;
  const int count = *rc::gen::inRange(1, 4);
  for (int i = 0; i < count; ++i)
    cones.push_back({pslg.points[*rc::gen::inRange<std::size_t>(0, pslg.points.size())],
                     extent_of(pslg) * std::ldexp(1.0, -*rc::gen::inRange(3, 12)), 0.125 * *rc::gen::inRange(2, 6)});
  return [cones](Point p) {
    double size = INFINITY;
    for (const auto& [tip, least, slope] : cones)
      size = std::min(size, least + slope * std::hypot(p.x - tip.x, p.y - tip.y));
    return size;
  };
}

/// Lengths at the input points, interpolated.
std::function<double(Point)> some_lengths_at_points(const Pslg& pslg) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    lengths.push_back(extent_of(pslg) * std::ldexp(1.0, -*rc::gen::inRange(2, 6)));
  const auto size = interpolated_size(pslg, lengths);
  if (!size) RC_FAIL(size.error().message);
  return *size;
}

/// A raster that covers the domain, with random lengths.
std::function<double(Point)> some_raster(const Pslg& pslg) {
  const double extent = extent_of(pslg);
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(pslg.points, {}, &Point::y);
  Raster raster{4, 4, {left.x, low.y}, extent / 3, extent / 3, {}};
  for (int k = 0; k < 16; ++k) raster.values.push_back(extent * std::ldexp(1.0, -*rc::gen::inRange(2, 6)));
  const auto size = interpolated_size(std::move(raster));
  if (!size) RC_FAIL(size.error().message);
  return *size;
}

std::function<double(Point)> some_field(const Pslg& pslg) {
  const int kind = *rc::gen::inRange(0, 3);
  classify(kind == 0, "lengths that grow from points", 10);
  classify(kind == 1, "lengths at the input points", 10);
  return kind == 0 ? some_cones(pslg) : kind == 1 ? some_lengths_at_points(pslg) : some_raster(pslg);
}

PARDEL_PROPERTY(Refinement, for_any_field_of_sizes_gives_one_certified_mesh_on_any_number_of_threads,
                {.statement = "For every domain and field of sizes, and on tiles of every kind, the mesh is certified: "
                              "also its edges are not longer than the sizes at the centroids. One and three threads "
                              "give the same mesh.",
                 .source = "properties/THEORY.md, refinement",
                 .families = families}) {
  Problem problem = some_problem(exhibit);
  problem.goal.size = some_field(problem.pslg);
  Options options = some_options();
  if (*rc::gen::arbitrary<bool>())
    options.decomposition = *rc::gen::element(Decomposition::quadtree, Decomposition::paper_quadtree);
  const Meshed result = meshed(problem, exhibit, options);
  classify(result.report.tiling.leaves.size() > 16, "more than 16 leaves", 5);
  require_valid(check(problem.pslg, result.mesh, problem.goal));
  options.threads = 3;
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == result.mesh);
}

}  // namespace
}  // namespace pardel::properties
