#include "repair_once.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "../../core/support/shortest.hpp"
#include "../arithmetic/box.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "../segments/plane_sweep.hpp"
#include "../validate.hpp"
#include "check_faces.hpp"
#include "check_values.hpp"
#include "findings.hpp"
#include "untangle.hpp"

namespace pardel::engine {
namespace {

std::string number(const Pslg& pslg, Index id) { return std::to_string(std::int64_t{id} + pslg.first_id.value); }

/// For each new point: true if it is the image of an old point, false if it was added at a crossing.
std::vector<bool> images_of_points(const Work& work) {
  std::vector<bool> is_old(work.pslg.points.size());
  for (const Index point : work.point_map) is_old[point] = true;
  return is_old;
}

void add_move(Moved& moved, Index id, double distance) {
  if (!(distance > 0)) return;
  ++moved.count;
  if (distance <= moved.distance) return;
  moved.farthest = id;
  moved.distance = distance;
}

Moved moved_points(const Pslg& old, const Work& work, SparseAsk& ask) {
  Moved moved;
  for (Index i = 0; i < old.points.size(); ++i) {
    ask();
    const Point from = old.points[i], to = work.pslg.points[work.point_map[i]];
    add_move(moved, i, distance(from, to));
  }
  return moved;
}

/// The old segments with pieces that end beside them: at images of other points, or at crossings that were merged into
/// points. Crossings that are only rounded do not count.
Moved bent_segments(const Pslg& old, const Work& work, const std::vector<bool>& is_old, SparseAsk& ask) {
  std::vector<double> distance(old.segments.size());
  for (std::size_t s = 0; s < work.source.size(); ++s) {
    ask();
    if (work.source[s] == no_index) continue;
    const Segment& whole = old.segments[work.source[s]];
    const Point a = old.points[whole.a], b = old.points[whole.b];
    const double rounding = 0x1p-50 * Box::around(a, b).largest_magnitude();
    for (const Index end : {work.pslg.segments[s].a, work.pslg.segments[s].b}) {
      if (end == work.point_map[whole.a] || end == work.point_map[whole.b]) continue;
      const double beside = std::abs(orient2d(a, b, work.pslg.points[end])) / engine::distance(a, b);
      double& farthest = distance[work.source[s]];
      if (is_old[end] || beside > rounding) farthest = std::max(farthest, beside);
    }
  }
  Moved moved;
  for (Index s = 0; s < distance.size(); ++s) add_move(moved, s, distance[s]);
  return moved;
}

/// The log of the changes to points and segments.
std::vector<std::string> summary(const Pslg& old, const Work& work, const std::vector<bool>& is_old) {
  const auto kept = static_cast<std::size_t>(std::ranges::count(is_old, true));
  std::vector<Index> pieces(old.segments.size());
  std::size_t without_length = 0, covered = 0, split_up = 0, of_hull = 0;
  for (const Index s : work.source)
    if (s == no_index)
      ++of_hull;
    else
      ++pieces[s];
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
  note(of_hull, "Segments added as the outline, because points are near sides of the convex hull");
  return log;
}

void note_moves(const Pslg& old, double snap, const Moved& points, const Moved& segments,
                std::vector<std::string>& log) {
  if (points.count > 0)
    log.push_back("Points moved: " + std::to_string(points.count) + "; the farthest, point " +
                  number(old, points.farthest) + " at " + shortest(old.points[points.farthest]) + ", moved by " +
                  shortest(points.distance) + " (snapping distance " + shortest(snap) + ").");
  if (segments.count > 0)
    log.push_back("Segments bent to points near them: " + std::to_string(segments.count) + "; the farthest, segment " +
                  number(old, segments.farthest) + " from " + shortest(old.points[old.segments[segments.farthest].a]) +
                  ", was bent by " + shortest(segments.distance) + " (snapping distance " + shortest(snap) + ").");
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

/// Drops holes and regions.
class Seeds {
 public:
  Seeds(Work& work, SeedRecord& record, StopSignal& stop) : work_(work), record_(record), stop_(stop) {}

  /// Drops those in faces that are gone: inside of old segments that have all become one point.
  void drop_in_vanished_faces(const Pslg& old) {
    const std::map<Index, Vanished> vanished = vanished_segments(old);
    const std::vector<Point> seeds = seeds_of(work_.pslg);
    SparseAsk ask(&stop_);
    std::vector<Index> holes, regions;
    for (std::size_t seed = 0; seed < seeds.size(); ++seed)
      for (const auto& [point, group] : vanished) {
        ask();
        if (!group.box.contains_half_open(seeds[seed]) || !encloses(old, group, seeds[seed])) continue;
        const std::string place = shortest(work_.pslg.points[point]);
        note_drop(seed, seeds[seed], "lies in a face that has become the point " + place + ".", holes, regions);
      }
    drop(holes, regions);
  }

  /// Drops those closer to a segment than the snapping distance.
  void drop_near_segments(const Snapping& snapping) {
    Pslg& pslg = work_.pslg;
    const std::vector<Point> seeds = seeds_of(pslg);
    const Reach reach(snapping, pslg.points, pslg.segments);
    const SweepInput input{
        .points = pslg.points, .segments = pslg.segments, .queries = seeds, .reach = &reach, .stop = &stop_};
    std::vector<Index> holes, regions;
    for (const NearPoint& near : find_near_points(input, sweep_plane(input))) {
      if (near.point < pslg.points.size()) continue;
      const std::size_t seed = near.point - pslg.points.size();
      note_drop(seed, seeds[seed], "is closer to a segment than the snapping distance.", holes, regions);
    }
    drop(holes, regions);
  }

  /// Drops holes and regions that are in no face. Of the regions in one face it keeps the last. Returns the domain, or
  /// the problems that remain. Dropping a hole or region can cause another problem, so the steps are repeated.
  Result<ValidPslg, std::vector<Problem>> drop_misplaced(bool convex_hull) {
    const auto go_on = [this] {
      stop_.ask_now();
      return true;
    };
    while (true) {
      Result<ValidPslg, std::vector<Problem>> domain =
          validate(std::move(work_.pslg), {.convex_hull = convex_hull, .go_on = go_on});
      stop_.ask();  // throws if the validation was stopped
      if (domain) return domain;
      std::vector<Index> holes, regions;
      std::vector<Problem> rest;
      for (Problem p : domain.error()) {
        const bool of_hole = p.kind == ProblemKind::hole_outside || p.kind == ProblemKind::hole_on_segment;
        const bool of_region = p.kind == ProblemKind::region_outside || p.kind == ProblemKind::region_on_segment;
        if (of_hole) {
          holes.push_back(p.ids[0]);
        } else if (of_region || p.kind == ProblemKind::regions_share_face) {
          regions.push_back(p.ids[0]);
        } else {
          rest.push_back(std::move(p));
          continue;
        }
        p.ids[0] = (of_hole ? record_.hole_source : record_.region_source)[p.ids[0]];
        if (p.ids.size() > 1) p.ids[1] = (of_hole || of_region ? work_.source : record_.region_source)[p.ids[1]];
        if (p.ids.size() > 1 && p.ids[1] == no_index) {  // on a side of the hull
          p.kind = of_hole ? ProblemKind::hole_outside : ProblemKind::region_outside;
          p.ids.pop_back();
        }
        record_.dropped.push_back("Dropped: " + p.message(work_.pslg.first_id.value));
      }
      if (!rest.empty()) return rest;
      drop(holes, regions);
    }
  }

 private:
  /// Old segments of which both ends have become the same point.
  struct Vanished {
    Box box = empty_box;
    std::vector<Index> segments;
  };
  /// By this point.
  [[nodiscard]] std::map<Index, Vanished> vanished_segments(const Pslg& old) const {
    std::map<Index, Vanished> by_point;
    for (Index s = 0; s < old.segments.size(); ++s) {
      const Index at = work_.point_map[old.segments[s].a];
      if (at != work_.point_map[old.segments[s].b]) continue;
      Vanished& group = by_point[at];
      group.box.cover(Box::around(old.points[old.segments[s].a], old.points[old.segments[s].b]));
      group.segments.push_back(s);
    }
    return by_point;
  }

  /// Do the rays from p to the right and to the left each cross the segments an odd number of times? Around an open
  /// chain, at most one of them does.
  [[nodiscard]] static bool encloses(const Pslg& old, const Vanished& group, Point p) {
    bool is_odd_on_right = false, is_odd_on_left = false;
    for (const Index s : group.segments) {
      Point low = old.points[old.segments[s].a], high = old.points[old.segments[s].b];
      if (low.y > high.y) std::swap(low, high);
      if (p.y < low.y || p.y >= high.y) continue;
      const double side = orient2d(low, high, p);
      if (side > 0) is_odd_on_right = !is_odd_on_right;
      if (side < 0) is_odd_on_left = !is_odd_on_left;
    }
    return is_odd_on_right && is_odd_on_left;
  }

  /// Adds a seed, in the order of seeds_of(), to the holes or regions that are dropped, and a line to the log.
  void note_drop(std::size_t seed, Point at, const std::string& why, std::vector<Index>& holes,
                 std::vector<Index>& regions) {
    const std::size_t hole_count = work_.pslg.holes.size();
    const bool is_hole = seed < hole_count;
    const auto id = static_cast<Index>(is_hole ? seed : seed - hole_count);
    std::vector<Index>& ids = is_hole ? holes : regions;
    if (std::ranges::find(ids, id) != ids.end()) return;
    ids.push_back(id);
    record_.dropped.push_back("Dropped: " + std::string(is_hole ? "Hole " : "Region ") +
                              number(work_.pslg, (is_hole ? record_.hole_source : record_.region_source)[id]) + " at " +
                              shortest(at) + " " + why);
  }

  void drop(const std::vector<Index>& holes, const std::vector<Index>& regions) {
    erase_at(work_.pslg.holes, holes);
    erase_at(record_.hole_source, holes);
    erase_at(work_.pslg.regions, regions);
    erase_at(record_.region_source, regions);
  }

  Work& work_;
  SeedRecord& record_;
  StopSignal& stop_;
};

}  // namespace

std::vector<Problem> find_unusable_values(const Pslg& pslg, StopSignal& stop) {
  Findings found(20);
  check_values(pslg, {1, &stop}, found);
  check_region_caps(pslg, found);
  return std::move(found).sorted();
}

std::optional<Result<RepairStage>> repair_once(const Pslg& pslg, const Snapping& snapping, bool convex_hull,
                                               StopSignal& stop, const RepairStage* from) {
  Work work = from == nullptr
                  ? Work{pslg, identity_map(pslg.points.size()), identity_map(pslg.segments.size())}
                  : Work{from->repaired.domain.pslg(), from->repaired.point_map, from->repaired.segment_map};
  SeedRecord record = from == nullptr
                          ? SeedRecord{identity_map(pslg.holes.size()), identity_map(pslg.regions.size()), {}}
                          : from->seeds;
  const double largest_snap = Reach(snapping, work.pslg.points, work.pslg.segments).largest();
  if (!untangle(work, snapping, stop)) return std::nullopt;
  const bool is_hull = convex_hull || work.pslg.segments.empty();
  const bool is_outline_drawn = is_hull && draw_hull_if_points_are_near(work, snapping, stop);

  const std::vector<bool> is_old = images_of_points(work);
  SparseAsk ask(&stop);
  const Moved points = moved_points(pslg, work, ask), segments = bent_segments(pslg, work, is_old, ask);
  Seeds seeds(work, record, stop);
  if (points.count > 0) seeds.drop_in_vanished_faces(pslg);
  if (points.count + segments.count > 0 || is_outline_drawn) seeds.drop_near_segments(snapping);
  std::vector<std::string> log = summary(pslg, work, is_old);
  note_moves(pslg, largest_snap, points, segments, log);
  Result<ValidPslg, std::vector<Problem>> domain = seeds.drop_misplaced(convex_hull && !is_outline_drawn);
  if (!domain) return Error{ErrorKind::invalid_input, messages(domain.error(), pslg.first_id.value)};
  log.insert(log.end(), record.dropped.begin(), record.dropped.end());
  return RepairStage{Repaired{std::move(domain).value(), std::move(work.point_map), std::move(work.source),
                              std::move(log), largest_snap, points, segments},
                     std::move(record)};
}

}  // namespace pardel::engine
