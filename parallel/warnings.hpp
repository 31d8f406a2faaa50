// Warnings: parts of a valid domain that are probably mistakes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "validate.hpp"

namespace pardel {

enum class WarningKind : std::uint8_t {
  /// Segments that are joined to each other, have an open end, and lie outside the domain, for example an outline that
  /// is
  /// not closed beside a closed one. They are not in the mesh.
  open_outline,
  /// A point without segments, or a single segment, without which the extent of all points would be less than a
  /// hundredth. Its coordinates are probably wrong. Distances that depend on the extent are then too large.
  far_part,
};
/// The enumerator as text: "open_outline".
[[nodiscard]] const char* name(WarningKind kind);

struct Warning {
  WarningKind kind;
  std::vector<Index> segments;  ///< in ascending order
  Point where;                  ///< an open end; for far_part the outermost point
  std::vector<Index> points{};  ///< only for far_part: the point, or both ends of the segment
  double extent_without = 0;    ///< only for far_part: the extent of all other points

  /// One sentence or two. `base` is the id that the message gives to the first point or segment: usually
  /// Pslg::first_id.value.
  [[nodiscard]] std::string message(int base = 0) const;
};

/// A far part, then one warning for each open outline, in the order of their first segments. If the domain is the
/// convex hull, it has no open outlines. O(n log n); linear if there is no open end.
[[nodiscard]] std::vector<Warning> find_warnings(const ValidPslg& domain);

}  // namespace pardel
