// The segments of a domain in the order of the polylines that they form.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// A vertex is smooth if exactly two segments meet there and the direction turns by less than about 49 degrees (the
/// cosine of the turn exceeds 0.65). All other points are corners. A polyline is a maximal chain of segments that meet
/// at smooth vertices. It begins at the end, and runs in the direction, that its coordinates determine.
struct Polyline {
  std::vector<Index> vertices;  ///< in order; a closed polyline without a corner repeats its first vertex at the end
  bool closed = false;          ///< no vertex of it is a corner
};

struct Polylines {
  std::vector<Polyline> all;    ///< in the order of the Pslg
  std::vector<bool> is_corner;  ///< per point
};

[[nodiscard]] Polylines find_polylines(const Pslg& pslg, const Threads& threads);

}  // namespace pardel::engine
