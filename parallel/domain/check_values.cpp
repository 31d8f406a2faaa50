#include "check_values.hpp"

#include <cmath>

#include "../arithmetic/predicates.hpp"
#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

void check_counts(const Pslg& pslg, Findings& found) {
  const std::size_t n = pslg.points.size();
  if (pslg.point_attributes.size() != n * pslg.attributes_per_point ||
      (!pslg.point_markers.empty() && pslg.point_markers.size() != n))
    found.add(ProblemKind::wrong_count, {}, {});
}

void check_coordinates(const Pslg& pslg, const Threads& threads, Findings& found) {
  const auto unusable = [&](std::size_t i) { return !is_usable(pslg.points[i]); };
  for (const Index i : indices_where(threads, pslg.points.size(), unusable)) {
    const Point p = pslg.points[i];
    found.add(problem_of_coordinates(p), {i}, p);
  }
}

void check_indices(const Pslg& pslg, const Threads& threads, Findings& found) {
  SparseAsk ask(threads.stop);
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    ask();
    if (std::max(pslg.segments[s].a, pslg.segments[s].b) >= pslg.points.size())
      found.add(ProblemKind::index_out_of_range, {s}, {});
  }
}

}  // namespace

ProblemKind problem_of_coordinates(Point p) {
  const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
  return finite ? ProblemKind::coordinate_out_of_range : ProblemKind::non_finite_coordinate;
}

void check_values(const Pslg& pslg, const Threads& threads, Findings& found) {
  check_counts(pslg, found);
  check_coordinates(pslg, threads, found);
  check_indices(pslg, threads, found);
}

void check_region_caps(const Pslg& pslg, Findings& found) {
  for (Index r = 0; r < pslg.regions.size(); ++r)
    if (!(pslg.regions[r].max_area > 0)) found.add(ProblemKind::bad_region_cap, {r}, pslg.regions[r].seed);
}

}  // namespace pardel::engine
