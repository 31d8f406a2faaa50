#include "repaired_domain.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "../core/support/shortest.hpp"
#include "distances.hpp"
#include "fuzz_one.hpp"

namespace pardel::fuzz {
namespace {

/// The domain before and after the repair.
class Comparison {
 public:
  Comparison(const Pslg& before, const Repaired& repaired, const RepairOptions& options)
      : before_(before),
        repaired_(repaired),
        after_(repaired.domain.pslg()),
        convex_hull_(options.convex_hull),
        snap_is_given_(options.snap.has_value()),
        rounding_(0x1p-50 * largest_magnitude(before)) {}

  void judge() const {
    check_maps();
    check_moved_points();
    check_pieces();
    for (Index s = 0; s < before_.segments.size(); ++s) check_that_it_is_covered(s);
    check_gaps();
    check_values_of_points();
    check_holes_and_regions();
  }

 private:
  /// Every new index must be that of a point or segment.
  void check_maps() const {
    if (repaired_.point_map.size() != before_.points.size()) fail("the map of points has the wrong length");
    for (const Index to : repaired_.point_map)
      if (to >= after_.points.size()) fail("the map of points leads to no point");
    if (repaired_.segment_map.size() != after_.segments.size()) fail("the map of segments has the wrong length");
    for (const Index from : repaired_.segment_map)
      if (from >= before_.segments.size() && !(from == no_index && repaired_.snap > 0))
        fail("the map of segments leads to no segment");
  }

  void check_moved_points() const {
    for (Index p = 0; p < before_.points.size(); ++p)
      if (distance(before_.points[p], after_.points[repaired_.point_map[p]]) >
          repaired_.moved_points.distance + rounding())
        fail("point " + std::to_string(p) + " moved farther than the repair says");
  }

  /// How far a piece may be from the old segment that it is mapped to: its ends may move, and between them it may be
  /// bent.
  [[nodiscard]] double bend() const {
    return repaired_.moved_points.distance + repaired_.bent_segments.distance + 2 * rounding();
  }
  /// How far it may be from other old segments that it stands for. A segment is bent to points near it, and again to
  /// points near its pieces: three times the snapping distance was seen. Without snapping, the same happens at rounded
  /// crossings.
  [[nodiscard]] double several_bends() const { return 8 * (repaired_.snap + rounding()); }
  /// Crossings are rounded.
  [[nodiscard]] double rounding() const { return rounding_; }

  [[nodiscard]] double distance_to(Index old, Point p) const {
    const Segment& s = before_.segments[old];
    return distance(p, before_.points[s.a], before_.points[s.b]);
  }

  [[nodiscard]] bool is_near(const Segment& piece, Index old, double tolerance) const {
    return std::max(distance_to(old, after_.points[piece.a]), distance_to(old, after_.points[piece.b])) <= tolerance;
  }

  /// True if the piece has the marker of the old segment, or of another one that it lies on if that has none.
  [[nodiscard]] bool has_its_marker(const Segment& piece, Index old) const {
    if (piece.marker == before_.segments[old].marker) return true;
    if (before_.segments[old].marker != 0) return false;
    for (Index other = 0; other < before_.segments.size(); ++other)
      if (piece.marker == before_.segments[other].marker && is_near(piece, other, several_bends())) return true;
    return false;
  }

  void check_pieces() const {
    for (Index s = 0; s < after_.segments.size(); ++s) {
      const Segment& piece = after_.segments[s];
      const Index old = repaired_.segment_map[s];
      if (old == no_index) continue;
      if (!is_near(piece, old, bend()))
        fail("segment " + std::to_string(s) + " does not lie on segment " + std::to_string(old) + " of the old domain");
      if (!has_its_marker(piece, old))
        fail("segment " + std::to_string(s) + " has another marker than segment " + std::to_string(old) +
             " of the old domain");
    }
  }

  /// The ends of an old segment are connected by pieces that lie near it.
  void check_that_it_is_covered(Index old) const {
    std::vector<Index> leader(after_.points.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](Index p) {
      while (leader[p] != p) p = leader[p] = leader[leader[p]];
      return p;
    };
    for (const Segment& piece : after_.segments)
      if (is_near(piece, old, several_bends())) leader[find(piece.a)] = find(piece.b);
    const Segment& s = before_.segments[old];
    if (find(repaired_.point_map[s.a]) != find(repaired_.point_map[s.b]))
      fail("segment " + std::to_string(old) + " of the old domain is not covered by new ones");
  }

  /// The least distance of two points at a place. Without a given distance it is a share of the coordinates there, or
  /// more. The share is not known if some gaps were closed with larger distances.
  [[nodiscard]] double least_distance_at(Point p) const {
    if (snap_is_given_) return repaired_.snap * (1 - 0x1p-30) - rounding();
    for (const double factor : {1.0, 0x1p-4, 0x1p-8, 0x1p-12}) {
      const double snap = factor * default_snap(before_);
      if (std::abs(repaired_.snap - snap) <= 0x1p-30 * snap)
        return factor * 0x1p-38 * std::max(std::abs(p.x), std::abs(p.y)) * (1 - 0x1p-30) - rounding();
    }
    return 0;
  }

