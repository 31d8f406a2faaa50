#include "find_problems.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "../arithmetic/predicates.hpp"
#include "../segments/conflicts.hpp"
#include "../segments/plane_sweep.hpp"
#include "check_faces.hpp"
#include "check_values.hpp"
#include "convex_hull.hpp"
#include "duplicates.hpp"
#include "findings.hpp"

namespace pardel::engine {
namespace {

/// The segments that the search for conflicts accepts: both ends exist, are usable and differ. Segments with the same
/// ends occur once. The first of several equal points replaces the others. `id`: the index of each segment in the Pslg.
struct SoundSegments {
  std::vector<Segment> segments;
  std::vector<Index> id;
};

SoundSegments check_each_segment(const Pslg& pslg, std::span<const Duplicate> duplicates, SparseAsk& ask,
                                 Findings& found) {
  const std::vector<Point>& points = pslg.points;
  const auto first_equal = [&](Index point) {
    const auto at = std::ranges::lower_bound(duplicates, point, {}, &Duplicate::again);
    return at != duplicates.end() && at->again == point ? at->first : point;
  };
  SoundSegments sound;
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    ask();
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

void drop_duplicates(const Pslg& pslg, SoundSegments& sound, StopSignal* stop, Findings& found) {
  if (sound.segments.empty()) return;
  SparseAsk ask(stop);
  std::vector<bool> again(sound.segments.size());
  Ends first{no_index, no_index, no_index};
  for (const Ends& ends : sorted_ends(sound.segments, pslg.points.size(), stop)) {
    ask();
    if (ends.low != first.low || ends.high != first.high) {
      first = ends;
      continue;
    }
    again[ends.segment] = true;
    found.add(ProblemKind::duplicate_segments, {sound.id[first.segment], sound.id[ends.segment]},
              pslg.points[sound.segments[first.segment].a]);
  }
  SoundSegments kept;
  for (std::size_t i = 0; i < again.size(); ++i) {
    ask();
    if (again[i]) continue;
    kept.segments.push_back(sound.segments[i]);
    kept.id.push_back(sound.id[i]);
  }
  sound = std::move(kept);
}

/// The usable points that are not an end of a sound segment. Equal points occur once.
std::vector<Index> loose_points(const Pslg& pslg, std::span<const Segment> segments,
                                std::span<const Duplicate> duplicates, SparseAsk& ask) {
  std::vector<bool> is_loose(pslg.points.size());
  for (std::size_t i = 0; i < is_loose.size(); ++i) {
    ask();
    is_loose[i] = is_usable(pslg.points[i]);
  }
  for (const Duplicate& d : duplicates) is_loose[d.again] = false;
  for (const Segment& s : segments) {
    ask();
    is_loose[s.a] = is_loose[s.b] = false;
  }
  std::vector<Index> loose;
  for (Index i = 0; i < is_loose.size(); ++i)
    if (is_loose[i]) loose.push_back(i);
  return loose;
}

/// Returns the result of the sweep, in which the seeds are the queries. Without segments there is no sweep.
Swept check_conflicts(const Pslg& pslg, const SoundSegments& sound, std::span<const Duplicate> duplicates,
                      std::size_t most, const Threads& threads, Findings& found) {
  if (sound.segments.empty()) return {};
  SparseAsk ask(threads.stop);
  const std::vector<Index> loose = loose_points(pslg, sound.segments, duplicates, ask);
  const std::vector<Point> seeds = seeds_of(pslg);
  Swept swept = sweep_plane({.points = pslg.points,
                             .segments = sound.segments,
                             .candidates = loose,
                             .queries = seeds,
                             .most = most,
                             .stop = threads.stop});
  for (const Conflict& c : swept.conflicts) {
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
  return swept;
}

/// Adds all_points_collinear, if the coordinates are usable.
void check_collinear(const Pslg& pslg, const Threads& threads, Findings& found) {
  if (found.any(ProblemKind::non_finite_coordinate) || found.any(ProblemKind::coordinate_out_of_range)) return;
  if (all_collinear(pslg.points, threads))
    found.add(ProblemKind::all_points_collinear, {}, pslg.points.empty() ? Point{} : pslg.points[0]);
}

}  // namespace

std::vector<Problem> find_problems_but_duplicates(const Pslg& pslg, const Threads& threads) {
  Findings found(ValidateOptions{}.max_problems);
  check_values(pslg, threads, found);
  check_collinear(pslg, threads, found);
  return std::move(found).sorted();
}

std::vector<Problem> find_problems(const Pslg& pslg, const ValidateOptions& options, const Threads& threads) {
  Findings found(options.max_problems);
  SparseAsk ask(threads.stop);
  check_values(pslg, threads, found);
  const std::vector<Duplicate> duplicates = find_duplicates(pslg.points, threads);
  for (const Duplicate& d : duplicates)
    found.add(ProblemKind::duplicate_points, {d.first, d.again}, pslg.points[d.first]);
  SoundSegments sound = check_each_segment(pslg, duplicates, ask, found);
  drop_duplicates(pslg, sound, threads.stop, found);
  const Swept swept = check_conflicts(pslg, sound, duplicates, options.max_problems, threads, found);
  check_collinear(pslg, threads, found);
  if (found.empty()) check_faces(pslg, options.convex_hull, swept, threads, found);
  check_region_caps(pslg, found);
  return std::move(found).sorted();
}

Status check_valid(const Pslg& pslg, bool convex_hull, const Threads& threads) {
  const std::vector<Problem> problems = find_problems(pslg, {.convex_hull = convex_hull}, threads);
  if (problems.empty()) return Done{};
  return Error{ErrorKind::invalid_input, messages(problems, pslg.first_id.value)};
}

}  // namespace pardel::engine
