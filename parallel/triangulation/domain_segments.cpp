#include "domain_segments.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "../threads/parallel_for.hpp"

namespace pardel::engine {
namespace {

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
                               std::span<const int> markers, const Threads& threads) {
  SparseAsk ask(threads.stop);
  segments_.reserve(constraints.size());
  for (const Constraint c : constraints) {
    ask();
    segments_.push_back({std::min(c.a, c.b), std::max(c.a, c.b)});
  }
  for (std::size_t s = 0; s < markers.size(); ++s) segments_[s].marker = markers[s];
  find_ends(ask);
  find_smallest_angles(points, threads);
  find_narrow_apexes(points, ask);
  find_places_beside_ends(points, ask);
  find_narrow_wedges(points, ask);
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
      start_.push_back(start_.back());
    }
    incident_.push_back(segment);
    ++start_.back();
  }
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

/// Sorts the segments around each vertex by angle, which the functions after this one need, too. The smallest angles
/// then lie between neighbours in this order. Threads share the vertices: each writes only what belongs to the ends of
/// segments at its vertices.
void DomainSegments::find_smallest_angles(const Array<Point>& points, const Threads& threads) {
  parallel_blocks(threads, ends_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t end = first; end < last; ++end) {
      sort_around(points, end);
      for_each_angle_at(end, [&](VertexId v, Index here, Index next) {
        const double cosine = cosine_at(points, v, here, next);
        for (const Index l : {here, next}) {
          double& largest = segments_[l].a == v ? segments_[l].cosine_at_a : segments_[l].cosine_at_b;
          largest = std::max(largest, cosine);
        }
      });
    }
  });
}

/// The angle between the two is not smaller than the smallest one at each of them.
bool DomainSegments::meet_narrowly(const Array<Point>& points, VertexId v, Index first, Index second,
                                   double cosine) const {
  return std::min(segments_[first].cosine_at(v), segments_[second].cosine_at(v)) > cosine &&
         cosine_at(points, v, first, second) > cosine;
}

void DomainSegments::find_narrow_apexes(const Array<Point>& points, SparseAsk& ask) {
  for (DomainSegment& s : segments_) {
    ask();
    s.narrow_apex = narrow_end(s);
  }
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    ask();
    for_each_angle_at(end, [&](VertexId v, Index here, Index next) {
      if (!meet_narrowly(points, v, here, next, cosine_of_narrow_angle)) return;
      if (narrow_end(segments_[here]) != v) segments_[next].narrow_apex = no_index;
      if (narrow_end(segments_[next]) != v) segments_[here].narrow_apex = no_index;
    });
  }
}

/// The segments that form a narrow wedge with a segment are its neighbours in the angular order, on both sides.
void DomainSegments::find_places_beside_ends(const Array<Point>& points, SparseAsk& ask) {
  constexpr std::size_t most = 16;  // on each side
  std::vector<std::pair<Index, PlaceBesideEnd>> found;
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    const std::span<const Index> here = around(end);
    const VertexId apex = ends_[end];
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (segments_[here[i]].cosine_at(apex) <= cosine_of_narrow_angle) continue;  // no wedge at this end
      const auto visit_neighbours = [&](std::size_t number, const auto& neighbour) {
        for (std::size_t k = 1; k <= number; ++k) {
          ask();
          const Index other = here[neighbour(k)];
          if (cosine_at(points, apex, here[i], other) <= cosine_of_narrow_angle) return k - 1;
          if (const auto place = place_beside_end(points, apex, here[i], other)) found.emplace_back(here[i], *place);
        }
        return number;
      };
      const std::size_t n = here.size();
      const std::size_t after = visit_neighbours(std::min(most, n - 1), [&](std::size_t k) { return (i + k) % n; });
      visit_neighbours(std::min(most, n - 1 - after), [&](std::size_t k) { return (i + n - k) % n; });
    }
  }
  std::ranges::stable_sort(found, {}, [](const auto& entry) { return entry.first; });
  first_place_.assign(segments_.size() + 1, 0);
  for (const auto& [segment, place] : found) {
    ++first_place_[segment + 1];
    places_.push_back(place);
  }
  std::partial_sum(first_place_.begin(), first_place_.end(), first_place_.begin());
}

