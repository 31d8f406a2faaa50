// Reads the shapes of a GeoJSON file (RFC 7946): points, lines and polygons, alone or in features and collections.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../core/size_source.hpp"

namespace pardel::cli {

/// A polygon as the file has it: the outer ring, then the rings of its holes. The first point of a ring is not
/// repeated.
struct DrawnPolygon {
  std::vector<std::vector<Point>> rings;
  bool is_hole = false;
  std::optional<double> attribute;  ///< of its region
  std::optional<double> max_area;   ///< > 0
  std::optional<double> length{};   ///< > 0, wanted inside
};

/// The points and segments of all shapes, and the polygons, whose faces are not yet known.
struct DrawnDomain {
  Pslg pslg;  ///< without holes and regions
  std::vector<DrawnPolygon> polygons;
  std::vector<SizeSource> sources{};  ///< the points, lines and borders of polygons that have a length
};

/// The property `length` of features. A domain has no use for it, and it may be anything there.
enum class LengthProperty : bool { ignored, read };

/// Equal points become one, and so do segments with the same ends, which get the first marker that is not 0. A segment
/// without length is left out. Error: `invalid_input`. For wrong JSON the message begins `NAME:LINE:COLUMN:`, for other
/// faults it names the place in the file, as in `NAME: features[2].geometry.coordinates[0][4]: ...`: ring 0, position 4
/// of feature 2, all counted from 0. Time O(n log n).
[[nodiscard]] Result<DrawnDomain> parse_geojson(std::string_view text, const std::string& name,
                                                LengthProperty lengths = LengthProperty::ignored);

}  // namespace pardel::cli
