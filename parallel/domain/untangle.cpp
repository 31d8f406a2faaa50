// Repair works in rounds. Each round merges points, drops zero-length and duplicate segments, and splits segments where
// they meet. A crossing is rounded to a point. The pieces therefore deviate slightly from the segment and can meet
// other segments again, so several rounds are needed. If many segments pass very close to one point, each round can
// cause more crossings than it removes. Then the repair starts again and rounds crossings to a lattice: first one finer
// than the last place of the larger coordinate there, then coarser and coarser ones. This is Hobby's snap rounding
// (1999), except that given points move only by merging. With a snapping distance, a segment is also bent to the points
// near it, and bent again if it then comes near other points: iterated snap rounding (Halperin and Packer, 2002).
#include "untangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "../arithmetic/box.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "../segments/conflicts.hpp"
#include "../segments/plane_sweep.hpp"
#include "../segments/reach.hpp"
#include "duplicates.hpp"

namespace pardel::engine {
namespace {

/// The spacings of the lattices to try, relative to the largest coordinate; 0: no lattice. A snapping distance makes
/// them needless, because points are then farther from each other than the spacing.
constexpr std::array<double, 6> lattice_units{0, 0x1p-52, 0x1p-49, 0x1p-46, 0x1p-43, 0x1p-40};

/// A lattice whose spacing depends on the place: it is a share of the largest coordinate among the ends of segments
/// that lie in the same power of two as the larger coordinate of the place.
class Lattice {
 public:
  Lattice(const Pslg& pslg, double unit) : unit_(unit) {
    if (unit == 0) return;
    for (const Segment& s : pslg.segments)
      for (const Index end : {s.a, s.b}) {
        const double magnitude = Box::around(pslg.points[end]).largest_magnitude();
        double& largest = largest_[std::ilogb(magnitude)];
        largest = std::max(largest, magnitude);
      }
  }

  [[nodiscard]] Point nearest(Point p) const {
    if (unit_ == 0 || p == Point{}) return p;
    const int power = std::ilogb(Box::around(p).largest_magnitude());
    const auto of_ends = largest_.find(power);
    const double spacing = unit_ * (of_ends == largest_.end() ? std::ldexp(1, power) : of_ends->second);
    return {snapped(std::round(p.x / spacing) * spacing), snapped(std::round(p.y / spacing) * spacing)};
  }

