// Insertion in two steps: finding the cavity decides and changes nothing, retriangulating it changes and
// decides nothing.
//
// The cavity of a point p is the set of triangles that p's insertion destroys: those whose open circumdisk
// contains p, reached from a first one without crossing a constrained edge (Bowyer 1981, Watson 1981; the
// paper's C_M(p)). Its dual graph is a tree, for a Delaunay triangulation loses no vertex by an insertion;
// so it is walked without marks, in counter-clockwise order, and the boundary comes out in order.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include "../core/mutants.hpp"
#include "triangulation.hpp"

namespace pardel {

/// An edge of the cavity's boundary, from `from` to the next edge's `from`.
struct CavityEdge {
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
  Cavity() { enlarge(64); }

  [[nodiscard]] std::span<const TriangleId> triangles() const { return {triangles_.data(), triangle_count_}; }
  [[nodiscard]] std::span<const CavityEdge> boundary() const { return {boundary_.data(), boundary_count_}; }
  /// The end of boundary edge i.
  [[nodiscard]] VertexId to(std::size_t i) const {
    return i + 1 < boundary_count_ ? boundary_[i + 1].from : open_ ? end_ : boundary_[0].from;
  }
  /// Some boundary edge is constrained.
  [[nodiscard]] bool touches_constraint() const { return touches_constraint_; }
  /// True where a constrained edge is split. The boundary then starts at the edge's end; its start comes
  /// after left_count() edges.
  [[nodiscard]] bool splits_edge() const { return splits_edge_; }
  [[nodiscard]] std::size_t left_count() const { return left_count_; }
  /// The edge that is split has nothing on its right, so the boundary is a chain and not a cycle.
  [[nodiscard]] bool open() const { return open_; }

  /// The cavity of a point whose disk test is reach(TriangleId, apex corner) -> Reach, from `first`, which
  /// is in it. A foreign triangle ends the walk.
  template <class ReachOf>
  [[nodiscard]] Walk find(const Triangulation& t, TriangleId first, const ReachOf& reach) {
    clear();
    add(first);
    stack_[0] = EdgeRef(first, 2);
    stack_[1] = EdgeRef(first, 1);
    stack_[2] = EdgeRef(first, 0);
    return grow(t, 3, reach);
  }

  /// The cavity of a point on the constrained edge e.
  template <class ReachOf>
  [[nodiscard]] Walk find_on_edge(const Triangulation& t, EdgeRef e, const ReachOf& reach) {
    clear();
    splits_edge_ = true;
    end_ = t.slot(e).from(e.side());
    const EdgeRef other = t.slot(e).n[e.side()];
    open_ = other.none();
    Walk walk = grow_from_side(t, e, reach);
    left_count_ = boundary_count_;
    if (open_ || walk != Walk::complete) return walk;
    walk = grow_from_side(t, other, reach);
    return walk == Walk::complete && !is_tree() ? Walk::tangled : walk;
  }

 private:
  void clear() {
    triangle_count_ = boundary_count_ = left_count_ = 0;
    splits_edge_ = open_ = touches_constraint_ = false;
  }
  void add(TriangleId id) {
    // The boundary and the stack never hold more than two entries above the number of triangles.
    if (triangle_count_ + 4 > triangles_.size()) [[unlikely]]
      enlarge(2 * triangles_.size());
    triangles_[triangle_count_++] = id;
  }
  [[gnu::noinline]] void enlarge(std::size_t n) {
    triangles_.resize(n);
    boundary_.resize(n);
    stack_.resize(n);
  }

  template <class ReachOf>
  Walk grow_from_side(const Triangulation& t, EdgeRef e, const ReachOf& reach) {
    add(e.triangle());
    stack_[0] = EdgeRef(e.triangle(), previous_corner[e.side()]);
    stack_[1] = EdgeRef(e.triangle(), next_corner[e.side()]);
    return grow(t, 2, reach);
  }

