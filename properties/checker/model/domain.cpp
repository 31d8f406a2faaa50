#include "domain.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "../../../core/support/point_order.hpp"
#include "../arithmetic/exact.hpp"

namespace pardel::checker {
namespace {

/// The corners of the convex hull and all points on its edges, counter-clockwise (Andrew's monotone chain).
/// Empty when all points are collinear.
std::vector<Index> hull(std::span<const Point> points, StopSignal* stop) {
  std::vector<Index> sorted(points.size());
  std::iota(sorted.begin(), sorted.end(), Index{0});
  const auto less = [&](Index a, Index b) { return lexicographically_less(points[a], points[b]); };
  stoppable_sort(sorted.begin(), sorted.end(), less, stop);
  SparseAsk ask(stop);
  const auto turn = [&](Index a, Index b, Index c) { return exactly::orientation(points[a], points[b], points[c]); };
  const auto half = [&](auto first, auto last) {
    std::vector<Index> chain;
    for (; first != last; ++first) {
      ask();
      if (!chain.empty() && points[chain.back()] == points[*first]) continue;
      while (chain.size() >= 2 && turn(chain[chain.size() - 2], chain.back(), *first) < 0) chain.pop_back();
      chain.push_back(*first);
    }
    return chain;
  };
  std::vector<Index> lower = half(sorted.begin(), sorted.end());
  std::vector<Index> upper = half(sorted.rbegin(), sorted.rend());
  const bool flat =
      std::all_of(sorted.begin(), sorted.end(), [&](Index p) { return turn(lower.front(), lower.back(), p) == 0; });
  if (flat) return {};
  lower.pop_back();
  upper.pop_back();
  lower.insert(lower.end(), upper.begin(), upper.end());
  return lower;
}

std::pair<Index, Index> ends(Index a, Index b) { return std::minmax(a, b); }

std::vector<Segment> with_hull(const Pslg& pslg, bool convex_hull, StopSignal* stop) {
  std::vector<Segment> segments = pslg.segments;
  if (!convex_hull && !segments.empty()) return segments;
  std::vector<std::pair<Index, Index>> present;
  present.reserve(segments.size());
  for (const Segment& s : segments) present.push_back(ends(s.a, s.b));
  stoppable_sort(present.begin(), present.end(), std::less<>(), stop);
  const std::vector<Index> outline = hull(pslg.points, stop);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Index a = outline[i];
    const Index b = outline[(i + 1) % outline.size()];
    if (!std::binary_search(present.begin(), present.end(), ends(a, b))) segments.push_back({a, b, 0});
  }
  return segments;
}

}  // namespace

Domain::Domain(const Pslg& pslg, bool convex_hull, StopSignal* stop)
    : pslg_(pslg), segments_(with_hull(pslg, convex_hull, stop)), faces_(pslg.points, segments_, stop), stop_(stop) {
  inside_.assign(faces_.count(), 1);
  inside_[PlanarFaces::exterior()] = 0;
  for (const Point& hole : pslg.holes) {
    const Index face = faces_.face_at(hole);
    if (face != no_index) inside_[face] = 0;
  }
  for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
    const Index face = faces_.face_at(pslg.regions[r].seed);
    if (inside(face)) region_of_.emplace_back(face, static_cast<Index>(r));
  }
  std::sort(region_of_.begin(), region_of_.end());
}

std::vector<Index> Domain::places_of_faces() const {
  std::vector<Index> place(faces_.count());
  std::iota(place.begin(), place.end(), Index{0});
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const auto s = static_cast<Index>(i);
    if (has(s)) continue;
    const Index left = root(place, faces_.face(s, Side::left)), right = root(place, faces_.face(s, Side::right));
    place[std::max(left, right)] = std::min(left, right);
  }
  for (Index face = 0; face < place.size(); ++face) place[face] = root(place, face);
  return place;
}

const StraightPaths& Domain::straight_paths() const {
  std::call_once(straight_paths_wanted_, [&] {
    std::vector<bool> counts(segments_.size());
    for (std::size_t s = 0; s < counts.size(); ++s) counts[s] = has(static_cast<Index>(s));
    straight_paths_.emplace(pslg_.points, segments_, counts, stop_);
  });
  return *straight_paths_;
}

bool Domain::has_point(Index point) const {
  const auto around = faces_.incident(point);
  if (around.empty()) return inside(faces_.face_at(pslg_.points[point]));
  return std::any_of(around.begin(), around.end(), [&](Index s) { return has(s); });
}

std::span<const std::pair<Index, Index>> Domain::regions_in(Index face) const {
  const auto by_face = [](const std::pair<Index, Index>& a, const std::pair<Index, Index>& b) {
    return a.first < b.first;
  };
  const auto [first, last] =
      std::equal_range(region_of_.begin(), region_of_.end(), std::pair<Index, Index>{face, 0}, by_face);
  return {first, last};
}

}  // namespace pardel::checker
