#include "user_test.hpp"

#include <algorithm>
#include <array>

#include "support/point_order.hpp"

namespace pardel {

bool must_be_refined(const UserTest& test, Point a, Point b, Point c) {
  std::array<Point, 3> p{a, b, c};
  std::rotate(p.begin(), std::min_element(p.begin(), p.end(), lexicographically_less), p.end());
  const double twice_area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  return test(p, std::max(0.0, 0.5 * twice_area));
}

}  // namespace pardel
