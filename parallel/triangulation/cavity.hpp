// Insertion in two steps: Cavity finds the triangles that an insertion destroys and changes nothing; retriangulate()
// replaces them and decides nothing.
//
// The cavity of a point p is the set of triangles whose open circumdisk contains p and that are reached from a first
// such triangle without crossing a constrained edge (Bowyer 1981, Watson 1981; the paper's C_M(p)). Its dual graph is a
// tree, because an insertion into a Delaunay triangulation leaves no vertex inside the cavity. The walk therefore needs
// no marks on triangles. It goes counter-clockwise, and yields the boundary in order.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include "cavity_query.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// An edge of the cavity's boundary. It runs from `from` to the next edge's `from`.
struct CavityEdge {
  Pair at;  ///< with `square`, the corner of `from`, as the query returned it
  double square;
  VertexId from;
  EdgeRef inner;  ///< the edge as a side of the triangle inside the cavity
  EdgeRef
      outer;  ///< the edge as a side of the triangle outside, with the constrained bit; none() on the domain's boundary
  bool crossed;  ///< used by the walk: the triangle outside belongs to the cavity too

  [[nodiscard]] Corner corner() const { return {at, square}; }
  // Field by field: a copy of the whole object loads several fields at once, and that load waits where they have just
  // been stored one by one.
  void set(const Corner& start, VertexId v, EdgeRef from_inside, EdgeRef from_outside, bool goes_on) {
    at = start.at;
    square = start.square;
    from = v;
    inner = from_inside;
    outer = from_outside;
    crossed = goes_on;
  }
};

/// How the walk over a cavity ended.
enum class Walk : std::uint8_t {
  complete,
  elsewhere,  ///< the point does not lie in the disk of the first triangle
  foreign,    ///< a triangle of the cavity may not be changed
  tangled,    ///< the walk met itself: where a constrained edge is not Delaunay, it can run around the edge's ends
};

/// The cavity of a point. An object can be used again for other points; it keeps its memory.
class Cavity {
 public:
  Cavity() { enlarge(64); }

  [[nodiscard]] std::span<const TriangleId> triangles() const { return {triangles_.data(), triangle_count_}; }
  /// As many triangles as the boundary has edges: those of the cavity, then new ones from `allocate`.
  template <class Allocate>
  [[nodiscard]] std::span<const TriangleId> triangles_with(const Allocate& allocate) {
    for (std::size_t i = triangle_count_; i < boundary_count_; ++i) triangles_[i] = allocate();
    return {triangles_.data(), boundary_count_};
  }
  [[nodiscard]] std::span<const CavityEdge> boundary() const { return {boundary_.data(), boundary_count_}; }
  /// The vertex where boundary edge i ends.
  [[nodiscard]] VertexId to(std::size_t i) const { return boundary_[i + 1].from; }
  /// The corner where boundary edge i starts. Where i is the number of edges, the corner where the last one ends.
  [[nodiscard]] Corner corner(std::size_t i) const { return boundary_[i].corner(); }
  /// True where a boundary edge is constrained.
  [[nodiscard]] bool touches_constraint() const { return touches_constraint_; }
  /// True where a constrained edge is split. The boundary then starts at the end of that edge, and reaches the start of
  /// that edge after left_count() edges.
  [[nodiscard]] bool splits_edge() const { return splits_edge_; }
  [[nodiscard]] std::size_t left_count() const { return left_count_; }
  /// True where the edge that is split has no triangle on its right. The boundary is then a chain, not a cycle.
  [[nodiscard]] bool open() const { return open_; }

  /// Finds the cavity of the query's point, starting from the triangle `first`. The cavity is as described only where
  /// the result is Walk::complete. Linear in the number of its triangles, up to a logarithm in a cavity of 64 or more.
  template <CavityQuery Query>
  [[nodiscard]] Walk find(const Triangulation& t, TriangleId first, const Query& query) {
    clear();
    const Slot& slot = t.slots[first];
    const std::array<Corner, 3> c{query.corner(slot.v[0]), query.corner(slot.v[1]), query.corner(slot.v[2])};
    const EdgeRef third(first, 2), behind = slot.n[2];
    touches_constraint_ = behind.constrained();
    const InDisks in = query.first_and_behind(slot, c, is_wall(behind) ? third : behind);
    if (!in.first()) return Walk::elsewhere;
    stack_[0].set(c[1], slot.v[1], {}, {}, false);
    stack_[1].set(c[0], slot.v[0], third, behind, in.second() && !is_wall(behind));
    return grow(t, third, c[1], c[2], 2, query);
  }

