#include "planar_faces.hpp"

#include <algorithm>
#include <numeric>

#include "../../../core/support/point_order.hpp"
#include "../arithmetic/exact.hpp"

namespace pardel::checker {
namespace {

/// Half-edge 2 s runs from end a of segment s to end b, half-edge 2 s + 1 from b to a. Its face lies on its left.
using HalfEdge = std::size_t;

/// Directions from 0 (included) to 180 degrees (excluded) come first.
bool in_lower_half(Point centre, Point p) { return p.y < centre.y || (p.y == centre.y && p.x < centre.x); }

}  // namespace

bool counter_clockwise_before(Point centre, Point a, Point b) {
  const bool a_low = in_lower_half(centre, a);
  const bool b_low = in_lower_half(centre, b);
  if (a_low != b_low) return b_low;
  return exactly::orientation(centre, a, b) > 0;
}

Index root(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

PlanarFaces::PlanarFaces(std::span<const Point> points, std::span<const Segment> segments, StopSignal* stop)
    : points_(points), segments_(segments), below_(points, segments, stop) {
  SparseAsk ask(stop);
  sort_around_vertices(ask);
  walk_cycles(ask);
  nest_components(ask);
}

void PlanarFaces::sort_around_vertices(SparseAsk& ask) {
  first_.assign(points_.size() + 1, 0);
  for (const Segment& s : segments_) {
    ++first_[s.a + 1];
    ++first_[s.b + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  incident_.resize(2 * segments_.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    incident_[next[segments_[s].a]++] = static_cast<Index>(s);
    incident_[next[segments_[s].b]++] = static_cast<Index>(s);
  }
  for (Index v = 0; v < points_.size(); ++v) {
    ask();
    const auto far_end = [&](Index s) { return points_[segments_[s].a == v ? segments_[s].b : segments_[s].a]; };
    std::sort(incident_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
              incident_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]),
              [&](Index s, Index t) { return counter_clockwise_before(points_[v], far_end(s), far_end(t)); });
  }
}

void PlanarFaces::walk_cycles(SparseAsk& ask) {
  // Around the face on the left of h, the half-edge after h is the next one clockwise from h's twin at h's head.
  const std::size_t half_edges = 2 * segments_.size();
  std::vector<HalfEdge> next(half_edges);
  for (Index v = 0; v < points_.size(); ++v) {
    ask();
    const auto around = incident(v);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Index s = around[i];
      const Index t = around[(i + around.size() - 1) % around.size()];
      const HalfEdge leaving = 2 * HalfEdge{t} + (segments_[t].a == v ? 0 : 1);
      const HalfEdge arriving = 2 * HalfEdge{s} + (segments_[s].a == v ? 1 : 0);
      next[arriving] = leaving;
    }
  }
  face_.assign(half_edges, no_index);
  for (HalfEdge start = 0; start < half_edges; ++start) {
    ask();
    if (face_[start] != no_index) continue;
    for (HalfEdge h = start; face_[h] == no_index; h = next[h]) face_[h] = count_;
    ++count_;
  }
}

void PlanarFaces::nest_components(SparseAsk& ask) {
  std::vector<Index> component(points_.size());
  std::iota(component.begin(), component.end(), Index{0});
  for (const Segment& s : segments_) {
    ask();
    const Index a = root(component, s.a);
    const Index b = root(component, s.b);
    component[std::max(a, b)] = std::min(a, b);
  }
  std::vector<Index> leftmost(points_.size(), no_index);
  for (Index v = 0; v < points_.size(); ++v) {
    ask();
    if (incident(v).empty()) continue;
    Index& best = leftmost[root(component, v)];
    if (best == no_index || lexicographically_less(points_[v], points_[best])) best = v;
  }

  // One cycle of each component bounds it from outside. It passes the leftmost vertex with the outside on its left. Its
  // face is the face directly below that vertex.
  std::vector<Index> same_as(count_);
  std::iota(same_as.begin(), same_as.end(), Index{0});
  for (const Index v : leftmost) {
    ask();
    if (v == no_index) continue;
    const auto around = incident(v);
    // All segments leave the leftmost vertex to the right or vertically. The outside lies on the left of the steepest
    // segment: the last with a direction in [0, 180) degrees, or the last of all segments if every segment goes down.
    std::size_t last = around.size() - 1;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Segment& s = segments_[around[i]];
      if (!in_lower_half(points_[v], points_[s.a == v ? s.b : s.a])) last = i;
    }
    const Index s = around[last];
    const Index outer = face_[2 * std::size_t{s} + (segments_[s].a == v ? 0 : 1)];
    const Index under = below_.directly_below(points_[v]);
    Index around_it = exterior();
    if (under != no_index) {
      const Segment& lid = segments_[under];
      const bool rightward = points_[lid.a].x < points_[lid.b].x;
      around_it = face(under, rightward ? Side::left : Side::right);
    }
    const Index a = root(same_as, outer);
    const Index b = root(same_as, around_it);
    same_as[std::max(a, b)] = std::min(a, b);
  }

  // Number the faces without gaps. The exterior stays 0, because 0 is the smallest number of its class.
  std::vector<Index> number(count_, no_index);
  Index faces = 0;
  for (Index i = 0; i < count_; ++i)
    if (same_as[i] == i) number[i] = faces++;
  for (Index& f : face_) f = number[root(same_as, f)];
  count_ = faces;
}

Index PlanarFaces::face_at(Point p) const {
  if (below_.through(p) != no_index) return no_index;
  const Index under = below_.directly_below(p);
  if (under == no_index) return exterior();
  const bool rightward = points_[segments_[under].a].x < points_[segments_[under].b].x;
  return face(under, rightward ? Side::left : Side::right);
}

}  // namespace pardel::checker
