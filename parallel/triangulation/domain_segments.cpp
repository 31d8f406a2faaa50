#include "domain_segments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"
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
  for (const Constraint c : constraints) {
    ask();
    segments_.push_back({std::min(c.a, c.b), std::max(c.a, c.b)});
  }
  find_ends(ask);
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    ask();
    sort_around(points, end);
  }
  find_smallest_angles(points, ask);
  find_narrow_apexes(points, ask);
  find_mates(points, ask);
}

void DomainSegments::find_ends(SparseAsk& ask) {
  std::vector<std::pair<VertexId, Index>> all;
  all.reserve(2 * segments_.size());
  for (Index l = 0; l < segments_.size(); ++l) {
    ask();
    all.emplace_back(segments_[l].a, l);
    all.emplace_back(segments_[l].b, l);
  }
  std::ranges::sort(all, [&](const auto& left, const auto& right) {
    ask();
    return left < right;
  });
  incident_.reserve(all.size());
  for (const auto& [vertex, segment] : all) {
    ask();
    if (ends_.empty() || ends_.back() != vertex) {
      ends_.push_back(vertex);
      start_.push_back(static_cast<Index>(incident_.size()));
    }
    incident_.push_back(segment);
  }
  start_.push_back(static_cast<Index>(incident_.size()));
}

void DomainSegments::sort_around(const Array<Point>& points, std::size_t end) {
  const VertexId v = ends_[end];
  const auto far = [&](Index l) { return points[other_end(l, v)]; };
  const auto goes_left = [&](Index l) { return lexicographically_less(far(l), points[v]); };
  std::sort(incident_.begin() + start_[end], incident_.begin() + start_[end + 1], [&](Index l, Index r) {
    if (goes_left(l) != goes_left(r)) return goes_left(r);
    return orient2d(points[v], far(l), far(r)) > 0;
  });
}

/// The smallest angles at a vertex lie between segments that are adjacent in the angular order around it.
void DomainSegments::find_smallest_angles(const Array<Point>& points, SparseAsk& ask) {
  for_each_angle(ask, [&](VertexId v, Index here, Index next) {
    const double cosine = cosine_at(points, v, here, next);
    for (const Index l : {here, next}) {
      double& largest = segments_[l].a == v ? segments_[l].cosine_at_a : segments_[l].cosine_at_b;
      largest = std::max(largest, cosine);
    }
  });
}

void DomainSegments::find_narrow_apexes(const Array<Point>& points, SparseAsk& ask) {
  for (DomainSegment& s : segments_) {
    ask();
    s.narrow_apex = narrow_end(s);
  }
  for_each_angle(ask, [&](VertexId v, Index here, Index next) {
    // The angle between the two is not smaller than the smallest one at each of them.
    const double at_most = std::min(segments_[here].cosine_at(v), segments_[next].cosine_at(v));
    if (at_most <= cosine_of_narrow_angle || cosine_at(points, v, here, next) <= cosine_of_narrow_angle) return;
    if (narrow_end(segments_[here]) != v) segments_[next].narrow_apex = no_index;
    if (narrow_end(segments_[next]) != v) segments_[here].narrow_apex = no_index;
  });
}

/// The segments at less than one degree from a segment are its neighbours in the angular order, on both sides.
void DomainSegments::find_mates(const Array<Point>& points, SparseAsk& ask) {
  std::vector<std::pair<Index, Mate>> found;
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    const std::span<const Index> here = around(end);
    const VertexId apex = ends_[end];
    const auto far = [&](std::size_t i) { return points[other_end(here[i], apex)]; };
    for (std::size_t i = 0; i < here.size(); ++i) {
      ask();
      const double length = distance(points[apex], far(i));
      for (const std::size_t step : {std::size_t{1}, here.size() - 1})
        for (std::size_t j = (i + step) % here.size(); j != i; j = (j + step) % here.size()) {
          if (cosine_at(points, apex, here[i], here[j]) <= cosine_of_narrow_angle) break;
          const double shorter = distance(points[apex], far(j));
          if (shorter >= length) continue;
          const double part = shorter / length;
          const Point o = points[apex], p = far(i);
          const Point place{o.x + part * (p.x - o.x), o.y + part * (p.y - o.y)};
          found.push_back({here[i], {apex, shorter, distance(place, far(j))}});
        }
    }
  }
  std::ranges::stable_sort(found, {}, [](const auto& entry) { return entry.first; });
  first_mate_.assign(segments_.size() + 1, 0);
  for (const auto& [segment, mate] : found) {
    ++first_mate_[segment + 1];
    mates_.push_back(mate);
  }
  std::partial_sum(first_mate_.begin(), first_mate_.end(), first_mate_.begin());
}

std::span<const Index> DomainSegments::segments_at(VertexId v) const {
  const auto at = std::ranges::lower_bound(ends_, v);
  if (at == ends_.end() || *at != v) return {};
  return around(static_cast<std::size_t>(at - ends_.begin()));
}

Index DomainSegments::segment_of(const Triangulation& t, VertexId u, VertexId v) const {
  for (const VertexId end : {u, v})
    if (const Index segment = segment_of_origin(t.origin[end]); segment < segments_.size()) return segment;
  for (const Index l : segments_at(u))
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
  const double cosine = (px * qx + py * qy) / (std::sqrt(px * px + py * py) * std::sqrt(qx * qx + qy * qy));
  return std::min(cosine, 1.0);  // rounding may give more
}

}  // namespace pardel::engine
