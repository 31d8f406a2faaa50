#include "gaps.hpp"

#include <array>
#include <cstddef>

#include "../core/support/shortest.hpp"
#include "diagnosis/find_gaps.hpp"
#include "sizing/guarded.hpp"
#include "threads/parallel_for.hpp"

namespace pardel {

const char* name(GapKind kind) {
  constexpr std::array names{"close_points", "short_segment", "point_near_segment", "point_near_hull"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string Gap::message(int base) const {
  // The other rule that makes a narrow place a gap (find_gaps()).
  const std::string precision = much_narrower * distance < surroundings
                                    ? "."
                                    : ", less than 1000 times the shortest edge that double precision allows.";
  const auto id = [&](Index i) { return std::to_string(static_cast<long long>(i) + base); };
  const std::string first = id(points[0]) + " at " + shortest(where), length = shortest(distance);
  switch (kind) {
    case GapKind::close_points:
      return "The distance of point " + first + " from point " + id(points[1]) + " is only " + length + precision;
    case GapKind::short_segment:
      return "The length of segment " + id(segment) + " from point " + first + " to point " + id(points[1]) +
             " is only " + length + precision;
    case GapKind::point_near_segment:
      return "The distance of point " + first + " from segment " + id(segment) + " is only " + length + precision;
    case GapKind::point_near_hull:
      break;
  }
  return "The distance of point " + first + " from the side of the convex hull between points " + id(points[1]) +
         " and " + id(points[2]) + " is only " + length + precision;
}

Result<std::vector<Gap>> find_gaps(const ValidPslg& domain, int threads) try {
  const engine::Threads all(engine::thread_count(threads, static_cast<double>(domain.pslg().points.size())));
  const Result<engine::DomainTriangulation> triangulated =
      engine::triangulate_domain(domain.pslg(), domain.convex_hull(), all);
  if (!triangulated) return triangulated.error();
  return engine::find_gaps(*triangulated, all);
} catch (...) {
  return engine::error_of_exception();
}

double closing_snap(std::span<const Gap> gaps) {
  constexpr double much_wider = 16;
  double widest = 0;
  for (const Gap& gap : gaps) {
    if (widest > 0 && gap.distance >= much_wider * widest) break;
    widest = gap.distance;
  }
  return 2 * widest;
}

}  // namespace pardel