  void check_gaps() const {
    for (Index p = 0; p < after_.points.size(); ++p) {
      const Point at = after_.points[p];
      const double least = least_distance_at(at);
      for (Index q = 0; q < p; ++q)
        if (distance(at, after_.points[q]) < least)
          fail("points " + std::to_string(q) + " and " + std::to_string(p) + " are closer than the snapping distance");
      for (Index s = 0; s < after_.segments.size(); ++s) {
        const Segment& segment = after_.segments[s];
        if (segment.a != p && segment.b != p &&
            distance(at, after_.points[segment.a], after_.points[segment.b]) < least / 2)
          fail("point " + std::to_string(p) + " is too close to segment " + std::to_string(s));
      }
    }
  }

  /// A point has the attributes and the marker of one of the old points that became it. A point at a crossing has the
  /// marker of a segment, and interpolated attributes.
  void check_values_of_points() const {
    if (after_.attributes_per_point != before_.attributes_per_point ||
        after_.point_attributes.size() != after_.points.size() * after_.attributes_per_point)
      fail("there is not one row of attributes per point");
    if (after_.point_markers.size() != after_.points.size()) fail("there is not one marker per point");
    std::vector<bool> is_image(after_.points.size()), has_values(after_.points.size());
    for (Index p = 0; p < before_.points.size(); ++p) {
      const Index to = repaired_.point_map[p];
      is_image[to] = true;
      if (before_.point_markers[p] == after_.point_markers[to] && std::ranges::equal(row(before_, p), row(after_, to)))
        has_values[to] = true;
    }
    for (Index p = 0; p < after_.points.size(); ++p) {
      if (is_image[p] && !has_values[p]) fail("point " + std::to_string(p) + " has the values of no old point");
      if (!is_image[p]) check_values_of_a_crossing(p);
    }
  }

  [[nodiscard]] static std::span<const double> row(const Pslg& pslg, Index p) {
    return std::span(pslg.point_attributes).subspan(p * pslg.attributes_per_point, pslg.attributes_per_point);
  }

  void check_values_of_a_crossing(Index p) const {
    for (std::size_t k = 0; k < linear_attributes.size(); ++k) {
      const Linear& linear = linear_attributes[k];
      const double tolerance = linear.slope() * (repaired_.moved_points.distance + several_bends());
      if (!(std::abs(row(after_, p)[k] - linear(after_.points[p])) <= tolerance))
        fail("attribute " + std::to_string(k) + " of point " + std::to_string(p) + " is not interpolated: it is " +
             shortest(row(after_, p)[k]) + ", not " + shortest(linear(after_.points[p])));
    }
    for (Index s = 0; s < before_.segments.size(); ++s)
      if (before_.segments[s].marker == after_.point_markers[p] && distance_to(s, after_.points[p]) <= several_bends())
        return;
    fail("point " + std::to_string(p) + " has the marker of no segment at it");
  }

  void check_holes_and_regions() const {
    check_seeds(
        &Pslg::holes, [](Point hole) { return hole; }, "hole");
    check_seeds(
        &Pslg::regions, [](const Region& region) { return region.seed; }, "region");
  }

  /// The holes, or the regions, are old ones, in their order. With one of the others, the domain would not be valid, or
  /// something was snapped and the seed is near a segment, or in a face of which all segments have become one point.
  template <class Seed, class PlaceOf>
  void check_seeds(std::vector<Seed> Pslg::*seeds, const PlaceOf& place_of, const std::string& what) const {
    std::size_t kept = 0;
    for (const Seed& seed : before_.*seeds) {
      if (kept < (after_.*seeds).size() && (after_.*seeds)[kept] == seed) {
        ++kept;
        continue;
      }
      Pslg with = after_;
      (with.*seeds).push_back(seed);
      const Point at = place_of(seed);
      if (is_valid(with) && !is_near_a_segment(at) && !is_in_a_vanished_face(at))
        fail("a " + what + " was dropped without a reason");
    }
    if (kept != (after_.*seeds).size()) fail("the repaired domain has another " + what);
  }

  [[nodiscard]] bool is_valid(const Pslg& pslg) const {
    return find_problems(pslg, {.convex_hull = convex_hull_}).empty();
  }

  [[nodiscard]] bool is_near_a_segment(Point p) const {
    return std::ranges::any_of(after_.segments, [&](const Segment& s) {
      return distance(p, after_.points[s.a], after_.points[s.b]) <= repaired_.snap + rounding();
    });
  }

  /// For some point: do the old segments that have become this point wind around p?
  [[nodiscard]] bool is_in_a_vanished_face(Point p) const {
    for (Index to = 0; to < after_.points.size(); ++to) {
      int on_right = 0, on_left = 0;
      for (const Segment& s : before_.segments) {
        if (repaired_.point_map[s.a] != to || repaired_.point_map[s.b] != to) continue;
        const Point a = before_.points[s.a], b = before_.points[s.b];
        if ((a.y <= p.y) == (b.y <= p.y)) continue;
        ++(a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x ? on_right : on_left);
      }
      if (on_right % 2 == 1 && on_left % 2 == 1) return true;
    }
    return false;
  }

  const Pslg& before_;
  const Repaired& repaired_;
  const Pslg& after_;
  bool convex_hull_, snap_is_given_;
  double rounding_;  ///< of a computed coordinate
};

}  // namespace

double Linear::slope() const { return std::hypot(by_x, by_y); }

void compare_with_repaired(const Pslg& before, const Repaired& repaired, const RepairOptions& options) {
  Comparison(before, repaired, options).judge();
}

}  // namespace pardel::fuzz
