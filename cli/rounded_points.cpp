#include "rounded_points.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::cli {

bool are_input_points_rounded(const Certificate& certificate, const Mesh& mesh) {
  constexpr int most_searched = 10;
  double largest = 0;
  for (const Point& p : mesh.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const double rounding = 1e-12 * largest;
  int searched = 0;
  for (const Violation& violation : certificate.violations) {
    if (violation.kind != ViolationKind::missing_input_vertex || searched == most_searched) continue;
    ++searched;
    const auto is_near = [&, missing = violation.where[0]](const Point& p) {
      return std::abs(p.x - missing.x) <= rounding && std::abs(p.y - missing.y) <= rounding;
    };
    if (std::none_of(mesh.points.begin(), mesh.points.end(), is_near)) return false;
  }
  return searched > 0;
}

}  // namespace pardel::cli
