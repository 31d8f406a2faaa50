// Insertion in two steps. Cavity finds the triangles that an insertion destroys, and does not change them.
// retriangulate() replaces them without any test.
//
// The cavity of a point p is the set of triangles whose open circumdisk contains p and that are reached from a first
// such triangle without crossing a constrained edge (Bowyer 1981, Watson 1981; the paper's C_M(p)). Its dual graph is a
// tree, because no vertex lies inside the cavity of a point in a Delaunay triangulation. The walk over the cavity
// therefore needs no marks on triangles. It goes counter-clockwise and lists the boundary edges in order.
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
  Pair at;  ///< `at` and `square`: the Corner of `from` that the query returned
  double square;
  VertexId from;
  EdgeRef inner;  ///< the edge as a side of the triangle inside the cavity
  EdgeRef
      outer;  ///< the edge as a side of the triangle outside, with the constrained bit; none() on the domain's boundary
  bool crossed;  ///< used by the walk: the triangle outside belongs to the cavity too

  [[nodiscard]] Corner corner() const { return {at, square}; }
  // Field by field: a copy of the whole object would load several fields at once. This load would wait if the fields
  // have just been stored one by one.
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
  tangled,    ///< the walk met itself; the triangulation is not constrained Delaunay, or the point not on its edge
};

/// The cavity of a point. An object can be used for many points, one after the other; it keeps its memory.
class Cavity {
 public:
  Cavity() { enlarge(64); }

  [[nodiscard]] std::span<const TriangleId> triangles() const { return {triangles_.data(), triangle_count_}; }
  /// One triangle index per boundary edge: first those of the cavity, then new ones from `allocate`.
  template <class Allocate>
  [[nodiscard]] std::span<const TriangleId> triangles_with(const Allocate& allocate) {
    for (std::size_t i = triangle_count_; i < boundary_count_; ++i) triangles_[i] = allocate();
    return {triangles_.data(), boundary_count_};
  }
  [[nodiscard]] std::span<const CavityEdge> boundary() const { return {boundary_.data(), boundary_count_}; }
  /// The vertex where boundary edge i ends.
  [[nodiscard]] VertexId to(std::size_t i) const { return boundary_[i + 1].from; }
  /// The corner where boundary edge i starts. If i is the number of edges, the corner where the last edge ends.
  [[nodiscard]] Corner corner(std::size_t i) const { return boundary_[i].corner(); }
  /// True if a boundary edge is constrained.
  [[nodiscard]] bool touches_constraint() const { return touches_constraint_; }
  /// True if the point splits a constrained edge. The boundary then starts at the end of this edge, and reaches the
  /// start of this edge after left_count() edges.
  [[nodiscard]] bool splits_edge() const { return splits_edge_; }
  [[nodiscard]] std::size_t left_count() const { return left_count_; }
  /// True if the split edge has no triangle on its right. The boundary is then a chain, not a cycle.
  [[nodiscard]] bool open() const { return open_; }

  /// Finds the cavity of the query's point, starting from the triangle `first`. The object holds the cavity only if the
  /// result is Walk::complete. Time: linear in the number of its triangles, times a logarithm if there are 64 or more.
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

  /// The same for a point on the constrained edge e. The triangles at e belong to the cavity without a test.
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

  /// Queries the triangles behind two sides of a triangle: from u to its far corner w, and from w to v.
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
      // With its end, the boundary has at most three entries more than the cavity has triangles; the stack has two
      // more.
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

  /// False if a triangle occurs twice. A walk that meets itself would never end. Therefore the walk calls this function
  /// whenever the number of triangles is a power of two from 64 on.
  [[nodiscard]] bool is_tree() const {
    std::vector<TriangleId> sorted(triangles().begin(), triangles().end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

  // Scratch memory: arrays of one common length. The counts determine how much of them is in use.
  std::vector<TriangleId> triangles_;
  std::vector<CavityEdge> boundary_, stack_;
  std::size_t capacity_ = 0, triangle_count_ = 0, boundary_count_ = 0, left_count_ = 0;
  bool splits_edge_ = false, open_ = false, touches_constraint_ = false;
};

/// Replaces the cavity by a fan of triangles around the new vertex p: one triangle per boundary edge, in the order of
/// the edges, with the corners p, from, to. Returns the ids of the fan: all slots of the cavity, then new ones from
/// `allocate`. Thus every slot of the cavity is reused at once, and gets the new vertex as its first corner. The queues
/// of the refinement rely on this guarantee: see QueuedTriangle (refinement/queued_triangle.hpp).
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
