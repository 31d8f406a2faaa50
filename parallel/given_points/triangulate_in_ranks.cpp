#include <algorithm>
#include <cmath>
#include <utility>

#include "../../core/support/agree.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "../distributed.hpp"
#include "../input/convex_hull.hpp"
#include "../input/duplicates.hpp"
#include "../mesher.hpp"
#include "../planning/supervised.hpp"
#include "../validate.hpp"
#include "ask_others.hpp"
#include "piece_of_points.hpp"
#include "triangulated_points.hpp"

namespace pardel {

using namespace engine;

namespace {

Error refused(const std::vector<Problem>& problems, FirstId first_id) {
  return {ErrorKind::invalid_input, messages(problems, first_id.value)};
}

/// Problems name points by their numbers among all points.
Index id_of(std::uint64_t number) { return static_cast<Index>(std::min<std::uint64_t>(number, no_index)); }

Status check_coordinates(const PartOfPoints& read, const Threads& threads) {
  constexpr std::size_t most = 100;
  std::vector<Problem> problems;
  for (const Index i :
       indices_where(threads, read.points.size(), [&](std::size_t i) { return !is_usable(read.points[i]); })) {
    const Point p = read.points[i];
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
    problems.push_back({finite ? ProblemKind::coordinate_out_of_range : ProblemKind::non_finite_coordinate,
                        {id_of(read.first + i)},
                        p});
    if (problems.size() == most) break;
  }
  if (problems.empty()) return Done{};
  return refused(problems, read.first_id);
}

/// Equal points have the same owner.
Status check_duplicates(const OwnPoints& own, FirstId first_id, const Threads& threads) {
  std::vector<Problem> problems;
  for (const Duplicate& each : find_duplicates(own.at.span(), threads)) {
    const auto [first, again] = std::minmax(own.number[each.first], own.number[each.again]);
    problems.push_back({ProblemKind::duplicate_points, {id_of(first), id_of(again)}, own.at[each.first]});
  }
  if (problems.empty()) return Done{};
  std::ranges::sort(problems, {}, &Problem::ids);
  return refused(problems, first_id);
}

/// The reason why the rank could not triangulate the points that it knows. Done if it is not a fault of the rank's own
/// points: other ranks have told it about equal points.
Status reason_for(const Error& failure, const LocalDelaunay& delaunay, const OwnPoints& own, FirstId first_id,
                  const Threads& threads) {
  if (failure.kind != ErrorKind::invalid_input) return failure;
  if (Status distinct = check_duplicates(own, first_id, threads); !distinct) return distinct;
  const std::span<const Point> known = delaunay.triangulation().points.span();
  if (!all_collinear(known, threads)) return Done{};
  return refused({{ProblemKind::all_points_collinear, {}, known.empty() ? Point{} : known[0]}}, first_id);
}

}  // namespace

Result<std::unique_ptr<TriangulatedPoints>> engine::triangulated(PartOfPoints&& read, Ranks& ranks,
                                                                 const Threads& threads) {
  const FirstId first_id = read.first_id;
  if (Status usable = agree_on_input(check_coordinates(read, threads), ranks); !usable) return usable.error();
  CurveDivision division = divide_along_curve(read.points, ranks);
  OwnPoints own = send_to_owners(std::move(read), division, ranks, threads);
  const std::uint64_t first = own.first[ranks.rank()];
  const std::vector<Site> common = common_sites(own.at.span(), first, own.first.back(), ranks);
  Array<Point> at = own.at;
  // Not std::make_unique: the triangulation is made in its place, because it cannot be moved.
  std::unique_ptr<TriangulatedPoints> result(
      new TriangulatedPoints{std::move(division), std::move(own), {std::move(at), first}});
  LocalDelaunay& delaunay = result->delaunay;
  const Status made = delaunay.triangulate(common, threads);
  const Status fault = made ? made : reason_for(made.error(), delaunay, result->own, first_id, threads);
  if (Status all = agree_on_input(fault, ranks); !all) return all.error();
  if (!made) return made.error();
  result->own.at = {};
  ask_others(delaunay, result->division, ranks, threads);
  return result;
}

Result<MeshPiece> triangulate(PartOfPoints&& points, const Options& options, Ranks& ranks) {
  return supervised(options, [&](const Options&, ProgressMonitor& progress) -> Result<MeshPiece> {
    Stopwatch watch;
    const FirstId first_id = points.first_id;
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
