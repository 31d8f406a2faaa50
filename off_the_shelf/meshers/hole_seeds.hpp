// The holes of a subdomain, for meshers that do not read its triangles.
#pragma once

#include <vector>

#include "../../core/result.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// A point inside each hole: each face of the border that no triangle covers, without the one around everything.
/// O(n log n) for n edges of the border, and O(m) for m points. Error: that of validate() or triangulate() for the
/// border.
[[nodiscard]] Result<std::vector<Point>> hole_seeds(const Subdomain& subdomain);

}  // namespace pardel::engine
