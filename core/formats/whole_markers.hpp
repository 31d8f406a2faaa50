// Tells markers from other values in an array with the name "marker", as VTK's files have it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "../array.hpp"
#include "../field.hpp"

namespace pardel::files {

/// The values as markers; nothing if one of them is no integer of 32 bits. Then the array is a field.
[[nodiscard]] inline std::optional<Array<int>> whole_markers(std::span<const double> values) {
  constexpr double low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
  const auto is_marker = [](double v) { return v >= low && v <= high && v == std::floor(v); };
  if (!std::ranges::all_of(values, is_marker)) return std::nullopt;
  Array<int> markers;
  markers.resize_uninitialised(values.size());
  std::ranges::transform(values, markers.begin(), [](double v) { return static_cast<int>(v); });
  return markers;
}

/// The same of the values of some cells.
[[nodiscard]] inline std::optional<Array<int>> whole_markers(std::span<const double> values,
                                                             std::span<const std::size_t> cells) {
  Array<double> of_cells;
  for (const std::size_t cell : cells) of_cells.push_back(values[cell]);
  return whole_markers(of_cells.span());
}

/// False for 0 and for what is not a number: a cell has one of these where an array says nothing about it.
[[nodiscard]] inline bool says_something(double value) { return value != 0 && !std::isnan(value); }

/// True for an array of cells with the name of markers of lines. Triangles have no markers, so it is a field in them.
[[nodiscard]] inline bool is_marker_of_triangles(const Field& field) {
  return field.place == Field::Place::triangles && field.name == "marker" && field.components == 1;
}

}  // namespace pardel::files
