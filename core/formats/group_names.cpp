#include "group_names.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "triangle_sections.hpp"

namespace pardel::files {
namespace {

bool is_marker(double v) {
  return v >= static_cast<double>(any_marker_low) && v <= static_cast<double>(any_marker_high) && v == std::floor(v);
}

}  // namespace

GroupValue value_of_group(GroupName::Of of, std::string_view name, double tag) {
  const bool is_region = of == GroupName::Of::region;
  if (is_region && name == "domain") return {std::numeric_limits<double>::quiet_NaN(), true};
  const std::string_view prefix = is_region ? "region " : "marker ";
  double value = 0;
  if (name.starts_with(prefix)) {
    name.remove_prefix(prefix.size());
    const auto [stop, status] = std::from_chars(name.data(), name.data() + name.size(), value);
    const bool right = status == std::errc() && stop == name.data() + name.size() && std::isfinite(value);
    if (right && (is_region || is_marker(value))) return {value, true};
  }
  return {tag, false};
}

bool is_group_name(GroupName::Of of, std::string_view name) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  return !name.empty() && std::ranges::none_of(name, is_control) && !value_of_group(of, name, 0).named;
}

}  // namespace pardel::files
