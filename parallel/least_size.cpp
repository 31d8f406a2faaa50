#include "least_size.hpp"

#include <algorithm>
#include <cmath>

#include "../core/support/shortest.hpp"
#include "diagnosis/find_least_size.hpp"
#include "sizing/guarded.hpp"
#include "threads/parallel_for.hpp"

namespace pardel {

namespace {

std::string millions(double number) { return shortest(std::round(number / 1e5) / 10) + " million"; }

/// Larger estimates may be too small (quality/estimates.hpp).
std::string about(double number) {
  constexpr double largest = 1e12;
  return number < largest ? "about " + millions(number) : "more than a million million";
}

}  // namespace

std::string LeastSize::message() const {
  std::string text;
  if (names_narrow_part()) text = "The domain is only " + shortest(width) + " wide at " + shortest(where) + ". ";
  if (is_of_narrow_parts())
    return text + "With such narrow parts and this smallest angle, the mesh needs at least " + millions(triangles) +
           " triangles, and usually has " + about(expected) + ".";
  return text + "With these bounds on sizes, the mesh will have " + about(expected) + " triangles.";
}

Result<LeastSize> least_size(const ValidPslg& domain, double min_angle_deg, double min_edge, int threads) try {
  const engine::Threads all(engine::thread_count(threads, static_cast<double>(domain.pslg().points.size())));
  const Result<engine::DomainTriangulation> triangulated =
      engine::triangulate_domain(domain.pslg(), domain.convex_hull(), all);
  if (!triangulated) return triangulated.error();
  return engine::find_least_size(*triangulated, min_angle_deg, min_edge, all);
} catch (...) {
  return engine::error_of_exception();
}

}  // namespace pardel