  template <class ReachOf>
  Walk grow(const Triangulation& t, std::size_t top, const ReachOf& reach) {
    while (top > 0) {
      const EdgeRef inner = stack_[--top];
      const Slot& slot = t.slots[inner.triangle()];
      const EdgeRef outer = slot.n[inner.side()];
      touches_constraint_ = touches_constraint_ || outer.constrained();
      const Reach r = outer.constrained() && !(mutated("cavity_crosses_constraints") && !outer.none())
                          ? Reach::outside
                          : reach(outer.triangle(), outer.side());
      if (r == Reach::outside || (mutated("cavity_cut_short") && triangle_count_ == 4)) {
        boundary_[boundary_count_++] = {slot.from(inner.side()), inner, outer};
      } else if (r == Reach::inside) {
        add(outer.triangle());
        stack_[top++] = EdgeRef(outer.triangle(), previous_corner[outer.side()]);
        stack_[top++] = EdgeRef(outer.triangle(), next_corner[outer.side()]);
        if (triangle_count_ >= 64 && std::has_single_bit(triangle_count_) && !is_tree()) return Walk::tangled;
      } else {
        return Walk::foreign;
      }
    }
    return Walk::complete;
  }

  /// A walk that meets itself would go on for ever; it is caught here, at sizes that are powers of two.
  [[nodiscard]] bool is_tree() const {
    std::vector<TriangleId> sorted(triangles().begin(), triangles().end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

  // Scratch of one common length; the counts say how much of it is in use.
  std::vector<TriangleId> triangles_;
  std::vector<CavityEdge> boundary_;
  std::vector<EdgeRef> stack_;
  std::size_t triangle_count_ = 0, boundary_count_ = 0, left_count_ = 0;
  bool splits_edge_ = false, open_ = false, touches_constraint_ = false;
  VertexId end_ = no_index;
};

/// Replaces the cavity by the fan of triangles around vertex p: one per boundary edge, in their order, with
/// corners p, from, to. `fan` receives their ids: the cavity's own, reused, then fresh ones from `allocate`.
template <class Allocate>
void retriangulate(Triangulation& t, const Cavity& cavity, VertexId p, const Allocate& allocate,
                   std::vector<TriangleId>& fan) {
  const auto boundary = cavity.boundary();
  const std::size_t n = boundary.size(), old = cavity.triangles().size();
  fan.resize(n);
  std::copy_n(cavity.triangles().begin(), std::min(n, old), fan.begin());  // never fewer new ones than old ones
  for (std::size_t i = old; i < n; ++i) fan[i] = allocate();

  TriangleId after = fan[0];
  VertexId to = cavity.to(n - 1);
  for (std::size_t i = n; i-- > 0;) {
    const auto [from, inner, outer] = boundary[i];
    const TriangleId here = fan[i], before = fan[i > 0 ? i - 1 : n - 1];
    t.slots[here] = {{p, from, to}, {outer, EdgeRef(after, 2), EdgeRef(before, 1)}};
    if (!mutated("neighbour_link_dropped") && !outer.none())
      t.slots[outer.triangle()].n[outer.side()] = EdgeRef(here, 0, outer.constrained());
    after = here;
    to = from;
  }
  if (cavity.open()) {
    t.slots[fan[0]].n[2] = EdgeRef();
    t.slots[fan[n - 1]].n[1] = EdgeRef();
  } else if (cavity.splits_edge() && !mutated("halves_of_a_split_not_constrained")) {
    t.constrain(EdgeRef(fan[0], 2));
    t.constrain(EdgeRef(fan[cavity.left_count()], 2));
  }
  if (!t.region.empty()) {
    const Index left = t.region[cavity.triangles().front()], right = t.region[cavity.triangles().back()];
    for (std::size_t i = 0; i < n; ++i)
      t.region[fan[i]] =
          !cavity.splits_edge() || i < cavity.left_count() || mutated("both_sides_of_a_split_in_one_region") ? left
                                                                                                             : right;
  }
}

}  // namespace pardel
