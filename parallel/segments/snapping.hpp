// The distances below which a repair closes gaps.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

namespace pardel::engine {

/// The distance below which a repair closes a gap: the same everywhere, or a share of the scale of the gap, which is a
/// length (reach.hpp).
class Snapping {
 public:
  /// One distance everywhere.
  Snapping(double distance) : distance_(distance) {}  // NOLINT(*-explicit-*)
  [[nodiscard]] static Snapping share_of_scale(double share) {
    Snapping snapping(0);
    snapping.share_ = share;
    return snapping;
  }

  /// From now on gaps up to the distance are closed at scales with the same power of two as `scale`.
  void widen(double scale, double distance) {
    double& widest = wider_[std::ilogb(scale)];
    widest = std::max(widest, distance);
  }

  [[nodiscard]] bool depends_on_scale() const { return share_ > 0 || !wider_.empty(); }
  [[nodiscard]] bool is_zero() const { return distance_ == 0 && !depends_on_scale(); }
  [[nodiscard]] double at(double scale) const {
    const double usual = std::max(distance_, share_ * scale);
    if (wider_.empty()) return usual;
    const auto wider = wider_.find(std::ilogb(scale));
    return wider == wider_.end() ? usual : std::max(usual, wider->second);
  }
  /// The largest distance at this scale and all smaller ones.
  [[nodiscard]] double largest_up_to(double scale) const {
    double largest = std::max(distance_, share_ * scale);
    for (const auto& [power, distance] : wider_)
      if (power <= std::ilogb(scale)) largest = std::max(largest, distance);
    return largest;
  }

 private:
  double distance_, share_ = 0;
  std::map<int, double> wider_;  ///< by the power of two of the scale
};

}  // namespace pardel::engine
