#include "domain_segments.hpp"

#include <algorithm>
#include <cmath>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

constexpr double cosine_of_narrow_angle = 0.9998477;  // one degree

/// The end of a segment at which another segment meets it at a narrow angle that is much smaller than the angle at the
/// other end; or no_index.
VertexId narrow_end(const DomainSegment& s) {
  const double at_a = 1 - s.cosine_at_a, at_b = 1 - s.cosine_at_b;  // these grow with the angles
  const double smaller = std::min(at_a, at_b), larger = std::max(at_a, at_b);
  if (smaller >= 1 - cosine_of_narrow_angle || smaller >= 0.5 * larger) return no_index;
  return at_a < at_b ? s.a : s.b;
}

}  // namespace

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

  for (VertexId v = 0; v < points.size(); ++v) {
    ask();
    sort_around(points, v);
  }
  find_smallest_angles(points, ask);
  find_narrow_apexes(points, ask);
}

void DomainSegments::sort_around(const Array<Point>& points, VertexId v) {
  const auto far = [&](Index l) { return points[other_end(l, v)]; };
  const auto goes_left = [&](Index l) { return lexicographically_less(far(l), points[v]); };
  std::sort(incident_.begin() + start_[v], incident_.begin() + start_[v + 1U], [&](Index l, Index r) {
    if (goes_left(l) != goes_left(r)) return goes_left(r);
    return orient2d(points[v], far(l), far(r)) > 0;
  });
}

/// The smallest angles at a vertex lie between segments that are adjacent in the angular order around it.
void DomainSegments::find_smallest_angles(const Array<Point>& points, SparseAsk& ask) {
  for (VertexId v = 0; v < points.size(); ++v) {
    ask();
    for_each_angle_at(v, [&](Index here, Index next) {
      const double cosine = cosine_at(points, v, here, next);
      for (const Index l : {here, next}) {
        double& largest = segments_[l].a == v ? segments_[l].cosine_at_a : segments_[l].cosine_at_b;
        largest = std::max(largest, cosine);
      }
    });
  }
}

void DomainSegments::find_narrow_apexes(const Array<Point>& points, SparseAsk& ask) {
  for (DomainSegment& s : segments_) {
    ask();
    s.narrow_apex = narrow_end(s);
  }
  for (VertexId v = 0; v < points.size(); ++v) {
    ask();
    for_each_angle_at(v, [&](Index here, Index next) {
      // The angle between the two is not smaller than the smallest one at each of them.
      const double at_most = std::min(segments_[here].cosine_at(v), segments_[next].cosine_at(v));
      if (at_most <= cosine_of_narrow_angle || cosine_at(points, v, here, next) <= cosine_of_narrow_angle) return;
      if (narrow_end(segments_[here]) != v) segments_[next].narrow_apex = no_index;
      if (narrow_end(segments_[next]) != v) segments_[here].narrow_apex = no_index;
    });
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
