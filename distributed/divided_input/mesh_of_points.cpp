#include "mesh_of_points.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../core/support/stopwatch.hpp"
#include "../../parallel/planning/run_plan.hpp"
#include "../cdt/problems_of_domain.hpp"
#include "../delaunay/problems_of_points.hpp"
#include "../delaunay/triangulated_points.hpp"
#include "../meshing/refine_in_ranks.hpp"
#include "divided_background.hpp"
#include "divided_points.hpp"
#include "kept_by_readers.hpp"
#include "part_of_domain.hpp"

namespace pardel::engine {
namespace {

/// Takes the attributes, and copies what their interpolation needs of the rest. Nothing if there are no attributes.
std::optional<KeptDomain> kept_for_attributes(PartOfPslg& input, Ranks& ranks) {
  const std::size_t k = std::exchange(input.points.attributes_per_point, 0);
  if (k == 0) return {};
  const std::vector<Point>& points = input.points.points;
  const std::vector<Segment>& segments = input.segments.segments;
  return KeptDomain{{std::exchange(input.points.point_attributes, {}), k, points.size(), ranks},
                    {points, 1, points.size(), ranks},
                    {segments, 1, segments.size(), ranks}};
}

}  // namespace

Result<MeshPiece> mesh_of_points(PartOfPslg&& input, const Goal& goal, const Options& options,
                                 ProgressMonitor& progress, Ranks& ranks) {
  Stopwatch watch;
  input.rest.first_id = input.points.first_id;
  const auto problems_of_all = [&](const std::vector<NumberedPoint>& points) {
    return status_of_whole(points, input.segments, input.rest, goal.convex_hull, ranks, progress.threads());
  };
  if (Status fine = status_of(unusable_values(input.points, ranks, progress.threads()), input.rest.first_id); !fine) {
    if (Status all = problems_of_all(numbered(input.points)); !all) return all.error();
    return fine.error();
  }
  const std::optional<KeptDomain> kept = kept_for_attributes(input, ranks);
  Result<std::unique_ptr<TriangulatedPoints>> made =
      triangulated(std::move(input.points), ranks, progress.threads(),
                   [&](const OwnPoints& own) { return problems_of_all(numbered(own.at.span(), own)); });
  if (!made) return made.error();
  Result<PartOfDomain> part_made =
      part_of_domain(**made, {input.segments, input.rest}, goal.convex_hull, ranks, progress.threads());
  if (!part_made) return part_made.error();
  input.segments = {};
  PartOfDomain& part = *part_made;
  const CurveDivision division = (*made)->division;
  made->reset();
  std::optional<DividedBackground> background;
  if (kept) background.emplace(part, division, ranks, progress.threads());
  DividedPoints distribution(ranks, part, division);
  Report report;
  report.triangulate_seconds = watch.lap();
  InputData data;
  std::vector<double> caps;
  for (const Region& region : input.rest.regions) {
    data.region_attributes.push_back(region.attribute);
    caps.push_back(region.max_area);
  }
  const Criteria criteria(goal, placement_for(goal, options, false), std::move(caps));
  Result<MeshPiece> piece = refine_in_ranks(part.domain, distribution, criteria, options, progress, std::move(data),
                                            std::move(report), watch);
  if (piece && background) {
    std::move(*background).add_attributes(*piece, *kept, ranks);
    piece->seconds += watch.lap();
  }
  return piece;
}

}  // namespace pardel::engine
