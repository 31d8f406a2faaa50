// A line that divides the plane for point location, and the triangles on each side.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "located_triangles.hpp"

namespace pardel::engine {

/// A vertical or horizontal line, or the line through an edge of a triangle. Which side a point is on is decided
/// exactly.
struct LocationSplit {
  enum class Kind : std::uint8_t { x, y, edge };
  enum Side : std::uint8_t { below, on, above };  ///< no point is `on` a vertical or horizontal line: it is `below`

  Kind kind = Kind::x;
  double at = 0;       ///< of x and y
  Point from{}, to{};  ///< of an edge: `above` is to the left

  [[nodiscard]] Side side_of(Point p) const {
    if (kind == Kind::edge) {
      const double turn = orient2d(from, to, p);
      return turn > 0 ? above : turn < 0 ? below : on;
    }
    return (kind == Kind::x ? p.x : p.y) > at ? above : below;
  }
};

/// Triangles that are divided by a split. A list has all triangles with points on its side, in ascending order, apart
/// from those that are superfluous: of the triangles that have one vertex on the line, and no other point, the first.
struct DividedTriangles {
  LocationSplit split;
  std::vector<Index> lists[3];  ///< by LocationSplit::Side

  [[nodiscard]] std::size_t longest() const;
  [[nodiscard]] std::size_t total() const { return lists[0].size() + lists[1].size() + lists[2].size(); }
};

/// Divides triangles into parts that are notably smaller; nothing if no such line is found. The list is in ascending
/// order. O(n).
[[nodiscard]] std::optional<DividedTriangles> divided(const LocatedTriangles& all, std::span<const Index> list);

}  // namespace pardel::engine
