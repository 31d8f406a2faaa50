// The triangulation that the engine works on: 24 bytes per triangle and 20 bytes per vertex. This file holds topology
// and storage only; it does not evaluate coordinates.
#pragma once

#include <array>
#include <cassert>

#include "../../core/array.hpp"
#include "../../core/mesh.hpp"
#include "../threads/watched_array.hpp"

namespace pardel::engine {

using VertexId = Index;
using TriangleId = Index;

/// The vertex at infinity, which exists while the Delaunay triangulation is built. A triangle that has it as a corner
/// is called a ghost triangle. Each edge of the convex hull has one ghost triangle on its outer side, so every edge has
/// two triangles. Carving removes the ghost triangles (carve.hpp).
inline constexpr VertexId ghost = no_index;

/// A value of Triangulation::origin beside those of Mesh::origin: a vertex on the border of a patch that will be laid
/// after the refinement (filling/filling.hpp). No finished mesh has one.
inline constexpr Index border_vertex = no_index - 2;

inline constexpr std::array<unsigned, 3> next_corner{1, 2, 0};
inline constexpr std::array<unsigned, 3> previous_corner{2, 0, 1};

/// The side through which a straight line leaves a triangle that it enters through the side opposite corner `apex`.
/// `apex_lies_ahead`, `from_lies_ahead`: whether the apex, and the first end of the side that is entered, lie on one
/// side of the line, which is the same for both. The apex replaces the end on its own side.
[[nodiscard]] constexpr unsigned exit_side(unsigned apex, bool apex_lies_ahead, bool from_lies_ahead) {
  return apex_lies_ahead == from_lies_ahead ? next_corner[apex] : previous_corner[apex];
}

/// A side of a triangle: an edge as seen from one of its two triangles, and a bit that states whether the edge is
/// constrained. Side i lies opposite corner i. The three values are packed as triangle * 8 + side * 2 + constrained, so
/// a triangulation holds up to 2^29 - 1 triangles. The default value none() refers to no triangle.
class EdgeRef {
 public:
  constexpr EdgeRef() = default;
  constexpr EdgeRef(TriangleId triangle, unsigned side, bool constrained = false)
      : bits_(triangle << 3U | side << 1U | static_cast<Index>(constrained)) {}

  [[nodiscard]] constexpr TriangleId triangle() const { return bits_ >> 3U; }
  [[nodiscard]] constexpr unsigned side() const { return bits_ >> 1U & 3U; }
  /// Also true for none(), so every edge of the domain's boundary counts as constrained.
  [[nodiscard]] constexpr bool constrained() const { return (bits_ & 1U) != 0; }
  [[nodiscard]] constexpr bool none() const { return bits_ == no_index; }
  [[nodiscard]] constexpr EdgeRef with_constraint(bool yes) const {
    return none() ? *this : EdgeRef(triangle(), side(), yes);
  }
  friend constexpr bool operator==(const EdgeRef&, const EdgeRef&) = default;

 private:
  Index bits_ = no_index;
};

/// The largest number of triangles that an EdgeRef can distinguish.
inline constexpr TriangleId max_engine_triangles = (TriangleId{1} << 29U) - 1;

/// A constraint: an edge that the triangulation must contain, given by its two vertices.
struct Constraint {
  VertexId a, b;
};

/// One element of the array of triangles. Its position is the id of the triangle. Insertions and flips reuse slots, so
/// one slot holds different triangles over time.
struct Slot {
  std::array<VertexId, 3> v{};  ///< the corners, counter-clockwise
  std::array<EdgeRef, 3> n{};   ///< n[i]: the edge of side i, as a side of the triangle across it

  /// The corner opposite a side. The side itself runs counter-clockwise from `from` to `to`.
  [[nodiscard]] VertexId apex(unsigned side) const { return v[side]; }
  [[nodiscard]] VertexId from(unsigned side) const { return v[next_corner[side]]; }
  [[nodiscard]] VertexId to(unsigned side) const { return v[previous_corner[side]]; }
  /// The position of a vertex among the corners, 0 to 2. Precondition: it is a corner.
  [[nodiscard]] unsigned corner_of(VertexId vertex) const { return v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2; }
  [[nodiscard]] bool any_constrained() const { return n[0].constrained() || n[1].constrained() || n[2].constrained(); }
  [[nodiscard]] bool is_ghost() const { return v[0] == ghost || v[1] == ghost || v[2] == ghost; }
};
static_assert(sizeof(Slot) == sizeof(Triangle), "the result reuses the engine's storage");

struct Triangulation {
  Array<Point> points;
  WatchedArray<Slot> slots;
  /// Per vertex: where it comes from. As Mesh::origin, with the segments of the domain; or border_vertex.
  Array<Index> origin;
  Array<Index> region;  ///< per triangle; empty if there is only one region

  [[nodiscard]] const Slot& slot(EdgeRef e) const { return slots[e.triangle()]; }

  /// True if a patch will be laid beyond the edge. Such an edge is never split.
  [[nodiscard]] bool on_border_of_patch(EdgeRef e) const {
    const Slot& s = slot(e);
    return s.n[e.side()].none() && origin[s.from(e.side())] == border_vertex && origin[s.to(e.side())] == border_vertex;
  }

  /// Makes two sides neighbours of each other. `outer`, which may be none(), determines whether the edge is
  /// constrained.
  void link(EdgeRef inner, EdgeRef outer) {
    const bool constrained = outer.constrained();
    slots[inner.triangle()].n[inner.side()] = outer;
    if (!outer.none()) slots[outer.triangle()].n[outer.side()] = inner.with_constraint(constrained);
  }
  /// Copies a triangle to slot `to`, overwrites the triangle there, and updates the neighbours' references.
  void move_triangle(TriangleId from, TriangleId to) {
    slots[to] = slots[from];
    for (unsigned side = 0; side < 3; ++side)
      if (const EdgeRef out = slots[to].n[side]; !out.none())
        slots[out.triangle()].n[out.side()] = EdgeRef(to, side, out.constrained());
  }
  /// Turns a triangle, so that corner `first` becomes its first one.
  void turn(TriangleId id, unsigned first) {
    const Slot before = slots[id];
    for (unsigned i = 0; i < 3; ++i) {
      const unsigned from = (first + i) % 3;
      slots[id].v[i] = before.v[from];
      link({id, i}, before.n[from]);
    }
  }
  /// Marks an edge as constrained, on both sides.
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
