// Warnings: parts of a valid domain that are probably mistakes.
#pragma once

#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "validate.hpp"

namespace pardel {

/// Segments that are joined to each other, have an open end, and lie outside the domain, for example an outline that is
/// not closed beside a closed one. They are not in the mesh.
struct Warning {
  std::vector<Index> segments;  ///< in ascending order
  Point where;                  ///< an open end

  /// One sentence. `base` is the id that the message gives to the first segment: usually Pslg::first_id.value.
  [[nodiscard]] std::string message(int base = 0) const;
};

/// One warning for each group of such segments, in the order of their first segments. None if the domain is the convex
/// hull. O(n log n); linear if there is no open end.
[[nodiscard]] std::vector<Warning> find_warnings(const ValidPslg& domain);

}  // namespace pardel
