// What a repaired domain must have of the old one.
#pragma once

#include <array>

#include "../core/pslg.hpp"
#include "../parallel/repair.hpp"

namespace pardel::fuzz {

/// A linear function of the place, zero at the origin: so its rounding is that of the coordinates.
struct Linear {
  double by_x, by_y;
  [[nodiscard]] double operator()(Point p) const { return by_x * p.x + by_y * p.y; }
  [[nodiscard]] double slope() const;  ///< the most that it changes per unit of length
};

/// The attributes of points, in this order.
inline constexpr std::array<Linear, 2> linear_attributes{{{1, 0}, {-0.5, 0.25}}};

/// Fails if something of the old domain is missing, or is another than the result says: points moved no farther than it
/// says, pieces with the right markers that cover each segment, nothing closer than the snapping distance allows,
/// attributes and markers of points, holes and regions. Precondition: the attributes of the old points are
/// linear_attributes, and they have markers.
void compare_with_repaired(const Pslg& before, const Repaired& repaired, const RepairOptions& options);

}  // namespace pardel::fuzz
