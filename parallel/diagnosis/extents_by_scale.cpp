#include "extents_by_scale.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::engine {
namespace {

/// Of 0: the power below that of the least double.
int power_of(double scale) {
  constexpr int below_all = -1075;
  return scale == 0 ? below_all : std::ilogb(scale);
}

}  // namespace

void ExtentsByScale::add(const Box& box) {
  box_at_.try_emplace(power_of(box.largest_magnitude()), empty_box).first->second.cover(box);
}

double ExtentsByScale::near(double scale) const {
  const int power = power_of(scale);
  Box near = empty_box;
  for (auto at = box_at_.lower_bound(power - 1); at != box_at_.end() && at->first <= power + 1; ++at)
    near.cover(at->second);
  return std::max(0.0, near.extent());
}

double ExtentsByScale::largest_like(double scale) const {
  const auto same = box_at_.find(power_of(scale));
  return same == box_at_.end() ? scale : same->second.largest_magnitude();
}

double ExtentsByScale::next_scale(double least) const {
  const auto next = box_at_.lower_bound(power_of(least));
  return next == box_at_.end() ? least : next->second.largest_magnitude();
}

}  // namespace pardel::engine
