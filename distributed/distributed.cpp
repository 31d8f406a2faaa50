#include "distributed.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "../core/support/collective.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/mesher.hpp"
#include "../parallel/planning/supervised.hpp"
#include "../parallel/threads/parallel_for.hpp"
#include "delaunay/piece_of_points.hpp"
#include "delaunay/problems_of_points.hpp"
#include "delaunay/triangulated_points.hpp"
#include "divided_input/mesh_of_points.hpp"
#include "meshing/check_distributable.hpp"
#include "meshing/mesh_in_ranks.hpp"

namespace pardel {

using namespace engine;

Status mesh_in_pieces(const ValidPslg& domain, const Goal& goal, const Options& options, Ranks& ranks, int pieces,
                      const std::function<Status(MeshPiece&& piece, int number)>& visit) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range;
  if (Status fits = check_distributable(options); !fits) return fits;
  if (pieces < ranks.count())
    return Error{ErrorKind::usage, "there must be at least as many pieces as ranks, " + std::to_string(ranks.count()) +
                                       ", not " + std::to_string(pieces)};
  return supervised(options_for(goal, options), [&](const Options& safe, ProgressMonitor& progress) {
    return mesh_in_ranks(domain.pslg(), domain.convex_hull() || goal.convex_hull, goal, safe, progress, ranks, pieces,
                         visit);
  });
}

Result<MeshPiece> mesh(const ValidPslg& domain, const Goal& goal, const Options& options, Ranks& ranks) {
  MeshPiece piece;
  const Status made = mesh_in_pieces(domain, goal, options, ranks, ranks.count(), [&](MeshPiece&& only, int) {
    piece = std::move(only);
    return Status(Done{});
  });
  if (!made) return made.error();
  return piece;
}

Result<MeshPiece> triangulate(PartOfPoints&& points, const Options& options, Ranks& ranks) {
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Result<MeshPiece> {
    Stopwatch watch;
    const FirstId first_id = points.first_id;
    if (Status usable = status_of(unusable_values(points, ranks, progress.threads()), first_id); !usable)
      return usable.error();
    const Result<std::unique_ptr<TriangulatedPoints>> made = triangulated(std::move(points), ranks, progress.threads());
    if (!made) return made.error();
    const double triangulate_seconds = watch.lap();
    MeshPiece piece = make_piece_of_points((*made)->delaunay, (*made)->own, ranks, progress.threads());
    piece.mesh.first_id = first_id;
    piece.report.triangulate_seconds = triangulate_seconds;
    piece.seconds = watch.lap();
    return piece;
  });
}

std::vector<Problem> find_problems(PartOfPoints&& points, int threads, Ranks& ranks) {
  return problems_of_points(std::move(points), ranks, Threads(thread_count(threads)));
}

bool can_divide_points(const Goal& goal, const Options& options) {
  const bool same_everywhere =
      !goal.size && !goal.user_test && goal.sources.empty() && goal.grading == INFINITY && goal.feature_edges == 0;
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
    return mesh_of_points(std::move(input), goal, safe, progress, ranks);
  });
}

Digest digest(const MeshPiece& piece, Ranks& ranks) { return sum_of(digest(piece.mesh), ranks); }

}  // namespace pardel
