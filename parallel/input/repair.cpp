// Repair works in rounds. Each round merges points, drops zero-length and duplicate segments, and splits segments where
// they meet. A crossing is rounded to a point. The pieces therefore deviate slightly from the segment and can meet
// other segments again, so several rounds are needed. If many segments pass very close to one point, each round can
// cause more crossings than it removes. Then the repair starts again and rounds crossings to a lattice: first one finer
// than the last place of the largest coordinate, then coarser and coarser ones. This is Hobby's snap rounding (1999),
// except that given points do not move.
#include "../repair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <utility>

#include "../validate.hpp"
#include "check_values.hpp"
#include "conflicts.hpp"
#include "duplicates.hpp"
#include "findings.hpp"
#include "segment_index.hpp"

namespace pardel {

using namespace engine;

namespace {

/// The spacings of the lattices to try, relative to the largest coordinate; 0: no lattice.
constexpr std::array<double, 6> lattice_units{0, 0x1p-52, 0x1p-49, 0x1p-46, 0x1p-43, 0x1p-40};

Point on_lattice(Point p, double unit) {
  return unit > 0 ? Point{std::round(p.x / unit) * unit, std::round(p.y / unit) * unit} : p;
}

/// The Pslg in its present state, with the origin of its points and segments.
struct Work {
  Pslg pslg;
  std::vector<Index> point_map;  ///< old point -> point
  std::vector<Index> source;     ///< segment -> old segment
};

/// Removes the duplicates from the points and renumbers the ends of segments.
void merge(Work& work, std::span<const Duplicate> duplicates) {
  if (duplicates.empty()) return;
  Pslg& pslg = work.pslg;
  const std::size_t width = pslg.attributes_per_point;
  std::vector<Index> renamed(pslg.points.size(), no_index);
  for (const Duplicate& d : duplicates) renamed[d.again] = d.first;
  Index kept = 0;
  for (Index i = 0; i < renamed.size(); ++i) {
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
void drop_surplus_segments(Work& work) {
  std::vector<Segment>& segments = work.pslg.segments;
  const auto ends = [&](Index s) { return std::minmax(segments[s].a, segments[s].b); };
  std::vector<Index> order(segments.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, [&](Index s, Index t) { return std::pair(ends(s), s) < std::pair(ends(t), t); });
  std::vector<bool> stays(segments.size());
  for (std::size_t k = 0, first = 0; k < order.size(); ++k) {
    Segment& segment = segments[order[k]];
    if (segment.a == segment.b) continue;
    if (k == 0 || ends(order[k]) != ends(order[first])) {
      stays[order[k]] = true;
      first = k;
    } else {
      int& marker = segments[order[first]].marker;
      if (marker == 0) marker = segment.marker;
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
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double share = std::min(1.0, std::hypot(p.x - a.x, p.y - a.y) / length);
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
void split(Work& work, std::vector<std::pair<Index, Index>> segment_and_point) {
  const std::vector<Point>& points = work.pslg.points;
  std::ranges::sort(segment_and_point);
  std::vector<Segment> pieces;
  std::vector<Index> source;
  auto next = segment_and_point.begin();
  for (Index s = 0; s < work.pslg.segments.size(); ++s) {
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

/// Performs one round. Returns the number of conflicts before the round. It is zero if segments meet only at common
/// ends and contain no other point. The search for conflicts ends as soon as it has found `most` of one kind.
std::size_t resolve(Work& work, double snap, double unit, std::size_t most) {
  Pslg& pslg = work.pslg;
  merge(work, find_duplicates(pslg.points));
  if (snap > 0) merge(work, find_close(pslg.points, snap));
  drop_surplus_segments(work);

  std::vector<bool> is_end(pslg.points.size());
  for (const Segment& s : pslg.segments) is_end[s.a] = is_end[s.b] = true;
  std::vector<Index> loose;
  for (Index i = 0; i < is_end.size(); ++i)
    if (!is_end[i]) loose.push_back(i);
  const SegmentIndex index(pslg.points, pslg.segments);
  const std::vector<Conflict> conflicts = find_conflicts(pslg.points, pslg.segments, loose, index, most);

  // Overlaps need no split of their own: an end of one segment is a point on the other.
  std::vector<std::pair<Index, Index>> splits;
  for (const Conflict& c : conflicts) {
    if (c.kind == ConflictKind::overlapping) continue;
    if (c.kind == ConflictKind::point_on_segment) {
      splits.emplace_back(c.second, c.first);
      continue;
    }
    const Point place = on_lattice(place_of(c, pslg.points, pslg.segments), unit);
    const Index point = add_point(pslg, place, pslg.segments[c.first]);
    splits.emplace_back(c.first, point);
    splits.emplace_back(c.second, point);
  }
  split(work, std::move(splits));
  return conflicts.size();
}

/// Performs rounds until there is no conflict. Returns false if the number of conflicts does not halve within
/// `patience` rounds, or more than doubles. Even a single conflict can take several rounds, because its pieces can
/// cross another segment one rounding away.
bool untangle(Work& work, double snap, double unit) {
  constexpr int patience = 8;
  constexpr std::size_t unbounded = std::numeric_limits<std::size_t>::max();
  std::size_t fewest = unbounded, too_many = unbounded;
  int rounds = 0;  // since the number was halved
  while (true) {
    const std::size_t conflicts = resolve(work, snap, unit, too_many);
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

/// The log of the changes to points and segments.
std::vector<std::string> summary(const Pslg& old, const Work& work) {
  std::vector<bool> is_old(work.pslg.points.size());
  for (const Index point : work.point_map) is_old[point] = true;
  const auto kept = static_cast<std::size_t>(std::ranges::count(is_old, true));
  std::vector<Index> pieces(old.segments.size());
  for (const Index s : work.source) ++pieces[s];
  std::size_t without_length = 0, covered = 0, split_up = 0;
  for (std::size_t s = 0; s < pieces.size(); ++s) {
    if (pieces[s] > 1) ++split_up;
    if (pieces[s] > 0) continue;
    ++(work.point_map[old.segments[s].a] == work.point_map[old.segments[s].b] ? without_length : covered);
  }
  std::vector<std::string> log;
  const auto note = [&](std::size_t count, const char* what) {
    if (count > 0) log.push_back(std::string(what) + ": " + std::to_string(count) + ".");
  };
  note(old.points.size() - kept, "Points merged into others at the same place, or closer than the snapping distance");
  note(work.pslg.points.size() - kept, "Points added where segments cross");
  note(without_length, "Segments without length dropped");
  note(covered, "Segments dropped that others cover");
  note(split_up, "Segments split where they cross others or have points inside them");
  return log;
}

template <class T>
void erase_at(std::vector<T>& values, const std::vector<Index>& ids) {
  std::vector<bool> goes(values.size());
  for (const Index i : ids) goes[i] = true;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!goes[i]) values[kept++] = values[i];
  values.resize(kept);
}

/// Drops holes and regions that are in no face, and regions in a face that already has a region. Returns the domain, or
/// the problems that remain. Dropping a hole or region can cause another problem, so the steps are repeated in a loop.
Result<ValidPslg, std::vector<Problem>> drop_misplaced_seeds(Work& work, std::vector<std::string>& log) {
  std::vector<Index> hole_source(work.pslg.holes.size()), region_source(work.pslg.regions.size());  // new -> old
  std::iota(hole_source.begin(), hole_source.end(), Index{0});
  std::iota(region_source.begin(), region_source.end(), Index{0});
  while (true) {
    Result<ValidPslg, std::vector<Problem>> domain = validate(std::move(work.pslg));
    if (domain) return domain;
    std::vector<Index> holes, regions;
    std::vector<Problem> rest;
    for (Problem p : domain.error()) {
      const bool of_hole = p.kind == ProblemKind::hole_outside || p.kind == ProblemKind::hole_on_segment;
      const bool of_region = p.kind == ProblemKind::region_outside || p.kind == ProblemKind::region_on_segment;
      if (of_hole) {
        holes.push_back(p.ids[0]);
      } else if (of_region) {
        regions.push_back(p.ids[0]);
      } else if (p.kind == ProblemKind::regions_share_face) {
        regions.push_back(p.ids[1]);
      } else {
        rest.push_back(std::move(p));
        continue;
      }
      p.ids[0] = (of_hole ? hole_source : region_source)[p.ids[0]];
      if (p.ids.size() > 1) p.ids[1] = (of_hole || of_region ? work.source : region_source)[p.ids[1]];
      log.push_back("Dropped: " + p.message(work.pslg.first_id.value));
    }
    if (!rest.empty()) return rest;
    erase_at(work.pslg.holes, holes);
    erase_at(hole_source, holes);
    erase_at(work.pslg.regions, regions);
    erase_at(region_source, regions);
  }
}

/// The problems that repair() cannot remove.
std::vector<Problem> find_unusable_values(const Pslg& pslg) {
  Findings found(20);
  check_values(pslg, 1, found);
  check_region_caps(pslg, found);
  return std::move(found).sorted();
}

}  // namespace

Result<Repaired> repair(const Pslg& pslg, double snap) {
  if (!(snap >= 0) || std::isinf(snap))
    return Error{ErrorKind::usage, "the snapping distance must be zero or positive, and finite"};
  const int base = pslg.first_id.value;
  if (const std::vector<Problem> unusable = find_unusable_values(pslg); !unusable.empty())
    return Error{ErrorKind::invalid_input, messages(unusable, base)};

  Work begin{pslg, std::vector<Index>(pslg.points.size()), std::vector<Index>(pslg.segments.size())};
  std::iota(begin.point_map.begin(), begin.point_map.end(), Index{0});
  std::iota(begin.source.begin(), begin.source.end(), Index{0});
  double largest = 0;
  for (const Point& p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  Work work;
  const bool untangled = std::ranges::any_of(lattice_units, [&](double unit) {
    work = begin;
    return untangle(work, snap, unit * largest);
  });
  if (!untangled)
    return Error{
        ErrorKind::invalid_input,
        "Segments meet so closely that splitting them at rounded crossings makes ever more crossings; a larger "
        "snapping distance may help."};

  std::vector<std::string> log = summary(pslg, work);
  Result<ValidPslg, std::vector<Problem>> domain = drop_misplaced_seeds(work, log);
  if (!domain) return Error{ErrorKind::invalid_input, messages(domain.error(), base)};
  return Repaired{std::move(domain).value(), std::move(work.point_map), std::move(work.source), std::move(log)};
}

}  // namespace pardel
