// Insertion in two steps: finding the cavity decides and changes nothing, retriangulating it changes and
// decides nothing.
//
// The cavity of a point p is the set of triangles that p's insertion destroys: those whose open circumdisk
// contains p, reached from a first one without crossing a constrained edge (Bowyer 1981, Watson 1981; the
// paper's C_M(p)). Its dual graph is a tree, for a Delaunay triangulation loses no vertex by an insertion;
// so it is walked without marks, in counter-clockwise order, and the boundary comes out in order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "../arithmetic/pair.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// A vertex as the point sees it.
struct Corner {
  Pair at{};          ///< relative to the point
  double square = 0;  ///< of the distance
};

/// An edge of the cavity's boundary, from `from` to the next edge's `from`.
struct CavityEdge {
  Pair at;  ///< with `square`, the corner of `from`, as the test that found the cavity gave it
  double square;
  VertexId from;
  EdgeRef inner;  ///< seen from inside the cavity
  EdgeRef outer;  ///< seen from outside, with the constrained bit; none() on the domain's boundary
  bool crossed;   ///< while the walk goes on: the triangle outside belongs to the cavity too

  [[nodiscard]] Corner corner() const { return {at, square}; }
  // Field by field: a processor waits where it loads as a whole what it has just stored in pieces.
  void set(const Corner& start, VertexId v, EdgeRef from_inside, EdgeRef from_outside, bool goes_on) {
    at = start.at;
    square = start.square;
    from = v;
    inner = from_inside;
    outer = from_outside;
    crossed = goes_on;
  }
};

/// Whether the point is in the disks of two triangles. One number, for it stays in a register: who branches on it need
/// not wait for memory.
struct InDisks {
  unsigned bits = 0;

  static InDisks of(bool first, bool second) {
    return {static_cast<unsigned>(first) | static_cast<unsigned>(second) << 1U};
  }
  [[nodiscard]] bool first() const { return (bits & 1) != 0; }
  [[nodiscard]] bool second() const { return (bits & 2) != 0; }
};

/// What a test says of the triangles behind two edges: whether the point is in their disks; and their far corners.
struct Tested {
  InDisks in_disk;
  std::array<Corner, 2> corner;
};

/// A test made of three questions: in_disk(EdgeRef), asked of each triangle by itself, but not of the first, which is
/// taken for granted; corner_of(VertexId) -> Corner; and is_own(VertexId).
template <class InDisk, class CornerOf, class IsOwn>
class EachByItself {
 public:
  EachByItself(const Triangulation& t, const InDisk& in_disk, const CornerOf& corner_of, const IsOwn& is_own)
      : t_(t), in_disk_(in_disk), corner_of_(corner_of), is_own_(is_own) {}

  [[nodiscard]] bool is_own(VertexId v) const { return is_own_(v); }
  [[nodiscard]] Corner corner(VertexId v) const { return corner_of_(v); }
  [[nodiscard]] InDisks first_and_behind(const Slot& /*first*/, const std::array<Corner, 3>& /*corners*/,
                                         EdgeRef behind) const {
    return InDisks::of(true, in_disk_(behind));
  }
  [[nodiscard]] Tested both(Corner /*u*/, Corner /*w*/, Corner /*v*/, EdgeRef right, EdgeRef left) const {
    const auto far = [&](EdgeRef e) { return corner_of_(t_.slot(e).apex(e.side())); };
    return {InDisks::of(in_disk_(right), in_disk_(left)), {far(right), far(left)}};
  }

 private:
  const Triangulation& t_;
  const InDisk& in_disk_;
  const CornerOf& corner_of_;
  const IsOwn& is_own_;
};

/// How the walk over a cavity ended.
enum class Walk : std::uint8_t {
  complete,
  elsewhere,  ///< the point is not in the disk of the first triangle
  foreign,    ///< a triangle of the cavity may not be changed
  tangled,    ///< the walk met itself: where constrained edges are not Delaunay it can run around a free segment
};

class Cavity {
 public:
  Cavity() { enlarge(64); }

  [[nodiscard]] std::span<const TriangleId> triangles() const { return {triangles_.data(), triangle_count_}; }
  /// As many as the boundary has edges: the cavity's own, then from `allocate`.
  template <class Allocate>
  [[nodiscard]] std::span<const TriangleId> triangles_with(const Allocate& allocate) {
    for (std::size_t i = triangle_count_; i < boundary_count_; ++i) triangles_[i] = allocate();
    return {triangles_.data(), boundary_count_};
  }
  [[nodiscard]] std::span<const CavityEdge> boundary() const { return {boundary_.data(), boundary_count_}; }
  /// The end of boundary edge i.
  [[nodiscard]] VertexId to(std::size_t i) const { return boundary_[i + 1].from; }
  /// The corner that edge i starts from; with i the number of edges, the end of the last one.
  [[nodiscard]] Corner corner(std::size_t i) const { return boundary_[i].corner(); }
  /// Some boundary edge is constrained.
  [[nodiscard]] bool touches_constraint() const { return touches_constraint_; }
  /// True where a constrained edge is split. The boundary then starts at the edge's end; its start comes
  /// after left_count() edges.
  [[nodiscard]] bool splits_edge() const { return splits_edge_; }
  [[nodiscard]] std::size_t left_count() const { return left_count_; }
  /// The edge that is split has nothing on its right, so the boundary is a chain and not a cycle.
  [[nodiscard]] bool open() const { return open_; }

