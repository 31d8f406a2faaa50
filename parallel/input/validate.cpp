#include "../validate.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "../arithmetic/predicates.hpp"
#include "check_values.hpp"
#include "conflicts.hpp"
#include "convex_hull.hpp"
#include "duplicates.hpp"
#include "faces.hpp"
#include "findings.hpp"
#include "segment_index.hpp"

namespace pardel {

using namespace engine;

namespace {

/// The segments that the search for conflicts accepts: both ends exist, are usable and differ. Segments with the same
/// ends occur once. The first of several equal points replaces the others. `id`: the index of each segment in the Pslg.
struct SoundSegments {
  std::vector<Segment> segments;
  std::vector<Index> id;
};

SoundSegments check_each_segment(const Pslg& pslg, std::span<const Duplicate> duplicates, Findings& found) {
  const std::vector<Point>& points = pslg.points;
  const auto first_equal = [&](Index point) {
    const auto at = std::ranges::lower_bound(duplicates, point, {}, &Duplicate::again);
    return at != duplicates.end() && at->again == point ? at->first : point;
  };
  SoundSegments sound;
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    Segment segment = pslg.segments[s];
    if (segment.a >= points.size() || segment.b >= points.size()) continue;
    segment.a = first_equal(segment.a);
    segment.b = first_equal(segment.b);
    if (segment.a == segment.b) {
      found.add(ProblemKind::zero_length_segment, {s}, points[segment.a]);
    } else if (is_usable(points[segment.a]) && is_usable(points[segment.b])) {
      sound.segments.push_back(segment);
      sound.id.push_back(s);
    }
  }
  return sound;
}

void drop_duplicates(const Pslg& pslg, SoundSegments& sound, Findings& found) {
  const auto ends = [&](Index i) { return std::minmax(sound.segments[i].a, sound.segments[i].b); };
  std::vector<Index> order(sound.segments.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, [&](Index i, Index j) { return std::pair(ends(i), i) < std::pair(ends(j), j); });
  std::vector<bool> again(order.size());
  for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
    if (ends(order[k]) != ends(order[first])) {
      first = k;
      continue;
    }
    again[order[k]] = true;
    found.add(ProblemKind::duplicate_segments, {sound.id[order[first]], sound.id[order[k]]},
              pslg.points[sound.segments[order[first]].a]);
  }
  SoundSegments kept;
  for (std::size_t i = 0; i < again.size(); ++i) {
    if (again[i]) continue;
    kept.segments.push_back(sound.segments[i]);
    kept.id.push_back(sound.id[i]);
  }
  sound = std::move(kept);
}

/// The usable points that are not an end of a sound segment. Equal points occur once.
std::vector<Index> loose_points(const Pslg& pslg, std::span<const Segment> segments,
                                std::span<const Duplicate> duplicates) {
  std::vector<bool> is_loose(pslg.points.size());
  for (std::size_t i = 0; i < is_loose.size(); ++i) is_loose[i] = is_usable(pslg.points[i]);
  for (const Duplicate& d : duplicates) is_loose[d.again] = false;
  for (const Segment& s : segments) is_loose[s.a] = is_loose[s.b] = false;
  std::vector<Index> loose;
  for (Index i = 0; i < is_loose.size(); ++i)
    if (is_loose[i]) loose.push_back(i);
  return loose;
}

void check_conflicts(const Pslg& pslg, const SoundSegments& sound, std::span<const Duplicate> duplicates,
                     std::size_t most, Findings& found) {
  if (sound.segments.empty()) return;
  const SegmentIndex index(pslg.points, sound.segments);
  const std::vector<Index> loose = loose_points(pslg, sound.segments, duplicates);
  for (const Conflict& c : find_conflicts(pslg.points, sound.segments, loose, index, most)) {
    const Point where = place_of(c, pslg.points, sound.segments);
    const Index second = sound.id[c.second];
    switch (c.kind) {
      case ConflictKind::crossing:
        found.add(ProblemKind::crossing_segments, {sound.id[c.first], second}, where);
        break;
      case ConflictKind::overlapping:
        found.add(ProblemKind::overlapping_segments, {sound.id[c.first], second}, where);
        break;
      case ConflictKind::point_on_segment:
        found.add(ProblemKind::point_on_segment, {c.first, second}, where);
        break;
    }
  }
}

/// The sides of the convex hull that are not segments.
std::vector<Segment> sides_of_hull(const Pslg& pslg) {
  const auto ends = [](const Segment& s) { return std::pair(std::min(s.a, s.b), std::max(s.a, s.b)); };
  std::vector<std::pair<Index, Index>> known;
  for (const Segment& s : pslg.segments) known.push_back(ends(s));
  std::ranges::sort(known);
  const std::vector<Index> hull = convex_hull(pslg.points);
  std::vector<Segment> sides;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Segment side{hull[i], hull[(i + 1) % hull.size()]};
    if (!std::ranges::binary_search(known, ends(side))) sides.push_back(side);
  }
  return sides;
}

