#include "arrays.hpp"

#include <cstring>

namespace pardel::python {

void copy_points(const Numbers& from, Point* to) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  if (from.size() > 0)
    std::memcpy(static_cast<void*>(to), from.data(), static_cast<std::size_t>(from.size()) * sizeof(double));
}

std::vector<Point> points_of(const Numbers& numbers) {
  std::vector<Point> points(static_cast<std::size_t>(numbers.shape(0)));
  copy_points(numbers, points.data());
  return points;
}

}  // namespace pardel::python
