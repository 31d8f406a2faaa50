// Tests domains for validity. Every function follows the definition literally.
#include <algorithm>
#include <cstdlib>
#include <set>

#include "lattice/determinants.hpp"
#include "lattice/faces.hpp"

namespace pardel::generators {
namespace {

bool within(LatticePoint p, std::int64_t bound) { return std::abs(p.x) <= bound && std::abs(p.y) <= bound; }

bool numbers_are_in_range(const LatticeDomain& d) {
  const auto usable = [](LatticePoint p) { return within(p, largest_lattice_coordinate); };
  const auto usable_seed = [](LatticePoint p) { return within(p, 4 * largest_lattice_coordinate); };
  return std::ranges::all_of(d.points, usable) && std::ranges::all_of(d.holes, usable_seed) &&
         std::ranges::all_of(d.regions, usable_seed, &LatticeRegion::seed) && within(d.offset, largest_offset) &&
         std::abs(d.exponent) <= largest_exponent;
}

bool points_are_distinct(std::vector<LatticePoint> points) {
  std::ranges::sort(points);
  return std::ranges::adjacent_find(points) == points.end();
}

bool all_on_a_line(const std::vector<LatticePoint>& points) {
  return points.size() < 3 ||
         std::ranges::all_of(points, [&](LatticePoint p) { return turn(points[0], points[1], p) == 0; });
}

/// Every segment joins two different points, and no two segments join the same points.
bool segments_have_ends(const LatticeDomain& d) {
  std::vector<std::pair<Index, Index>> ends;
  for (const Segment& s : d.segments) {
    if (s.a >= d.points.size() || s.b >= d.points.size() || s.a == s.b) return false;
    ends.push_back(std::minmax(s.a, s.b));
  }
  std::ranges::sort(ends);
  return std::ranges::adjacent_find(ends) == ends.end();
}

bool a_segment_runs_through_a_point(const LatticeDomain& d) {
  return std::ranges::any_of(d.segments, [&](const Segment& s) {
    return std::ranges::any_of(d.points, [&](LatticePoint p) { return lies_inside(p, d.points[s.a], d.points[s.b]); });
  });
}

bool segments_cross(const LatticeDomain& d) {
  for (std::size_t i = 0; i < d.segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Segment &s = d.segments[i], &t = d.segments[j];
      if (cross_each_other(d.points[s.a], d.points[s.b], d.points[t.a], d.points[t.b])) return true;
    }
  return false;
}

/// Precondition: the segments are valid.
bool faces_are_sound(const LatticeDomain& d) {
  LatticeFaces faces(d.points, d.segments);
  for (const LatticePoint hole : d.holes) {
    if (faces.on_a_segment(hole)) return false;
    const Index face = faces.containing(hole);
    if (face == LatticeFaces::exterior) return false;
    faces.make_hole(face);
  }
  if (faces.domain_faces() == 0) return false;  // the outline is open, or holes remove every face
  std::set<Index> claimed;
  return std::ranges::all_of(d.regions, [&](const LatticeRegion& region) {
    if (!(region.max_area > 0) || faces.on_a_segment(region.seed)) return false;
    const Index face = faces.containing(region.seed);
    return faces.is_domain(face) && claimed.insert(face).second;
  });
}

}  // namespace

bool is_valid(const LatticeDomain& domain) {
  return numbers_are_in_range(domain) && points_are_distinct(domain.points) && !all_on_a_line(domain.points) &&
         segments_have_ends(domain) && !a_segment_runs_through_a_point(domain) && !segments_cross(domain) &&
         faces_are_sound(domain);
}

}  // namespace pardel::generators
