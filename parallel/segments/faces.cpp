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

/// The half-edges from each point, point by point, and the places in this list at which the lists of the points begin.
struct HalfEdgesByOrigin {
  std::vector<std::size_t> begin;
  std::vector<HalfEdge> list;
};
HalfEdgesByOrigin half_edges_by_origin(std::size_t points, std::span<const Segment> segments) {
  HalfEdgesByOrigin result{std::vector<std::size_t>(points + 1), std::vector<HalfEdge>(2 * segments.size())};
  for (const Segment& s : segments) {
    ++result.begin[s.a + 1];
    ++result.begin[s.b + 1];
  }
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  std::vector<std::size_t> place = result.begin;
  for (HalfEdge h = 0; h < result.list.size(); ++h) result.list[place[origin(segments, h)]++] = h;
  return result;
}

Rotation rotation(std::span<const Point> points, std::span<const Segment> segments, SparseAsk& ask) {
  HalfEdgesByOrigin by_origin = half_edges_by_origin(points.size(), segments);
  Rotation result{std::vector<HalfEdge>(2 * segments.size()), std::vector<bool>(2 * segments.size())};
  for (Index at = 0; at < points.size(); ++at) {
    ask();
    const std::span<HalfEdge> around(by_origin.list.data() + by_origin.begin[at],
                                     by_origin.list.data() + by_origin.begin[at + 1]);
    if (around.empty()) continue;
    const auto end_of = [&](HalfEdge h) { return points[origin(segments, twin(h))]; };
    const auto goes_left = [&](HalfEdge h) { return lexicographically_less(end_of(h), points[at]); };
    std::ranges::sort(around, [&](HalfEdge g, HalfEdge h) {
      if (goes_left(g) != goes_left(h)) return goes_left(h);
      return orient2d(points[at], end_of(g), end_of(h)) > 0;
    });
    result.guards_left[around.back()] = !goes_left(around.back());
    for (std::size_t i = 0; i < around.size(); ++i)
      result.next[twin(around[i])] = around[(i == 0 ? around.size() : i) - 1];
  }
  return result;
}

/// A closed walk along half-edges with one face to the left.
struct Cycle {
  Index leftmost;   ///< the lexicographically smallest vertex
  bool is_outside;  ///< the walk follows the outside of a component; otherwise it follows the inside of a face
};

}  // namespace

Faces::Faces(std::span<const Point> points, std::span<const Segment> segments, std::span<const Index> below,
             StopSignal* stop)
    : points_(points), segments_(segments), face_(2 * segments.size()) {
  SparseAsk ask(stop);
  const Rotation around = rotation(points, segments, ask);
  std::vector<Cycle> cycles;
  std::vector<Index> cycle_of(face_.size(), no_index);
  for (HalfEdge first = 0; first < cycle_of.size(); ++first) {
    if (cycle_of[first] != no_index) continue;
    Cycle cycle{origin(segments, first), false};
    HalfEdge h = first;
    do {
      ask();
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
    const Index segment = below[cycles[c].leftmost];
    face_of_cycle[c] = segment == no_index ? exterior : face_of_cycle[cycle_of[half_edge_above(segment)]];
  }
  for (HalfEdge h = 0; h < face_.size(); ++h) face_[h] = face_of_cycle[cycle_of[h]];
}

Index Faces::half_edge_above(Index segment) const {
  const bool to_the_right = lexicographically_less(points_[segments_[segment].a], points_[segments_[segment].b]);
  return 2 * segment + (to_the_right ? 0 : 1);
}

Index Faces::above(Index segment) const { return segment == no_index ? exterior : face_[half_edge_above(segment)]; }

}  // namespace pardel::engine
