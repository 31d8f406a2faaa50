// The triangulation that the engine works on: 24 bytes per triangle, 20 per vertex. Topology and storage
// only; nothing here looks at a coordinate.
#pragma once

#include <array>
#include <cassert>

#include "../../core/array.hpp"
#include "../../core/mesh.hpp"
#include "../concurrency/watched_array.hpp"

namespace pardel::engine {

using VertexId = Index;
using TriangleId = Index;

/// Stands for the point at infinity while the Delaunay triangulation is built: a triangle with it as a
/// corner ("ghost") is the outer side of a hull edge.
inline constexpr VertexId ghost = no_index;

inline constexpr std::array<unsigned, 3> next_corner{1, 2, 0};
inline constexpr std::array<unsigned, 3> previous_corner{2, 0, 1};

/// One side of one triangle, and whether the edge there is constrained. Side i lies opposite corner i.
/// Packed as triangle * 8 + side * 2 + constrained, so a triangulation holds up to 2^29 - 1 triangles.
class EdgeRef {
 public:
  constexpr EdgeRef() = default;
  constexpr EdgeRef(TriangleId triangle, unsigned side, bool constrained = false)
      : bits_(triangle << 3U | side << 1U | static_cast<Index>(constrained)) {}

  [[nodiscard]] constexpr TriangleId triangle() const { return bits_ >> 3U; }
  [[nodiscard]] constexpr unsigned side() const { return bits_ >> 1U & 3U; }
  /// True for every edge of the domain's boundary too, where there is nothing on the other side.
  [[nodiscard]] constexpr bool constrained() const { return (bits_ & 1U) != 0; }
  [[nodiscard]] constexpr bool none() const { return bits_ == no_index; }
  [[nodiscard]] constexpr EdgeRef with_constraint(bool yes) const {
    return none() ? *this : EdgeRef(triangle(), side(), yes);
  }
  friend constexpr bool operator==(const EdgeRef&, const EdgeRef&) = default;

 private:
  Index bits_ = no_index;
};

inline constexpr TriangleId max_triangles = (TriangleId{1} << 29U) - 1;

/// v: corners, counter-clockwise. n[i]: the same edge seen from the triangle across side i.
struct Slot {
  std::array<VertexId, 3> v{};
  std::array<EdgeRef, 3> n{};

  [[nodiscard]] VertexId apex(unsigned side) const { return v[side]; }
  [[nodiscard]] VertexId from(unsigned side) const { return v[next_corner[side]]; }
  [[nodiscard]] VertexId to(unsigned side) const { return v[previous_corner[side]]; }
  [[nodiscard]] bool any_constrained() const { return n[0].constrained() || n[1].constrained() || n[2].constrained(); }
  [[nodiscard]] bool is_ghost() const { return v[0] == ghost || v[1] == ghost || v[2] == ghost; }
};
static_assert(sizeof(Slot) == sizeof(Triangle), "the result reuses the engine's storage");

struct Triangulation {
  Array<Point> points;
  WatchedArray<Slot> slots;
  Array<Index> origin;  ///< per vertex: input_vertex, interior_vertex, or the constraint it lies on
  Array<Index> region;  ///< per triangle, or empty when there is one region only

  [[nodiscard]] const Slot& slot(EdgeRef e) const { return slots[e.triangle()]; }
  [[nodiscard]] const Point& point(VertexId v) const { return points[v]; }

  /// Makes two sides each other's neighbour. `outer` may be none().
  void link(EdgeRef inner, EdgeRef outer) {
    const bool constrained = outer.constrained();
    slots[inner.triangle()].n[inner.side()] = outer;
    if (!outer.none()) slots[outer.triangle()].n[outer.side()] = inner.with_constraint(constrained);
  }
  /// Puts a triangle into another slot, whose content is lost, and tells its neighbours.
  void move_triangle(TriangleId from, TriangleId to) {
    slots[to] = slots[from];
    for (unsigned side = 0; side < 3; ++side)
      if (const EdgeRef out = slots[to].n[side]; !out.none())
        slots[out.triangle()].n[out.side()] = EdgeRef(to, side, out.constrained());
  }
  /// Marks an edge, on both sides.
  void constrain(EdgeRef e) {
    EdgeRef& outer = slots[e.triangle()].n[e.side()];
    outer = outer.with_constraint(true);
    if (!outer.none()) {
      EdgeRef& inner = slots[outer.triangle()].n[outer.side()];
      inner = inner.with_constraint(true);
    }
  }
};

}  // namespace pardel::engine
