#include "region_sizes.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "../construction/domain_triangulation.hpp"
#include "../sizing/local_bound.hpp"

namespace pardel::engine {
namespace {

/// The sides of triangles in a region with a length, where another region or the outside begins.
std::vector<SizeSource> borders(const Triangulation& t, std::span<const double> lengths) {
  std::vector<SizeSource> sources;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    const Index region = t.region[id];
    if (region == no_index || lengths[region] == INFINITY) continue;
    for (unsigned side = 0; side < 3; ++side)
      if (slot.n[side].none() || t.region[slot.n[side].triangle()] != region)
        sources.push_back({t.points[slot.from(side)], t.points[slot.to(side)], lengths[region], lengths[region]});
  }
  return sources;
}

}  // namespace

Result<RegionSizes> sizes_of_faces(const Pslg& pslg, bool convex_hull, std::span<const double> lengths,
                                   const Mesh& mesh, const Threads& threads) {
  const Result<DomainTriangulation> domain = triangulate_domain(pslg, convex_hull, threads);
  if (!domain) return domain.error();
  if (mesh.region.empty()) return RegionSizes{};
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& triangle : mesh.triangles) triangles.push_back(triangle.v);
  TriangleValues field{std::make_shared<Background>(mesh.points.span(), std::move(triangles), threads), {}};
  for (const Index region : mesh.region) field.values.push_back(region == no_index ? INFINITY : lengths[region]);
  return RegionSizes{OnBackground<TriangleValues>{std::make_shared<const TriangleValues>(std::move(field))},
                     borders(domain->triangulation, lengths)};
}

}  // namespace pardel::engine
