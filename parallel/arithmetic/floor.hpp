// The shortest edge that refinement makes at a place.
#pragma once

#include <algorithm>
#include <cmath>

#include "../../core/pslg.hpp"
#include "predicates.hpp"

namespace pardel::engine {

/// The floor: the shortest edge that refinement makes at a place. It is Options::min_edge, or the shortest edge for
/// which double precision suffices there: coordinates near 2^k are 2^(k-53) apart, and those near 0 are
/// smallest_coordinate apart. The direction of an edge 2^11 times as long has three correct digits. Between two places
/// at the distance d, the floor changes by at most 2^-42 d. So it is nearly the same at all places of an edge that is
/// about as short as the floor.
class Floor {
 public:
  explicit Floor(double min_edge) : least_(std::max(min_edge, smallest_coordinate * 0x1p11)) {}

  /// The floor where it is lowest, at the origin.
  [[nodiscard]] double least() const { return least_; }
  /// No insertion makes a shorter edge, so only a bounded number of points can be inserted and refinement ends
  /// (THEORY.md, Refinement: the floor).
  [[nodiscard]] double at(Point p) const {
    const double largest = std::max(std::abs(p.x), std::abs(p.y));
    return std::max(least_, largest * 0x1p-42);
  }
  [[nodiscard]] double squared_at(Point p) const { return at(p) * at(p); }
  /// The highest floor on the straight line from a to b.
  [[nodiscard]] double along(Point a, Point b) const { return std::max(at(a), at(b)); }

 private:
  double least_;
};

}  // namespace pardel::engine
