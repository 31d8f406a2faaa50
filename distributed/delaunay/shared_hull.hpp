// The convex hull of points that are divided among ranks. All ranks know it.
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/ranks.hpp"
#include "local_delaunay.hpp"
#include "own_points.hpp"

namespace pardel::engine {

/// A vertex of the convex hull, as its owner tells all ranks about it. Points inside edges of the hull are vertices,
/// too.
struct HullVertex {
  Point at;
  std::uint64_t position, next;  ///< of the vertex, and of the next one around the hull, counter-clockwise
  std::uint64_t number;          ///< in the input
  int marker;                    ///< 0 if it has none
  int unused = 0;
};

/// A rank is sure about an edge of the hull only if it owns an end of the edge: beyond other edges of its triangulation
/// there may be points that it does not know.
class SharedHull {
 public:
  /// Collective. Precondition: the triangles with own corners, ghosts included, are those of all points
  /// (resolve_halo()).
  SharedHull(const LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks);

  /// In the order of positions.
  [[nodiscard]] const std::vector<HullVertex>& vertices() const { return vertices_; }
  [[nodiscard]] bool has(std::uint64_t position) const { return at_position(vertices_, position) != nullptr; }
  /// True if the hull has this edge, counter-clockwise.
  [[nodiscard]] bool has_edge(std::uint64_t from, std::uint64_t to) const {
    const HullVertex* v = at_position(vertices_, from);
    return v != nullptr && v->next == to;
  }

 private:
  std::vector<HullVertex> vertices_;
};

}  // namespace pardel::engine
