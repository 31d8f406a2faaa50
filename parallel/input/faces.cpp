#include "faces.hpp"

#include <algorithm>
#include <numeric>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

using HalfEdge = Index;

HalfEdge twin(HalfEdge h) { return h ^ 1U; }
Index origin(std::span<const Segment> segments, HalfEdge h) {
  return (h & 1U) != 0 ? segments[h / 2].b : segments[h / 2].a;
}

/// The half-edges around each vertex, in counter-clockwise order, beginning just after the direction straight down.
struct Rotation {
  /// For each half-edge the next half-edge along the face to its left.
  std::vector<HalfEdge> next;
  /// True for the last half-edge around a vertex that has no half-edge towards the left. The face to the left of this
  /// half-edge is the face immediately to the left of the vertex.
  std::vector<bool> guards_left;
};

Rotation rotation(std::span<const Point> points, std::span<const Segment> segments) {
  std::vector<HalfEdge> around(2 * segments.size());
  std::iota(around.begin(), around.end(), HalfEdge{0});
  const auto goes_left = [&](HalfEdge h) {
    return lexicographically_less(points[origin(segments, twin(h))], points[origin(segments, h)]);
  };
  std::ranges::sort(around, [&](HalfEdge g, HalfEdge h) {
    const Index at = origin(segments, g);
    if (at != origin(segments, h)) return at < origin(segments, h);
    if (goes_left(g) != goes_left(h)) return goes_left(h);
    return orient2d(points[at], points[origin(segments, twin(g))], points[origin(segments, twin(h))]) > 0;
  });

  Rotation result{std::vector<HalfEdge>(around.size()), std::vector<bool>(around.size())};
  for (std::size_t begin = 0, end = 0; begin < around.size(); begin = end) {
    while (end < around.size() && origin(segments, around[end]) == origin(segments, around[begin])) ++end;
    result.guards_left[around[end - 1]] = !goes_left(around[end - 1]);
    for (std::size_t i = begin; i < end; ++i) result.next[twin(around[i])] = around[(i == begin ? end : i) - 1];
  }
  return result;
}

/// A closed walk along half-edges with one face to the left.
struct Cycle {
  Index leftmost;   ///< the lexicographically smallest vertex
  bool is_outside;  ///< the walk follows the outside of a component; otherwise it follows the inside of a face
};

}  // namespace

Faces::Faces(std::span<const Point> points, std::span<const Segment> segments, const SegmentIndex& index)
    : points_(points), segments_(segments), index_(index), face_(2 * segments.size()) {
  const Rotation around = rotation(points, segments);
  std::vector<Cycle> cycles;
  std::vector<Index> cycle_of(face_.size(), no_index);
  for (HalfEdge first = 0; first < cycle_of.size(); ++first) {
    if (cycle_of[first] != no_index) continue;
    Cycle cycle{origin(segments, first), false};
    HalfEdge h = first;
    do {
      cycle_of[h] = static_cast<Index>(cycles.size());
      const Index v = origin(segments, h);
      if (lexicographically_less(points[v], points[cycle.leftmost])) cycle = {v, false};
      if (v == cycle.leftmost) cycle.is_outside = cycle.is_outside || around.guards_left[h];
      h = around.next[h];
    } while (h != first);
    cycles.push_back(cycle);
  }

  // A cycle inside a face makes a new face. A cycle outside a component belongs to the face to the left of its leftmost
  // vertex. This face is the exterior, or segments further left bound it. Therefore these cycles are processed from
  // left to right.
  std::vector<Index> face_of_cycle(cycles.size(), no_index);
  std::vector<Index> outside;
  for (Index c = 0; c < cycles.size(); ++c) {
    if (cycles[c].is_outside)
      outside.push_back(c);
    else
      face_of_cycle[c] = count_++;
  }
  std::ranges::sort(outside, [&](Index c, Index d) {
    return lexicographically_less(points[cycles[c].leftmost], points[cycles[d].leftmost]);
  });
  for (const Index c : outside) {
    const Index below = index.below(points[cycles[c].leftmost]);
    face_of_cycle[c] = below == no_index ? exterior : face_of_cycle[cycle_of[half_edge_above(below)]];
  }
  for (HalfEdge h = 0; h < face_.size(); ++h) face_[h] = face_of_cycle[cycle_of[h]];
}

Index Faces::half_edge_above(Index segment) const {
  const bool to_the_right = points_[segments_[segment].a].x < points_[segments_[segment].b].x;
  return 2 * segment + (to_the_right ? 0 : 1);
}

Index Faces::containing(Point p) const {
  const Index below = index_.below(p);
  return below == no_index ? exterior : face_[half_edge_above(below)];
}

}  // namespace pardel::engine