  /// The cavity of a point, from the triangle `first`. A Test answers for the point:
  ///   corner(VertexId) -> Corner
  ///   first_and_behind(slot of first, its corners, EdgeRef) -> InDisks, of first and of the triangle behind the
  ///     edge between its first two corners
  ///   both(u, w, v, right, left) -> Tested, of the triangles behind two edges, from u to w and from w to v
  ///   is_own(VertexId) -> may a triangle with this far corner be changed?
  /// Edges are given as seen from the triangle that is asked about. Where a wall is in the way, the triangle on the
  /// near side stands in for what lies behind, and the answer is ignored.
  template <class Test>
  [[nodiscard]] Walk find(const Triangulation& t, TriangleId first, const Test& test) {
    clear();
    const Slot& slot = t.slots[first];
    const std::array<Corner, 3> c{test.corner(slot.v[0]), test.corner(slot.v[1]), test.corner(slot.v[2])};
    const EdgeRef third(first, 2), behind = slot.n[2];
    touches_constraint_ = behind.constrained();
    const InDisks in = test.first_and_behind(slot, c, is_wall(behind) ? third : behind);
    if (!in.first()) return Walk::elsewhere;
    stack_[0].set(c[1], slot.v[1], {}, {}, false);
    stack_[1].set(c[0], slot.v[0], third, behind, in.second() && !is_wall(behind));
    return grow(t, third, c[1], c[2], 2, test);
  }

  /// The cavity of a point on the constrained edge e.
  template <class Test>
  [[nodiscard]] Walk find_on_edge(const Triangulation& t, EdgeRef e, const Test& test) {
    clear();
    splits_edge_ = true;
    const EdgeRef other = t.slot(e).n[e.side()];
    open_ = other.none();
    Walk walk = grow_from_side(t, e, test);
    left_count_ = boundary_count_;
    if (open_ || walk != Walk::complete) return walk;
    walk = grow_from_side(t, other, test);
    return walk == Walk::complete && !is_tree() ? Walk::tangled : walk;
  }

 private:
  void clear() {
    triangle_count_ = boundary_count_ = left_count_ = 0;
    splits_edge_ = open_ = touches_constraint_ = false;
  }
  [[gnu::noinline]] void enlarge(std::size_t n) {
    triangles_.resize(n);
    boundary_.resize(n);
    stack_.resize(n);
    capacity_ = n;
  }
  [[nodiscard]] static bool is_wall(EdgeRef outer) { return outer.constrained(); }

  /// Of what lies behind two sides of a triangle that has come up between u and v with the far corner w.
  template <class Test>
  [[nodiscard]] Tested test_both(Corner u, Corner w, Corner v, const Slot& slot, EdgeRef right, EdgeRef left,
                                 const Test& test) {
    const EdgeRef behind_right = slot.n[right.side()], behind_left = slot.n[left.side()];
    if (!behind_right.constrained() && !behind_left.constrained()) [[likely]]
      return test.both(u, w, v, behind_right, behind_left);
    touches_constraint_ = true;
    Tested tested =
        test.both(u, w, v, is_wall(behind_right) ? right : behind_right, is_wall(behind_left) ? left : behind_left);
    tested.in_disk =
        InDisks::of(tested.in_disk.first() && !is_wall(behind_right), tested.in_disk.second() && !is_wall(behind_left));
    return tested;
  }

  template <class Test>
  Walk grow_from_side(const Triangulation& t, EdgeRef e, const Test& test) {
    const Slot& slot = t.slot(e);
    stack_[0].set(test.corner(slot.from(e.side())), slot.from(e.side()), {}, {}, false);
    return grow(t, e, test.corner(slot.to(e.side())), test.corner(slot.apex(e.side())), 1, test);
  }