/// Precondition: no problem was found so far.
void check_faces(const Pslg& pslg, bool convex_hull, Findings& found) {
  const bool hull_is_outline = convex_hull || pslg.segments.empty();
  if (hull_is_outline && pslg.holes.empty() && pslg.regions.empty()) return;
  std::vector<Segment> segments = pslg.segments;
  if (hull_is_outline) std::ranges::copy(sides_of_hull(pslg), std::back_inserter(segments));
  const SegmentIndex index(pslg.points, segments);
  const Faces faces(pslg.points, segments, index);
  if (faces.count() == 1) {
    found.add(ProblemKind::unclosed_outline, {}, pslg.points[segments[0].a]);
    return;
  }

  // The face that contains a seed. If the seed is unusable or on a segment, reports a problem and returns no_index.
  const auto face_of = [&](Index id, Point seed, ProblemKind outside, ProblemKind on_segment) {
    if (!is_usable(seed)) {
      found.add(outside, {id}, seed);
      return no_index;
    }
    if (const Index s = index.through(seed); s != no_index) {
      found.add(on_segment, s < pslg.segments.size() ? std::vector{id, s} : std::vector{id}, seed);
      return no_index;
    }
    return faces.containing(seed);
  };

  std::vector<bool> in_domain(faces.count(), true);
  in_domain[Faces::exterior] = false;
  std::vector<Index> holes_in_faces;
  for (Index h = 0; h < pslg.holes.size(); ++h) {
    const Index face = face_of(h, pslg.holes[h], ProblemKind::hole_outside, ProblemKind::hole_on_segment);
    if (face == no_index) continue;
    if (face == Faces::exterior) {
      found.add(ProblemKind::hole_outside, {h}, pslg.holes[h]);
      continue;
    }
    in_domain[face] = false;
    holes_in_faces.push_back(h);
  }
  if (std::ranges::find(in_domain, true) == in_domain.end())
    found.add(ProblemKind::no_domain, holes_in_faces, pslg.holes[holes_in_faces[0]]);

  std::vector<Index> region_of(faces.count(), no_index);
  for (Index r = 0; r < pslg.regions.size(); ++r) {
    const Point seed = pslg.regions[r].seed;
    const Index face = face_of(r, seed, ProblemKind::region_outside, ProblemKind::region_on_segment);
    if (face == no_index) continue;
    if (!in_domain[face])
      found.add(ProblemKind::region_outside, {r}, seed);
    else if (region_of[face] != no_index)
      found.add(ProblemKind::regions_share_face, {region_of[face], r}, seed);
    else
      region_of[face] = r;
  }
}

}  // namespace

std::vector<Problem> find_problems(const Pslg& pslg, const ValidateOptions& options) {
  Findings found(options.max_problems);
  check_values(pslg, options.threads, found);
  const bool usable =
      !found.any(ProblemKind::non_finite_coordinate) && !found.any(ProblemKind::coordinate_out_of_range);
  const std::vector<Duplicate> duplicates = find_duplicates(pslg.points, options.threads);
  for (const Duplicate& d : duplicates)
    found.add(ProblemKind::duplicate_points, {d.first, d.again}, pslg.points[d.first]);
  SoundSegments sound = check_each_segment(pslg, duplicates, found);
  drop_duplicates(pslg, sound, found);
  check_conflicts(pslg, sound, duplicates, options.max_problems, found);
  if (usable && all_collinear(pslg.points))
    found.add(ProblemKind::all_points_collinear, {}, pslg.points.empty() ? Point{} : pslg.points[0]);
  if (found.empty()) check_faces(pslg, options.convex_hull, found);
  check_region_caps(pslg, found);
  return std::move(found).sorted();
}

Result<ValidPslg, std::vector<Problem>> validate(Pslg&& pslg, const ValidateOptions& options) {
  std::vector<Problem> problems = find_problems(pslg, options);
  if (!problems.empty()) return problems;
  const bool convex_hull = options.convex_hull || pslg.segments.empty();
  return ValidPslg(std::move(pslg), convex_hull);
}

Result<ValidPslg, std::vector<Problem>> validate(const Pslg& pslg, const ValidateOptions& options) {
  std::vector<Problem> problems = find_problems(pslg, options);
  if (!problems.empty()) return problems;
  return ValidPslg(pslg, options.convex_hull || pslg.segments.empty());
}

}  // namespace pardel
