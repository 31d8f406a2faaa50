#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pardel {

double angle_cosine_bound(double min_angle_deg) {
  if (!(min_angle_deg > 0)) return 1;
  return std::cos(std::min(min_angle_deg, 90.0) * std::numbers::pi / 180);
}

}  // namespace pardel