  /// Counter-clockwise from the triangle of `entry`, as if come in by that side, which runs, as seen from inside, from
  /// `start` to the corner on top of the stack; `far` is the triangle's far corner. At the bottom of the stack is where
  /// the boundary ends.
  template <class Test>
  Walk grow(const Triangulation& t, EdgeRef entry, const Corner& start, const Corner& far, std::size_t top,
            const Test& test) {
    std::size_t count = triangle_count_, edges = boundary_count_;
    Corner u = start, w = far;
    for (;;) {
      const TriangleId id = entry.triangle();
      const Slot& slot = t.slots[id];
      if (!test.is_own(slot.apex(entry.side()))) return ended(Walk::foreign, count, edges);
      // The boundary, with its end, never holds more than three entries above the number of triangles, the stack two.
      if (count + 4 > capacity_) [[unlikely]]
        enlarge(2 * capacity_);
      triangles_[count++] = id;
      if (count >= 64 && std::has_single_bit(count)) [[unlikely]] {
        triangle_count_ = count;
        if (!is_tree()) return ended(Walk::tangled, count, edges);
      }
      const unsigned right = next_corner[entry.side()], left = previous_corner[entry.side()];
      const EdgeRef on_right(id, right), across_right = slot.n[right], on_left(id, left), across_left = slot.n[left];
      const Tested tested = test_both(u, w, stack_[top - 1].corner(), slot, on_right, on_left, test);
      if (tested.in_disk.first()) {
        stack_[top++].set(w, slot.apex(entry.side()), on_left, across_left, tested.in_disk.second());
        entry = across_right;
        w = tested.corner[0];
        continue;
      }
      boundary_[edges++].set(u, slot.to(entry.side()), on_right, across_right, false);
      if (tested.in_disk.second()) {
        u = w;
        entry = across_left;
        w = tested.corner[1];
        continue;
      }
      boundary_[edges++].set(w, slot.apex(entry.side()), on_left, across_left, false);
      for (--top; top > 0 && !stack_[top].crossed; --top) {
        const CavityEdge& e = stack_[top];
        boundary_[edges++].set(e.corner(), e.from, e.inner, e.outer, false);
      }
      if (top == 0) return ended(Walk::complete, count, edges);
      u = stack_[top].corner();
      entry = stack_[top].outer;
      w = test.corner(t.slot(entry).apex(entry.side()));
    }
  }

  Walk ended(Walk how, std::size_t triangles, std::size_t edges) {
    triangle_count_ = triangles;
    boundary_count_ = edges;
    const CavityEdge& end = stack_[0];
    boundary_[edges].set(end.corner(), end.from, {}, {}, false);
    return how;
  }

  /// A walk that meets itself would go on for ever; it is caught here, at sizes that are powers of two.
  [[nodiscard]] bool is_tree() const {
    std::vector<TriangleId> sorted(triangles().begin(), triangles().end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

  // Scratch of one common length; the counts say how much of it is in use.
  std::vector<TriangleId> triangles_;
  std::vector<CavityEdge> boundary_, stack_;
  std::size_t capacity_ = 0, triangle_count_ = 0, boundary_count_ = 0, left_count_ = 0;
  bool splits_edge_ = false, open_ = false, touches_constraint_ = false;
};

/// Replaces the cavity by the fan of triangles around vertex p: one per boundary edge, in their order, with
/// corners p, from, to. Returns their ids: the cavity's own, reused, then fresh ones from `allocate`.
template <class Allocate>
std::span<const TriangleId> retriangulate(Triangulation& t, Cavity& cavity, VertexId p, const Allocate& allocate) {
  const auto boundary = cavity.boundary();
  const std::size_t n = boundary.size();
  const std::span<const TriangleId> fan = cavity.triangles_with(allocate);

  TriangleId after = fan[0];
  VertexId to = cavity.to(n - 1);
  for (std::size_t i = n; i-- > 0;) {
    const VertexId from = boundary[i].from;
    const EdgeRef outer = boundary[i].outer;
    const TriangleId here = fan[i], before = fan[i > 0 ? i - 1 : n - 1];
    t.slots[here] = {{p, from, to}, {outer, EdgeRef(after, 2), EdgeRef(before, 1)}};
    if (!outer.none()) t.slots[outer.triangle()].n[outer.side()] = EdgeRef(here, 0, outer.constrained());
    after = here;
    to = from;
  }
  if (cavity.open()) {
    t.slots[fan[0]].n[2] = EdgeRef();
    t.slots[fan[n - 1]].n[1] = EdgeRef();
  } else if (cavity.splits_edge()) {
    t.constrain(EdgeRef(fan[0], 2));
    t.constrain(EdgeRef(fan[cavity.left_count()], 2));
  }
  if (!t.region.empty()) {
    const Index left = t.region[cavity.triangles().front()], right = t.region[cavity.triangles().back()];
    for (std::size_t i = 0; i < n; ++i)
      t.region[fan[i]] = !cavity.splits_edge() || i < cavity.left_count() ? left : right;
  }
  return fan;
}

}  // namespace pardel::engine
