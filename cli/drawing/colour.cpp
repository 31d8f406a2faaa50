#include "colour.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace pardel::cli {
namespace {

/// `n` colours at equal distances on the polyline through `stops`.
std::vector<Colour> scale(std::span<const Colour> stops, std::size_t n) {
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = n == 1 ? 0 : static_cast<double>(i * (stops.size() - 1)) / static_cast<double>(n - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    colours.push_back(mixed(stops[first], stops[first + 1], at - static_cast<double>(first)));
  }
  return colours;
}

}  // namespace

Colour mixed(Colour a, Colour b, double t) {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green), a.blue + t * (b.blue - a.blue)};
}

Colour light(std::uint16_t hue) {
  constexpr double saturation = 0.6, lightness = 0.84;
  const double chroma = (1 - std::abs(2 * lightness - 1)) * saturation;
  // CSS Color 4, HSL to RGB: a channel is full within 60 degrees of its own hue and zero beyond 120 degrees.
  const auto channel = [&](double own) {
    const double away = std::abs(std::remainder(hue - own, 360));
    return lightness - chroma / 2 + chroma * std::clamp(2 - away / 60, 0.0, 1.0);
  };
  return {channel(0), channel(120), channel(240)};
}

// The stops of both scales are those of ColorBrewer (Brewer 2003): RdYlBu and YlGnBu.
std::vector<Colour> bad_to_good(std::size_t n) {
  constexpr Colour stops[] = {{0.843, 0.188, 0.153}, {0.988, 0.553, 0.349}, {0.996, 0.878, 0.565},
                              {0.878, 0.953, 0.973}, {0.569, 0.749, 0.859}, {0.271, 0.459, 0.706}};
  return scale(stops, n);
}

std::vector<Colour> small_to_large(std::size_t n) {
  constexpr Colour stops[] = {{0.145, 0.204, 0.580},
                              {0.173, 0.498, 0.722},
                              {0.255, 0.714, 0.769},
                              {0.631, 0.855, 0.706},
                              {1.000, 1.000, 0.800}};
  return scale(stops, n);
}

}  // namespace pardel::cli
