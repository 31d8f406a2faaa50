#include "reference_case.hpp"

#include <limits>
#include <set>
#include <utility>

#include "../properties/domains/generators/mixed_scales.hpp"
#include "../properties/domains/paths.hpp"
#include "../properties/theorems/refinement/plain_coordinates.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

Pslg decode_domain(Supply& bytes) {
  Pslg pslg;
  const int kind = bytes.below(4), low = 3 + bytes.below(5), high = 8 + bytes.below(6), right = 8 + bytes.below(6);
  domains::add_closed(pslg, domains::rectangle(0, 0, 16, 16));
  if (kind == 1 || kind == 2) domains::add_closed(pslg, domains::rectangle(low, low, right, high));
  if (kind == 1) pslg.holes.push_back({(low + right) / 2.0, (low + high) / 2.0});
  if (kind == 3) domains::add_open(pslg, {{double(low), 2}, {double(right), double(high)}});
  std::set<std::pair<int, int>> used;
  while (!bytes.empty() && used.size() < 16) {
    const int x = 1 + bytes.below(15), y = 1 + bytes.below(15);
    const auto lies_between = [](int k, int a, int b) { return k >= a && k <= b; };
    const bool in_box = lies_between(x, low, right) && lies_between(y, low, high);
    const bool on_wall = kind == 3 && (right - low) * (y - 2) == (high - 2) * (x - low);
    if ((kind == 1 || kind == 2) && in_box) continue;
    if (!on_wall && used.insert({x, y}).second) pslg.points.push_back({double(x), double(y)});
  }
  return pslg;
}

/// Mixes scales, if the result has coordinates that the reference takes. A tiny feature could have a small angle.
Pslg mixed(const Pslg& pslg, int seed) {
  using enum generators::Mixture;
  generators::Random random(static_cast<std::uint64_t>(seed));
  const generators::Mixed drawn =
      mixed_scales(pslg, pslg, random, false,
                   {far_points_outside, component_beside, component_in_hole, component_in_face, component_far_off});
  Pslg scaled = properties::as_large_as_plain_coordinates(drawn.pslg);
  return properties::has_plain_coordinates(scaled) ? scaled : pslg;
}

}  // namespace

ReferenceCase decode_reference_case(std::span<const std::uint8_t> bytes) {
  Supply supply(bytes);
  constexpr double angles[] = {20.7, 10, 15, 0};
  const int first = supply.byte();
  Goal goal{.min_angle_deg = angles[first % 4]};
  goal.conforming = supply.flag(128);
  const int cap = supply.byte();
  if (cap % 4 == 3) goal.max_area = 12;
  Pslg pslg = decode_domain(supply);
  // The inputs that were stored before have no such first byte, so that they keep their meaning.
  if (first >= 140 && first < 204) {
    pslg = mixed(pslg, 256 * first + cap);
    goal.max_area = std::numeric_limits<double>::infinity();
  }
  return {.pslg = std::move(pslg), .goal = goal};
}

}  // namespace pardel::fuzz
