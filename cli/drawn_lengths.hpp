// Reads the edge lengths that a drawing in GeoJSON asks for, with the property `length` of its features.
#pragma once

#include <filesystem>

#include "../core/result.hpp"
#include "lengths_of_drawing.hpp"

namespace pardel::cli {

/// What to do about polygons whose sides cross or overlap, or with a corner on a side of another one.
enum class CrossingPolygons : bool { refused, repaired };

/// Errors: those of read_drawing() and lengths_of(); `invalid_input` with the problems of the polygons that have a
/// length. Other shapes may cross them.
[[nodiscard]] Result<DrawnLengths> read_drawn_lengths(const std::filesystem::path& file, CrossingPolygons polygons);

}  // namespace pardel::cli
