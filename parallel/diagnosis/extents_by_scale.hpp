// The extents of the parts of a domain, which may have very different scales.
#pragma once

#include <map>

#include "../arithmetic/box.hpp"

namespace pardel::engine {

/// Boxes around segments or points, joined if the largest magnitudes of their coordinates have the same power of two.
class ExtentsByScale {
 public:
  void add(const Box& box);

  [[nodiscard]] bool empty() const { return box_at_.empty(); }
  /// The extent of all boxes at this power of two, and the next one above and below.
  [[nodiscard]] double near(double scale) const;
  /// The largest scale with the same power of two; `scale` itself if there is none.
  [[nodiscard]] double largest_like(double scale) const;
  /// The least scale, or one with the same power of two, that is not smaller than `least`; `least` if there is none.
  [[nodiscard]] double next_scale(double least) const;

  /// Calls visit(scale) with the largest scale of each power of two.
  template <class Visit>
  void for_each_scale(const Visit& visit) const {
    for (const auto& [power, box] : box_at_) visit(box.largest_magnitude());
  }

 private:
  std::map<int, Box> box_at_;
};

}  // namespace pardel::engine
