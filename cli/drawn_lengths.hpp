// The edge lengths that a drawing in GeoJSON asks for, with the property `length` of its features.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "../core/result.hpp"
#include "../core/size_source.hpp"

namespace pardel::cli {

struct DrawnLengths {
  std::vector<SizeSource> sources;      ///< for Goal::sources: points, lines and the borders of polygons
  std::function<double(Point)> size{};  ///< for Goal::size: the least length of the polygons around a point; infinity:
                                        ///< none. Empty if there are no such polygons.
};

/// What to do about polygons whose sides cross or overlap, or with a corner on a side of another one.
enum class CrossingPolygons : bool { refused, repaired };

/// The function owns its data, and several threads may call it. A call takes O(log n) on typical input. Errors: those
/// of read_drawing(); `invalid_input` if no feature has a length, and with the problems of the polygons that have one.
/// Other shapes may cross them.
[[nodiscard]] Result<DrawnLengths> read_drawn_lengths(const std::filesystem::path& file, CrossingPolygons polygons);

}  // namespace pardel::cli
