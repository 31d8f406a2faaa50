// The edges of a triangulation that a segment between two of its vertices crosses.
#pragma once

#include <vector>

#include "../arithmetic/predicates.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Calls visit(triangle, corner) for the triangles around v, counter-clockwise from `start`, until it returns true.
/// Precondition: ghosts are there, so that the triangles surround v.
template <class Visit>
void for_each_around(const Triangulation& t, VertexId v, TriangleId start, const Visit& visit) {
  TriangleId id = start;
  do {
    const unsigned corner = t.slots[id].corner_of(v);
    if (visit(id, corner)) return;
    id = t.slots[id].n[next_corner[corner]].triangle();
  } while (id != start);
}

/// What a segment meets on its way from a to b. If all members are empty, the triangulation is inconsistent.
struct CrossedEdges {
  EdgeRef present;             ///< the edge from a to b, if there is one
  std::vector<EdgeRef> edges;  ///< in the order along the segment, each as a side of the triangle before it
  VertexId passed = no_index;  ///< the first vertex inside the segment, if there is one; the walk ends there
  EdgeRef constrained;         ///< the first constrained edge that it crosses; the walk ends there
};

/// `at_a`: a triangle with the corner c.a. O(degree of a + crossed edges).
inline void find_crossed_edges(const Triangulation& t, Constraint c, TriangleId at_a, SparseAsk& ask,
                               CrossedEdges& found) {
  found.present = found.constrained = {};
  found.edges.clear();
  found.passed = no_index;
  const Point a = t.points[c.a], b = t.points[c.b];
  EdgeRef e;
  for_each_around(t, c.a, at_a, [&](TriangleId id, unsigned corner) {
    const Slot& slot = t.slots[id];
    const VertexId x = slot.from(corner), y = slot.to(corner);
    if (x == c.b) {
      found.present = EdgeRef(id, previous_corner[corner]);
      return true;
    }
    if (x == ghost) return false;
    const double right = orient2d(a, t.points[x], b);
    const bool ahead = (t.points[x].x - a.x) * (b.x - a.x) + (t.points[x].y - a.y) * (b.y - a.y) > 0;
    if (right == 0 && ahead) {
      found.passed = x;
      return true;
    }
    if (y != ghost && right > 0 && orient2d(a, t.points[y], b) < 0) {
      e = EdgeRef(id, corner);
      return true;
    }
    return false;
  });
  while (!e.none()) {
    ask();
    const EdgeRef across = t.slot(e).n[e.side()];
    if (across.constrained()) {
      found.constrained = e;
      return;
    }
    found.edges.push_back(e);
    const VertexId q = t.slot(across).apex(across.side());
    if (q == c.b) return;
    const double side = orient2d(a, b, t.points[q]);
    if (side == 0) {
      found.passed = q;
      return;
    }
    // Seen from the far triangle, `from` lies to the left of the segment and `to` to its right.
    e = EdgeRef(across.triangle(), side > 0 ? next_corner[across.side()] : previous_corner[across.side()]);
  }
}

}  // namespace pardel::engine
