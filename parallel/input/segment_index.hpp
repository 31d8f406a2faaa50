// A hierarchy of bounding boxes of segments. It finds the segments near a box or a point, and the segment below a
// point. The segments are sorted along a Hilbert curve, and eight consecutive boxes of one level form a box of the next
// level.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"
#include "../arithmetic/box.hpp"

namespace pardel::engine {

/// Keeps references to the points and the segments, which must not change. Preconditions: indices are valid, and
/// coordinates are in the range of the predicates. Construction takes O(n log n).
class SegmentIndex {
 public:
  SegmentIndex(std::span<const Point> points, std::span<const Segment> segments);

  /// Calls visit(segment) for every segment whose bounding box meets `box`, until visit returns false. Returns false if
  /// visit returned false.
  template <class Visit>
  bool for_each_near(const Box& box, const Visit& visit) const {
    return levels_.empty() ||
           descend({levels_.size() - 1, 0}, box, [&](std::size_t slot) { return visit(order_[slot]); });
  }

  /// Calls visit(s, t) once for every pair of segments whose bounding boxes meet, until visit returns false.
  template <class Visit>
  void for_each_near_pair(const Visit& visit) const;

  /// A segment that contains p, possibly as an end; no_index if there is none.
  [[nodiscard]] Index through(Point p) const;

  /// The first segment that a ray from p straight down meets; no_index if there is none. The ray is moved to the
  /// left by an infinitesimal amount: it meets segments whose right end is on the vertical through p, and misses
  /// segments whose left end is there. Preconditions: p is not on a segment, and segments meet only at their ends.
  [[nodiscard]] Index below(Point p) const;

 private:
  static constexpr std::size_t fan = 8;
  /// Level 0 consists of the boxes of single segments.
  struct Node {
    std::size_t level, index;
  };
  /// The nodes to visit in a depth-first walk: `fan` nodes at each of at most 11 levels (8^11 > 2^32).
  using Stack = std::array<Node, fan * 11>;

  [[nodiscard]] const Box& bounds(Node node) const { return levels_[node.level][node.index]; }
  [[nodiscard]] std::size_t end_of_children(Node node) const {
    return std::min((node.index + 1) * fan, levels_[node.level - 1].size());
  }
  [[nodiscard]] bool is_below(Index segment, Point p) const;
  [[nodiscard]] bool is_higher(Index segment, Index than) const;
  [[nodiscard]] double least_height(Index segment, double x) const;

  template <class Visit>
  bool descend(Node top, const Box& box, const Visit& visit_slot) const;

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  Array<Index> order_;
  std::vector<std::vector<Box>> levels_;
};

template <class Visit>
bool SegmentIndex::descend(Node top, const Box& box, const Visit& visit_slot) const {
  Stack stack;
  std::size_t waiting = 0;
  if (bounds(top).intersects_closed(box)) stack[waiting++] = top;
  while (waiting > 0) {
    const Node node = stack[--waiting];
    if (node.level == 0) {
      if (!visit_slot(node.index)) return false;
      continue;
    }
    for (std::size_t child = end_of_children(node); child-- > node.index * fan;)
      if (levels_[node.level - 1][child].intersects_closed(box)) stack[waiting++] = {node.level - 1, child};
  }
  return true;
}

template <class Visit>
void SegmentIndex::for_each_near_pair(const Visit& visit) const {
  for (std::size_t slot = 0; slot < order_.size(); ++slot) {
    const Box box = levels_[0][slot];
    const auto visit_pair = [&](std::size_t other) { return visit(order_[slot], order_[other]); };
    // The later slots are below the later siblings of this slot and of every node above it.
    std::size_t index = slot;
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level, index /= fan)
      for (std::size_t sibling = index + 1; sibling < end_of_children({level + 1, index / fan}); ++sibling)
        if (!descend({level, sibling}, box, visit_pair)) return;
  }
}

}  // namespace pardel::engine
