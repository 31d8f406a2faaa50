#include "reference_case.hpp"

#include <set>
#include <utility>

#include "../properties/domains/paths.hpp"
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

}  // namespace

ReferenceCase decode_reference_case(std::span<const std::uint8_t> bytes) {
  Supply supply(bytes);
  Goal goal{.min_angle_deg = supply.one_of({20.7, 10.0, 15.0, 0.0})};
  goal.conforming = supply.flag(128);
  if (const int cap = supply.below(4); cap == 3) goal.max_area = 12;
  return {.pslg = decode_domain(supply), .goal = goal};
}

}  // namespace pardel::fuzz
