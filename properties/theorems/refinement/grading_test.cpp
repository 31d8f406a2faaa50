// How the sizes of triangles follow the local feature size.
#include <algorithm>
#include <cmath>
#include <limits>

#include "../framework/shares.hpp"
#include "feature_size.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

PARDEL_PROPERTY(
    Grading, of_a_mesh_follows_the_local_feature_size,
    {.statement = "Mesh a domain for a bound on angles alone. If no triangle is exempt, every edge is "
                  "at least 1/12 of the local feature size at each of its ends. (The least in 20,000 cases: 1/10.1.)",
     .source = "Ruppert 1995, Theorem 1; the factor as measured",
     .families = every_family}) {
  Problem problem = some_problem(exhibit);
  problem.goal = {.min_angle_deg = problem.goal.min_angle_deg, .region_caps = false};
  const Meshed result = meshed(problem, exhibit);
  RC_PRE(result.report.exempt.empty());
  const Mesh domain = value_of(triangulate(problem.pslg)).mesh;
  const std::vector<Feature> features = features_of(domain);
  std::vector<double> shortest(result.mesh.points.size(), std::numeric_limits<double>::infinity());
  for (const Triangle& t : result.mesh.triangles)
    for (unsigned i = 0; i < 3; ++i) {
      const Point a = result.mesh.points[t.v[i]], b = result.mesh.points[t.v[(i + 1) % 3]];
      const double length = std::hypot(a.x - b.x, a.y - b.y);
      for (const Index v : {t.v[i], t.v[(i + 1) % 3]}) shortest[v] = std::min(shortest[v], length);
    }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < shortest.size(); ++v)
    if (shortest[v] < std::numeric_limits<double>::infinity())
      least = std::min(least, shortest[v] / local_feature_size(domain, features, result.mesh.points[v]));
  classify(result.report.inserted + result.report.segment_splits > 0, "points were inserted", 50);
  RC_ASSERT(least >= 1.0 / 12);
}

}  // namespace
}  // namespace pardel::properties
