#include "extents_by_scale.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::engine {

void ExtentsByScale::add(const Box& box) {
  box_at_.try_emplace(std::ilogb(box.largest_magnitude()), empty_box).first->second.cover(box);
}

double ExtentsByScale::near(double scale) const {
  const int power = std::ilogb(scale);
  Box near = empty_box;
  for (auto at = box_at_.lower_bound(power - 1); at != box_at_.end() && at->first <= power + 1; ++at)
    near.cover(at->second);
  return std::max(0.0, near.extent());
}

double ExtentsByScale::largest_like(double scale) const {
  const auto same = box_at_.find(std::ilogb(scale));
  return same == box_at_.end() ? scale : same->second.largest_magnitude();
}

double ExtentsByScale::next_scale(double least) const {
  const auto next = box_at_.lower_bound(std::ilogb(least));
  return next == box_at_.end() ? least : next->second.largest_magnitude();
}

}  // namespace pardel::engine
