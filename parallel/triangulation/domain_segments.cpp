#include "domain_segments.hpp"

#include <algorithm>
#include <cmath>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {

DomainSegments::DomainSegments(const Array<Point>& points, std::span<const Constraint> constraints,
                               const Threads& threads) {
  SparseAsk ask(threads.stop);
  segments_.reserve(constraints.size());
  start_.assign(points.size() + 1, 0);
  for (const Constraint c : constraints) {
    ask();
    segments_.push_back({std::min(c.a, c.b), std::max(c.a, c.b)});
    ++start_[c.a + 1U];
    ++start_[c.b + 1U];
  }
  for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
  incident_.resize(2 * segments_.size());
  std::vector<Index> next = start_;
  for (Index l = 0; l < segments_.size(); ++l) {
    ask();
    incident_[next[segments_[l].a]++] = l;
    incident_[next[segments_[l].b]++] = l;
  }

  // The smallest angles at a vertex lie between segments that are adjacent in the angular order around it.
  for (VertexId v = 0; v < points.size(); ++v) {
    ask();
    const auto first = incident_.begin() + start_[v], last = incident_.begin() + start_[v + 1U];
    if (last - first < 2) continue;
    const auto far = [&](Index l) { return points[other_end(l, v)]; };
    const auto goes_left = [&](Index l) { return lexicographically_less(far(l), points[v]); };
    std::sort(first, last, [&](Index l, Index r) {
      if (goes_left(l) != goes_left(r)) return goes_left(r);
      return orient2d(points[v], far(l), far(r)) > 0;
    });
    for (auto it = first; it != last; ++it) {
      const Index here = *it, next_segment = it + 1 == last ? *first : *(it + 1);
      const double cosine = cosine_at(points, v, here, next_segment);
      for (const Index l : {here, next_segment}) {
        double& largest = segments_[l].a == v ? segments_[l].cosine_at_a : segments_[l].cosine_at_b;
        largest = std::max(largest, cosine);
      }
    }
  }
}

Index DomainSegments::segment_of(const Triangulation& t, VertexId u, VertexId v) const {
  for (const VertexId end : {u, v})
    if (t.origin[end] < segments_.size()) return t.origin[end];
  for (const Index l : at(u))
    if (other_end(l, u) == v) return l;
  return no_index;
}

VertexId DomainSegments::shared_end(Index first, Index second) const {
  const DomainSegment &f = segments_[first], &s = segments_[second];
  if (f.a == s.a || f.a == s.b) return f.a;
  if (f.b == s.a || f.b == s.b) return f.b;
  return no_index;
}

double DomainSegments::cosine_at(const Array<Point>& points, VertexId apex, Index first, Index second) const {
  const Point o = points[apex], p = points[other_end(first, apex)], q = points[other_end(second, apex)];
  const double px = p.x - o.x, py = p.y - o.y, qx = q.x - o.x, qy = q.y - o.y;
  return (px * qx + py * qy) / (std::sqrt(px * px + py * py) * std::sqrt(qx * qx + qy * qy));
}

}  // namespace pardel::engine
