// Reads the shapes of a GeoJSON file (RFC 7946): points, lines and polygons, alone or in features and collections.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "../core/result.hpp"
#include "drawn_domain.hpp"

namespace pardel::cli {

/// The property `length` of features. A domain has no use for it, and it may be anything there.
enum class LengthProperty : bool { ignored, read };

/// The shapes as a Drawing collects them. Error: `invalid_input`. For wrong JSON the message begins
/// `NAME:LINE:COLUMN:`, for other faults it names the place in the file, as in `NAME:
/// features[2].geometry.coordinates[0][4]: ...`: ring 0, position 4 of feature 2, all counted from 0. Time O(n log n).
/// go_on: if it returns false, the result is an error `cancelled`.
[[nodiscard]] Result<DrawnDomain> parse_geojson(std::string_view text, const std::string& name,
                                                LengthProperty lengths = LengthProperty::ignored,
                                                const std::function<bool()>& go_on = {});

}  // namespace pardel::cli
