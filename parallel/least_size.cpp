#include "least_size.hpp"

#include <algorithm>
#include <cmath>

#include "../core/support/shortest.hpp"
#include "concurrency/parallel_for.hpp"
#include "conversion/guarded.hpp"
#include "diagnosis/find_least_size.hpp"

namespace pardel {

std::string LeastSize::message() const {
  const double millions = std::round(triangles / 1e5) / 10;
  return "The domain is only " + shortest(width) + " wide at " + shortest(where) +
         ". With such narrow parts and this " + "smallest angle, the mesh needs at least " + shortest(millions) +
         " million triangles.";
}

Result<LeastSize> least_size(const ValidPslg& domain, double min_angle_deg, double min_edge, int threads) try {
  const engine::Threads all(engine::thread_count(threads));
  const Result<engine::DomainTriangulation> triangulated =
      engine::triangulate_domain(domain.pslg(), domain.convex_hull(), all);
  if (!triangulated) return triangulated.error();
  return engine::find_least_size(*triangulated, min_angle_deg, min_edge, all);
} catch (...) {
  return engine::error_of_exception();
}

}  // namespace pardel