  /// The same for a point on the constrained edge e. The triangles at e belong to the cavity without a query.
  template <CavityQuery Query>
  [[nodiscard]] Walk find_on_edge(const Triangulation& t, EdgeRef e, const Query& query) {
    clear();
    splits_edge_ = true;
    const EdgeRef other = t.slot(e).n[e.side()];
    open_ = other.none();
    Walk walk = grow_from_side(t, e, query);
    left_count_ = boundary_count_;
    if (open_ || walk != Walk::complete) return walk;
    walk = grow_from_side(t, other, query);
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
  /// The walk does not cross constrained edges.
  [[nodiscard]] static bool is_wall(EdgeRef outer) { return outer.constrained(); }

  /// Asks about the triangles behind two sides of a triangle: from u to its far corner w, and from w to v.
  template <CavityQuery Query>
  [[nodiscard]] DisksAndCorners query_both(Corner u, Corner w, Corner v, const Slot& slot, EdgeRef right, EdgeRef left,
                                           const Query& query) {
    const EdgeRef behind_right = slot.n[right.side()], behind_left = slot.n[left.side()];
    if (!behind_right.constrained() && !behind_left.constrained()) [[likely]]
      return query.both(u, w, v, behind_right, behind_left);
    touches_constraint_ = true;
    DisksAndCorners answer =
        query.both(u, w, v, is_wall(behind_right) ? right : behind_right, is_wall(behind_left) ? left : behind_left);
    answer.in_disk =
        InDisks::of(answer.in_disk.first() && !is_wall(behind_right), answer.in_disk.second() && !is_wall(behind_left));
    return answer;
  }

  template <CavityQuery Query>
  Walk grow_from_side(const Triangulation& t, EdgeRef e, const Query& query) {
    const Slot& slot = t.slot(e);
    stack_[0].set(query.corner(slot.from(e.side())), slot.from(e.side()), {}, {}, false);
    return grow(t, e, query.corner(slot.to(e.side())), query.corner(slot.apex(e.side())), 1, query);
  }

  /// Walks counter-clockwise from the triangle of `entry`, as if the walk had entered it through that side. Seen from
  /// inside the triangle, the side runs from `start` to the corner on top of the stack; `far` is the triangle's far
  /// corner. The bottom of the stack is the vertex where the boundary ends.
  template <CavityQuery Query>
  Walk grow(const Triangulation& t, EdgeRef entry, const Corner& start, const Corner& far, std::size_t top,
            const Query& query) {
    std::size_t count = triangle_count_, edges = boundary_count_;
    Corner u = start, w = far;
    for (;;) {
      const TriangleId id = entry.triangle();
      const Slot& slot = t.slots[id];
      if (!query.is_own(slot.apex(entry.side()))) return ended(Walk::foreign, count, edges);
      // With its end, the boundary has at most three entries more than the cavity has triangles, the stack two.
      if (count + 4 > capacity_) [[unlikely]]
        enlarge(2 * capacity_);
      triangles_[count++] = id;
      if (count >= 64 && std::has_single_bit(count)) [[unlikely]] {
        triangle_count_ = count;
        if (!is_tree()) return ended(Walk::tangled, count, edges);
      }
      const unsigned right = next_corner[entry.side()], left = previous_corner[entry.side()];
      const EdgeRef on_right(id, right), across_right = slot.n[right], on_left(id, left), across_left = slot.n[left];
      const DisksAndCorners answer = query_both(u, w, stack_[top - 1].corner(), slot, on_right, on_left, query);
      if (answer.in_disk.first()) {
        stack_[top++].set(w, slot.apex(entry.side()), on_left, across_left, answer.in_disk.second());
        entry = across_right;
        w = answer.corner[0];
        continue;
      }
      boundary_[edges++].set(u, slot.to(entry.side()), on_right, across_right, false);
      if (answer.in_disk.second()) {
        u = w;
        entry = across_left;
        w = answer.corner[1];
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
      w = query.corner(t.slot(entry).apex(entry.side()));
    }
  }

  Walk ended(Walk how, std::size_t triangles, std::size_t edges) {
    triangle_count_ = triangles;
    boundary_count_ = edges;
    const CavityEdge& end = stack_[0];
    boundary_[edges].set(end.corner(), end.from, {}, {}, false);
    return how;
  }

  /// False where a triangle occurs twice. A walk that meets itself would never end. It is detected here: the walk asks
  /// whenever the number of triangles is a power of two from 64 on.
  [[nodiscard]] bool is_tree() const {
    std::vector<TriangleId> sorted(triangles().begin(), triangles().end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

  // Scratch memory of one common length. The counts tell how much of it is in use.
  std::vector<TriangleId> triangles_;
  std::vector<CavityEdge> boundary_, stack_;
  std::size_t capacity_ = 0, triangle_count_ = 0, boundary_count_ = 0, left_count_ = 0;
  bool splits_edge_ = false, open_ = false, touches_constraint_ = false;
};

/// Replaces the cavity by a fan of triangles around the new vertex p: one per boundary edge, in their order, with the
/// corners p, from, to. Returns their ids: all slots of the cavity, then new ones from `allocate`. Thus every slot of
/// the cavity is reused at once, and gets the new vertex as its first corner. The queues of the refinement rely on
/// this guarantee: see QueuedTriangle (refinement/queued_triangle.hpp).
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
