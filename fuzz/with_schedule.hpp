// The refinement with a given schedule: which task of a phase works when.
#pragma once

#include <utility>
#include <vector>

#include "../parallel/construction/domain_triangulation.hpp"
#include "../parallel/conversion/export_mesh.hpp"
#include "../parallel/scheduling/refine_by_sweeps.hpp"

namespace pardel::fuzz {

struct RefinedMesh {
  Mesh mesh;
  engine::RefineCounts counts;
};

/// What mesh() does after validation with Interior::refine, for goals without sources of sizes, gradation and feature
/// sizes.
inline Result<RefinedMesh> refine_with_schedule(const Pslg& pslg, const Goal& goal, const Options& options,
                                                const engine::Schedule& schedule) {
  using namespace engine;
  Result<DomainTriangulation> domain = triangulate_domain(pslg, goal.convex_hull, options.threads);
  if (!domain) return domain.error();
  std::vector<double> attributes, caps;
  for (const Region& region : pslg.regions) {
    attributes.push_back(region.attribute);
    caps.push_back(region.max_area);
  }
  const Criteria criteria(goal, options.placement, caps);
  ProgressMonitor progress(options);
  auto counts = refine_by_sweeps(domain->triangulation, domain->segments, criteria, options, progress, schedule);
  if (!counts) return counts.error();
  const PointData points{pslg.points, 0, {}, {}};
  return RefinedMesh{export_mesh(std::move(domain).value(), attributes, points, {}, options.threads),
                     std::move(counts).value()};
}

}  // namespace pardel::fuzz
