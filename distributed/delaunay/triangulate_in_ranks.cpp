#include <utility>

#include "../../core/support/agree.hpp"
#include "../../core/support/collective.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../../parallel/planning/supervised.hpp"
#include "../distributed.hpp"
#include "piece_of_points.hpp"
#include "problems_of_points.hpp"
#include "resolve_halo.hpp"
#include "triangulated_points.hpp"

namespace pardel {

using namespace engine;

Result<std::unique_ptr<TriangulatedPoints>> engine::triangulated(PartOfPoints&& read, Ranks& ranks,
                                                                 const Threads& threads, const JudgeOfPoints& judge) {
  const FirstId first_id = read.first_id;
  CurveDivision division = divide_along_curve(read.points, ranks);
  OwnPoints own = send_to_owners(std::move(read), division, ranks, threads);
  const std::uint64_t first = own.first[ranks.rank()];
  const std::vector<Site> common = common_sites(own.at.span(), first, own.first.back(), ranks);
  Array<Point> at = std::exchange(own.at, {});
  // Not std::make_unique: the triangulation is made in its place, because it cannot be moved.
  std::unique_ptr<TriangulatedPoints> result(
      new TriangulatedPoints{std::move(division), std::move(own), {std::move(at), first}});
  LocalDelaunay& delaunay = result->delaunay;
  const Status made = delaunay.triangulate(common, threads);
  if (sum_of(made ? 0 : 1, ranks) > 0) {
    result->own.at.append(delaunay.triangulation().points.span().first(delaunay.own()));
    Status fine = judge ? judge(result->own) : status_of(unusable_positions(result->own, ranks, threads), first_id);
    if (!fine) return fine.error();
    if (Status all = agree(made, ranks); !all) return all.error();
  }
  resolve_halo(delaunay, result->division, ranks, threads);
  return result;
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

}  // namespace pardel