 private:
  double unit_;
  std::map<int, double> largest_;  ///< by power of two
};

/// Removes the duplicates from the points and renumbers the ends of segments.
void merge(Work& work, std::span<const Duplicate> duplicates, StopSignal& stop) {
  if (duplicates.empty()) return;
  SparseAsk ask(&stop);
  Pslg& pslg = work.pslg;
  const std::size_t width = pslg.attributes_per_point;
  std::vector<Index> renamed(pslg.points.size(), no_index);
  for (const Duplicate& d : duplicates) renamed[d.again] = d.first;
  Index kept = 0;
  for (Index i = 0; i < renamed.size(); ++i) {
    ask();
    if (renamed[i] != no_index) {
      renamed[i] = renamed[renamed[i]];
      continue;
    }
    renamed[i] = kept;
    pslg.points[kept] = pslg.points[i];
    for (std::size_t k = 0; k < width; ++k)
      pslg.point_attributes[kept * width + k] = pslg.point_attributes[i * width + k];
    if (!pslg.point_markers.empty()) pslg.point_markers[kept] = pslg.point_markers[i];
    ++kept;
  }
  pslg.points.resize(kept);
  pslg.point_attributes.resize(kept * width);
  if (!pslg.point_markers.empty()) pslg.point_markers.resize(kept);
  for (Index& point : work.point_map) point = renamed[point];
  for (Segment& s : pslg.segments) s = {renamed[s.a], renamed[s.b], s.marker};
}

/// Drops zero-length segments. If several segments have the same ends, keeps only the first one and gives it the first
/// marker that is not zero.
void drop_surplus_segments(Work& work, StopSignal& stop) {
  SparseAsk ask(&stop);
  std::vector<Segment>& segments = work.pslg.segments;
  std::vector<bool> stays(segments.size());
  Ends first{no_index, no_index, no_index};
  for (const Ends& ends : sorted_ends(segments, work.pslg.points.size(), &stop)) {
    ask();
    if (ends.low == ends.high) continue;
    if (ends.low != first.low || ends.high != first.high) {
      stays[ends.segment] = true;
      first = ends;
    } else {
      int& marker = segments[first.segment].marker;
      if (marker == 0) marker = segments[ends.segment].marker;
    }
  }
  std::size_t kept = 0;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (!stays[s]) continue;
    segments[kept] = segments[s];
    work.source[kept++] = work.source[s];
  }
  segments.resize(kept);
  work.source.resize(kept);
}

/// Adds a point on a segment. Its attributes are interpolated between the ends; its marker is that of the segment.
Index add_point(Pslg& pslg, Point p, const Segment& on) {
  const Point a = pslg.points[on.a], b = pslg.points[on.b];
  const double share = std::min(1.0, distance(a, p) / distance(a, b));
  const std::size_t width = pslg.attributes_per_point;
  for (std::size_t k = 0; k < width; ++k) {
    const double at_a = pslg.point_attributes[on.a * width + k], at_b = pslg.point_attributes[on.b * width + k];
    pslg.point_attributes.push_back((1 - share) * at_a + share * at_b);
  }
  if (!pslg.point_markers.empty()) pslg.point_markers.push_back(on.marker);
  pslg.points.push_back(p);
  return static_cast<Index>(pslg.points.size() - 1);
}

/// Splits segments at the given points, which need no order. The pieces replace the segment.
void split(Work& work, std::vector<std::pair<Index, Index>> segment_and_point, StopSignal& stop) {
  SparseAsk ask(&stop);
  const std::vector<Point>& points = work.pslg.points;
  std::ranges::sort(segment_and_point);
  std::vector<Segment> pieces;
  std::vector<Index> source;
  auto next = segment_and_point.begin();
  for (Index s = 0; s < work.pslg.segments.size(); ++s) {
    ask();
    const Segment segment = work.pslg.segments[s];
    const Point a = points[segment.a], b = points[segment.b];
    const auto first = next;
    while (next != segment_and_point.end() && next->first == s) ++next;
    // Rounding cannot reverse the order of points along the longer extent.
    const bool along_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const bool ascending = along_x ? a.x < b.x : a.y < b.y;
    std::stable_sort(first, next, [&](const auto& p, const auto& q) {
      const double at_p = along_x ? points[p.second].x : points[p.second].y;
      const double at_q = along_x ? points[q.second].x : points[q.second].y;
      return ascending ? at_p < at_q : at_q < at_p;
    });
    Index from = segment.a;
    for (auto at = first; at != next; ++at) {
      pieces.push_back({from, at->second, segment.marker});
      from = at->second;
    }
    pieces.push_back({from, segment.b, segment.marker});
    source.resize(pieces.size(), work.source[s]);
  }
  work.pslg.segments = std::move(pieces);
  work.source = std::move(source);
}

/// The places at which segments have to be split.
struct Splits {
  std::vector<std::pair<Index, Index>> segment_and_point;
  std::size_t conflicts = 0;  ///< the number of conflicts that cause them
};

/// Overlaps need no split of their own: an end of one segment is a point on the other.
void split_at_conflicts(Pslg& pslg, std::span<const Conflict> conflicts, const Lattice& lattice, Reach& reach,
                        Splits& splits, StopSignal& stop) {
  SparseAsk ask(&stop);
  for (const Conflict& c : conflicts) {
    ask();
    if (c.kind == ConflictKind::overlapping) continue;
    if (c.kind == ConflictKind::point_on_segment) {
      splits.segment_and_point.emplace_back(c.second, c.first);
      continue;
    }
    const Point place = lattice.nearest(place_of(c, pslg.points, pslg.segments));
    const Index point = add_point(pslg, place, pslg.segments[c.first]);
    reach.add_crossing(c.first, c.second);
    splits.segment_and_point.emplace_back(c.first, point);
    splits.segment_and_point.emplace_back(c.second, point);
  }
  splits.conflicts += conflicts.size();
}

/// Finds the conflicts, and the points near a segment, to which the segment is bent. So a segment touches a point
/// before it could pass over the point. The search for conflicts ends when it has found `most` of one kind.
Splits find_splits(Pslg& pslg, Reach& reach, const Lattice& lattice, std::size_t most, StopSignal& stop) {
  std::vector<bool> is_end(pslg.points.size());
  for (const Segment& s : pslg.segments) is_end[s.a] = is_end[s.b] = true;
  std::vector<Index> loose;
  for (Index i = 0; i < is_end.size(); ++i)
    if (!is_end[i]) loose.push_back(i);
  const SweepInput input{.points = pslg.points,
                         .segments = pslg.segments,
                         .candidates = loose,
                         .most = most,
                         .reach = &reach,
                         .stop = &stop};
  const Swept swept = sweep_plane(input);
  Splits splits;
  if (!reach.is_zero()) {
    for (const NearPoint& near : find_near_points(input, swept))
      splits.segment_and_point.emplace_back(near.segment, near.point);
    splits.conflicts = splits.segment_and_point.size();
  }
  split_at_conflicts(pslg, swept.conflicts, lattice, reach, splits, stop);
  return splits;
}

/// Performs one round. Returns the number of conflicts before the round, and of points merged after the splits. It is
/// zero if segments meet only at common ends, and no other points are close. Segments are split before points are
/// merged: a segment holds on to the points near it before its ends move.
std::size_t resolve(Work& work, const Snapping& snapping, const Lattice& lattice, std::size_t most, StopSignal& stop) {
  merge(work, find_duplicates(work.pslg.points, {1, &stop}), stop);
  drop_surplus_segments(work, stop);
  Reach reach(snapping, work.pslg.points, work.pslg.segments);
  Splits splits = find_splits(work.pslg, reach, lattice, most, stop);
  if (splits.conflicts > 0) split(work, std::move(splits.segment_and_point), stop);
  if (snapping.is_zero()) return splits.conflicts;
  const std::vector<Duplicate> close = find_close(work.pslg.points, reach, &stop);
  merge(work, close, stop);
  return splits.conflicts + close.size();
}

/// Performs rounds until there is no conflict. Returns false if the number of conflicts does not halve within
/// `patience` rounds, or more than doubles. Even a single conflict can take several rounds, because its pieces can
/// cross another segment one rounding away.
bool untangle_with(Work& work, const Snapping& snapping, const Lattice& lattice, StopSignal& stop) {
  constexpr int patience = 8;
  constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();
  std::size_t fewest = unbounded, too_many = unbounded;
  int rounds = 0;  // since the number was halved
  while (true) {
    const std::size_t conflicts = resolve(work, snapping, lattice, too_many, stop);
    if (conflicts == 0) return true;
    if (conflicts <= fewest / 2) {
      fewest = conflicts;
      too_many = 2 * conflicts + 8;
      rounds = 0;
    } else if (++rounds == patience || conflicts >= too_many) {
      return false;
    }
  }
}

}  // namespace

bool untangle(Work& work, const Snapping& snapping, StopSignal& stop) {
  const Work begin = work;
  const std::span<const double> units = std::span(lattice_units).first(snapping.is_zero() ? lattice_units.size() : 1);
  return std::ranges::any_of(units, [&](double unit) {
    work = begin;
    return untangle_with(work, snapping, Lattice(begin.pslg, unit), stop);
  });
}

}  // namespace pardel::engine
