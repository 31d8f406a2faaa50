#include "arrays.hpp"

#include <cstring>

namespace pardel::python {

std::vector<Point> points_of(const Numbers& numbers) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  std::vector<Point> points(static_cast<std::size_t>(numbers.shape(0)));
  if (!points.empty()) std::memcpy(static_cast<void*>(points.data()), numbers.data(), points.size() * sizeof(Point));
  return points;
}

}  // namespace pardel::python
