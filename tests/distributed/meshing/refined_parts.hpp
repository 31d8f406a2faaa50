// Refines on several ranks, with a Communicator that a test has chosen.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "../../../distributed/delaunay/triangulated_points.hpp"
#include "../../../distributed/divided_input/part_of_domain.hpp"
#include "../../parallel/scheduling/many_tasks.hpp"
#include "../delaunay/part_of_rank.hpp"

namespace pardel::engine::samples {

/// Refines the domain of a rank to the goal of the case.
inline Result<RefineCounts> refine(DomainTriangulation& domain, const Case& c, const Options& options,
                                   Communicator& communicator) {
  std::vector<double> caps;
  for (const Region& region : c.pslg.regions) caps.push_back(region.max_area);
  const Criteria criteria(c.goal, options.placement, caps);
  ProgressMonitor progress(options);
  return refine_by_sweeps(domain.triangulation, domain.segments, criteria, options, progress, {}, {}, communicator);
}

/// Calls use(part, division) with the part of the domain with which this rank begins, and with the division of the
/// points. Collective.
template <class Use>
void with_part_of_domain(const Case& c, Ranks& ranks, const Use& use) {
  const PartOfSegments segments = part_of_segments(c.pslg, ranks);
  const Pslg rest = domains::rest_of(c.pslg);
  Result<std::unique_ptr<TriangulatedPoints>> points = triangulated(part_of(c.pslg, ranks), ranks, Threads(1));
  ASSERT_TRUE(points) << points.error().message;
  Result<PartOfDomain> part = part_of_domain(**points, {segments, rest}, c.goal.convex_hull, ranks, Threads(1));
  ASSERT_TRUE(part) << part.error().message;
  use(*part, (*points)->division);
}

}  // namespace pardel::engine::samples
