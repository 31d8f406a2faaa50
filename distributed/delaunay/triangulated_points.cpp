#include "triangulated_points.hpp"

#include <utility>

#include "../../core/support/agree.hpp"
#include "../../core/support/collective.hpp"
#include "problems_of_points.hpp"
#include "resolve_halo.hpp"

namespace pardel::engine {

Result<std::unique_ptr<TriangulatedPoints>> triangulated(PartOfPoints&& read, Ranks& ranks, const Threads& threads,
                                                         const JudgeOfPoints& judge) {
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

}  // namespace pardel::engine
