// Colours, and scales of colours.
#pragma once

#include <cstdint>
#include <vector>

namespace pardel::cli {

/// Red, green and blue from 0 to 1.
struct Colour {
  double red = 1, green = 1, blue = 1;
  friend bool operator==(const Colour&, const Colour&) = default;
};

inline constexpr Colour white{1, 1, 1};
inline constexpr Colour edge_colour{0.25, 0.33, 0.42};
inline constexpr Colour segment_colour{0.1, 0.1, 0.1};

/// The colour at `t`, from 0 to 1, on the way from `a` to `b`.
[[nodiscard]] Colour mixed(Colour a, Colour b, double t);

/// A light colour; hues are in degrees.
[[nodiscard]] Colour light(std::uint16_t hue);

/// `n` colours from red (bad) over yellow to blue (good), which colour-blind people can tell apart.
[[nodiscard]] std::vector<Colour> bad_to_good(std::size_t n);
/// `n` colours from dark blue (small) to light yellow (large).
[[nodiscard]] std::vector<Colour> small_to_large(std::size_t n);

}  // namespace pardel::cli