/// Nothing if the segment does not pass the end of the other one, or if its own end is as near as the other segment.
std::optional<PlaceBesideEnd> DomainSegments::place_beside_end(const Array<Point>& points, VertexId apex, Index segment,
                                                               Index other) const {
  const Point o = points[apex], far = points[other_end(segment, apex)], end = points[other_end(other, apex)];
  const double length = distance(o, far), shorter = distance(o, end), part = shorter / length;
  const double gap = distance({o.x + part * (far.x - o.x), o.y + part * (far.y - o.y)}, end);
  if (length - shorter <= gap) return {};
  return PlaceBesideEnd{apex, shorter, gap};
}

/// A point that splits a segment is at least as far from the apex as the floor. At larger angles, it is farther from
/// the other segment than rounding moves points.
void DomainSegments::find_narrow_wedges(const Array<Point>& points, SparseAsk& ask) {
  constexpr double cosine_of_narrow_wedge = 0.998;
  const auto is_in_wedge = [&](const DomainSegment& s) {
    return std::max(s.cosine_at_a, s.cosine_at_b) > cosine_of_narrow_wedge;
  };
  if (std::ranges::none_of(segments_, is_in_wedge)) return;
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    ask();
    for_each_angle_at(end, [&](VertexId v, Index here, Index next) {
      if (!meet_narrowly(points, v, here, next, cosine_of_narrow_wedge)) return;
      const Point o = points[v], p = points[other_end(here, v)], q = points[other_end(next, v)];
      const double sine = std::abs(exact::twice_area(o, p, q)) / (distance(o, p) * distance(o, q));
      for (const Index l : {here, next}) add_clearance(l, {o, 0, sine});
    });
  }
}

bool DomainSegments::stays_clear(const Array<Point>& points, Index segment, const EndPoints& edge, Point p) const {
  const std::span<const Clearance> all = clearances(segment);
  if (all.empty()) return true;
  const Constraint piece = line_at(points, segment, p);
  const EndPoints whole{points[segments_[segment].a], points[segments_[segment].b]},
      line{points[piece.a], points[piece.b]};
  // A wedge is between whole segments. The ends of pieces already lie off them, and what lies off the pieces adds up.
  return std::ranges::all_of(all, [&](const Clearance& c) {
    return keeps_clear({&c, 1}, c.gap > 0 ? line : whole, edge, p);
  });
}

void DomainSegments::add(const DomainSegment& segment, std::span<const PlaceBesideEnd> places_beside_ends,
                         std::span<const Clearance> clearances) {
  for (const Clearance& each : clearances) add_clearance(static_cast<Index>(segments_.size()), each);
  segments_.push_back(segment);
  places_.insert(places_.end(), places_beside_ends.begin(), places_beside_ends.end());
  first_place_.push_back(static_cast<Index>(places_.size()));
}

void DomainSegments::add_end(VertexId v, std::span<const Index> segments) {
  if (!ends_.empty() && v < ends_.back()) {
    late_ends_.emplace(v, std::vector<Index>(segments.begin(), segments.end()));
    return;
  }
  ends_.push_back(v);
  incident_.insert(incident_.end(), segments.begin(), segments.end());
  start_.push_back(static_cast<Index>(incident_.size()));
}

std::span<const Index> DomainSegments::segments_at(VertexId v) const {
  if (v < ends_.size() && ends_[v] == v) return around(v);  // fast where all points are ends, as on a coast
  const auto at = std::ranges::lower_bound(ends_, v);
  if (at != ends_.end() && *at == v) return around(static_cast<std::size_t>(at - ends_.begin()));
  if (const auto late = late_ends_.find(v); late != late_ends_.end()) return late->second;
  return {};
}

Index DomainSegments::segment_of(const Triangulation& t, VertexId u, VertexId v) const {
  for (const VertexId end : {u, v})
    if (const Index segment = segment_of_origin(t.origin[end]); segment < segments_.size()) return segment;
  return segment_between(u, v);
}

Index DomainSegments::segment_between(VertexId a, VertexId b) const {
  for (const Index l : segments_at(a))
    if (other_end(l, a) == b) return l;
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
