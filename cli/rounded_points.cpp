#include "rounded_points.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::cli {

bool are_input_points_rounded(const Certificate& certificate, const Mesh& mesh) {
  constexpr int most_searched = 10;
  constexpr double rounding = 1e-12;
  int searched = 0;
  for (const Violation& violation : certificate.violations) {
    if (violation.kind != ViolationKind::missing_input_vertex || searched == most_searched) continue;
    ++searched;
    const Point missing = violation.where[0];
    const auto differs_by_rounding = [&](const Point& p) {
      return !(p == missing) && std::abs(p.x - missing.x) <= rounding * std::abs(missing.x) &&
             std::abs(p.y - missing.y) <= rounding * std::abs(missing.y);
    };
    if (std::ranges::none_of(mesh.points, differs_by_rounding)) return false;
  }
  return searched > 0;
}

}  // namespace pardel::cli
