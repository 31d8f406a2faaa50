#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../core/support/stopwatch.hpp"
#include "../../parallel/mesher.hpp"
#include "../../parallel/planning/run_plan.hpp"
#include "../../parallel/planning/supervised.hpp"
#include "../cdt/problems_of_domain.hpp"
#include "../delaunay/problems_of_points.hpp"
#include "../delaunay/triangulated_points.hpp"
#include "../distributed.hpp"
#include "../meshing/refine_in_ranks.hpp"
#include "divided_background.hpp"
#include "divided_points.hpp"
#include "kept_by_readers.hpp"
#include "part_of_domain.hpp"

namespace pardel {

using namespace engine;

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

Result<MeshPiece> mesh_of(PartOfPslg&& input, const Goal& goal, const Options& options, ProgressMonitor& progress,
                          Ranks& ranks) {
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

}  // namespace

bool can_divide_points(const Goal& goal, const Options& options) {
  const bool same_everywhere =
      !goal.size && goal.sources.empty() && goal.grading == INFINITY && goal.feature_edges == 0;
  const bool on_lattice = options.decomposition == Decomposition::automatic ||
                          options.decomposition == Decomposition::lattice ||
                          options.decomposition == Decomposition::none;
  return same_everywhere && on_lattice && options.interior == Interior::refine && options.max_vertices == 0 &&
         !options.after_sweep && !options.before_refinement;
}

Result<MeshPiece> mesh(PartOfPslg&& input, const Goal& goal, const Options& options, Ranks& ranks) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (!can_divide_points(goal, options))
    return Error{ErrorKind::usage,
                 "points that are divided among ranks need bounds without a field of sizes, a lattice, and an interior "
                 "that is refined"};
  if (!input.rest.points.empty() || !input.rest.segments.empty())
    return Error{ErrorKind::usage, "the part of a domain that all ranks have must have no points and no segments"};
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return mesh_of(std::move(input), goal, safe, progress, ranks);
  });
}

}  // namespace pardel
