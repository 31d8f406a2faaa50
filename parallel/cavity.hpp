// Insertion in two steps: find_cavity decides and changes nothing, retriangulate changes and decides nothing.
//
// The cavity of a point p is the set of triangles that p's insertion destroys: those whose open circumdisk
// contains p, reached from a first one without crossing a constrained edge (Bowyer 1981, Watson 1981; the
// paper's C_M(p)). Its dual graph is a tree, for a Delaunay triangulation loses no vertex by an insertion;
// so it is walked without marks, in counter-clockwise order, and the boundary comes out in order.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "triangulation.hpp"

namespace pardel {

/// An edge of the cavity's boundary, from `from` to the next edge's `from`.
struct BoundaryEdge {
  VertexId from;
  EdgeRef inner;  ///< seen from inside the cavity
  EdgeRef outer;  ///< seen from outside, with the constrained bit; none() on the domain's boundary
};

/// What a triangle next to the cavity is to the point.
enum class Reach : std::uint8_t { outside, inside, foreign };

/// How the walk over a cavity ended. `tangled`: in a constrained triangulation whose constrained edges are
/// not Delaunay, the walk can run around a free segment and meet itself.
enum class Walk : std::uint8_t { complete, foreign, tangled };

class Cavity {
 public:
  std::vector<TriangleId> triangles;
  std::vector<BoundaryEdge> boundary;
  /// Set where a constrained edge is split: the boundary starts at its end, and boundary[left_count] (or
  /// `end`, when the edge has no right side) is its start.
  std::size_t left_count = 0;
  bool splits_edge = false;
  bool open = false;
  VertexId end = no_index;

  void clear() {
    triangles.clear();
    boundary.clear();
    left_count = 0;
    splits_edge = open = false;
  }
  [[nodiscard]] VertexId to(std::size_t i) const {
    return i + 1 < boundary.size() ? boundary[i + 1].from : open ? end : boundary[0].from;
  }

  /// The cavity of a point whose disk test is reach(TriangleId, apex corner) -> Reach, from `first`, which
  /// is in it. A foreign triangle ends the walk.
  template <class ReachOf>
  [[nodiscard]] Walk find(const Triangulation& t, TriangleId first, const ReachOf& reach) {
    clear();
    triangles.push_back(first);
    stack_.assign({EdgeRef(first, 2), EdgeRef(first, 1), EdgeRef(first, 0)});
    return grow(t, reach);
  }

  /// The cavity of a point on the constrained edge e.
  template <class ReachOf>
  [[nodiscard]] Walk find_on_edge(const Triangulation& t, EdgeRef e, const ReachOf& reach) {
    clear();
    splits_edge = true;
    end = t.slot(e).from(e.side());
    const EdgeRef other = t.slot(e).n[e.side()];
    open = other.none();
    Walk walk = grow_from_side(t, e, reach);
    left_count = boundary.size();
    if (open || walk != Walk::complete) return walk;
    walk = grow_from_side(t, other, reach);
    return walk == Walk::complete && !is_tree() ? Walk::tangled : walk;
  }

 private:
  template <class ReachOf>
  Walk grow_from_side(const Triangulation& t, EdgeRef e, const ReachOf& reach) {
    triangles.push_back(e.triangle());
    stack_.assign({EdgeRef(e.triangle(), previous_corner[e.side()]), EdgeRef(e.triangle(), next_corner[e.side()])});
    return grow(t, reach);
  }

  template <class ReachOf>
  Walk grow(const Triangulation& t, const ReachOf& reach) {
    while (!stack_.empty()) {
      const EdgeRef inner = stack_.back();
      stack_.pop_back();
      const Slot& slot = t.slots[inner.triangle()];
      const EdgeRef outer = slot.n[inner.side()];
      if (!outer.constrained()) {
        const Reach r = reach(outer.triangle(), outer.side());
        if (r == Reach::foreign) return Walk::foreign;
        if (r == Reach::inside) {
          triangles.push_back(outer.triangle());
          stack_.push_back(EdgeRef(outer.triangle(), previous_corner[outer.side()]));
          stack_.push_back(EdgeRef(outer.triangle(), next_corner[outer.side()]));
          if (triangles.size() >= 64 && std::has_single_bit(triangles.size()) && !is_tree()) return Walk::tangled;
          continue;
        }
      }
      boundary.push_back({slot.from(inner.side()), inner, outer});
    }
    return Walk::complete;
  }

  /// A walk that meets itself would go on for ever; it is caught here, at sizes that are powers of two.
  bool is_tree() {
    sorted_ = triangles;
    std::sort(sorted_.begin(), sorted_.end());
    return std::adjacent_find(sorted_.begin(), sorted_.end()) == sorted_.end();
  }

  std::vector<EdgeRef> stack_;
  std::vector<TriangleId> sorted_;
};

/// Replaces the cavity by the fan of triangles around vertex p; corner 0 of each is p. `fan` receives their
/// ids: the cavity's own, reused, then fresh ones from `allocate`.
template <class Allocate>
void retriangulate(Triangulation& t, const Cavity& cavity, VertexId p, const Allocate& allocate,
                   std::vector<TriangleId>& fan) {
  const std::size_t n = cavity.boundary.size();
  Index left_region = no_index, right_region = no_index;
  if (!t.region.empty()) {
    left_region = t.region[cavity.triangles.front()];
    right_region = t.region[cavity.triangles.back()];
  }
  fan = cavity.triangles;  // an insertion never makes fewer triangles than it destroys
  while (fan.size() < n) fan.push_back(allocate());

  const auto spoke_constrained = [&](std::size_t i) {
    return cavity.splits_edge && (i == 0 || i == cavity.left_count);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const EdgeRef outer = cavity.boundary[i].outer;
    const std::size_t after = i + 1 < n ? i + 1 : 0;
    const std::size_t before = i > 0 ? i - 1 : n - 1;
    Slot& slot = t.slots[fan[i]];
    slot.v = {p, cavity.boundary[i].from, cavity.to(i)};
    slot.n[0] = outer;
    slot.n[1] = cavity.open && i + 1 == n ? EdgeRef() : EdgeRef(fan[after], 2, spoke_constrained(after));
    slot.n[2] = cavity.open && i == 0 ? EdgeRef() : EdgeRef(fan[before], 1, spoke_constrained(i));
    if (!outer.none()) t.slots[outer.triangle()].n[outer.side()] = EdgeRef(fan[i], 0, outer.constrained());
    if (!t.region.empty()) t.region[fan[i]] = !cavity.splits_edge || i < cavity.left_count ? left_region : right_region;
  }
}

}  // namespace pardel
