// The box around a subdomain.
#pragma once

#include "../../parallel/decomposition/bounding_box.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// The least box around all points.
[[nodiscard]] inline Box box_of(const Subdomain& subdomain) {
  return bounding_box(Threads(1), subdomain.points.size(), [&](std::size_t i) { return subdomain.points[i]; });
}

}  // namespace pardel::engine
