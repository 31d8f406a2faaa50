// Validation and repair. On a lattice, validate() must agree with the definition in exact integers. A repaired domain
// must be valid, every old point and segment must be in it, within the distances that the result names, nothing may be
// closer than the snapping distance allows, and repairing it again must change nothing.
#include "../parallel/repair.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "../properties/domains/generators/lattice_domain.hpp"
#include "distances.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

/// The Pslg on the lattice of a quarter of its unit, on which seeds of strokes are not. Empty if a coordinate is not on
/// the lattice.
std::optional<generators::LatticeDomain> on_lattice(const Pslg& pslg) {
  generators::LatticeDomain domain;
  const auto exact = [](Point p, double unit) -> std::optional<generators::LatticePoint> {
    const double x = p.x / unit, y = p.y / unit;
    if (x != std::floor(x) || y != std::floor(y) || std::abs(x) > 1e7 || std::abs(y) > 1e7) return {};
    return generators::LatticePoint{static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
  };
  constexpr double unit = 1.0 / 64;
  domain.exponent = 6;
  for (const Point p : pslg.points) {
    const auto q = exact(p, unit);
    if (!q) return {};
    domain.points.push_back(*q);
  }
  domain.segments = pslg.segments;
  for (const Point hole : pslg.holes) {
    const auto q = exact(hole, unit / 4);
    if (!q) return {};
    domain.holes.push_back(*q);
  }
  for (const Region& region : pslg.regions) {
    const auto q = exact(region.seed, unit / 4);
    if (!q) return {};
    domain.regions.push_back({*q, region.attribute, region.max_area});
  }
  return domain;
}

void compare_with_the_definition(const Pslg& pslg) {
  const auto domain = on_lattice(pslg);
  if (!domain) return;
  const std::vector<Problem> problems = find_problems(pslg);
  if (is_valid(*domain) == problems.empty()) return;
  fail(problems.empty() ? "validation finds no problem, but the domain is not valid by definition"
                        : "the domain is valid by definition, but validation says: " + problems.front().message());
}

/// The domain before and after the repair.
class Comparison {
 public:
  Comparison(const Pslg& before, const Repaired& repaired)
      : before_(before), repaired_(repaired), after_(repaired.domain.pslg()) {
    for (const Point p : before.points) largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y)});
  }

  void judge() const {
    check_maps();
    check_moved_points();
    check_pieces();
    for (Index s = 0; s < before_.segments.size(); ++s) check_that_it_is_covered(s);
    check_gaps();
  }

 private:
  /// Every new index must be that of a point or segment.
  void check_maps() const {
    if (repaired_.point_map.size() != before_.points.size()) fail("the map of points has the wrong length");
    for (const Index to : repaired_.point_map)
      if (to >= after_.points.size()) fail("the map of points leads to no point");
    if (repaired_.segment_map.size() != after_.segments.size()) fail("the map of segments has the wrong length");
    for (const Index from : repaired_.segment_map)
      if (from >= before_.segments.size()) fail("the map of segments leads to no segment");
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
  [[nodiscard]] double rounding() const { return 0x1p-50 * largest_; }

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

  void check_gaps() const {
    const double least = repaired_.snap * (1 - 0x1p-30) - rounding();
    for (Index p = 0; p < after_.points.size(); ++p) {
      const Point at = after_.points[p];
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

  const Pslg& before_;
  const Repaired& repaired_;
  const Pslg& after_;
  double largest_ = 0;  ///< magnitude of a coordinate
};

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const MeshCase drawn = decode_mesh_case(bytes);
  if (!drawn.goal.convex_hull) compare_with_the_definition(drawn.pslg);

  RepairOptions options{.convex_hull = drawn.goal.convex_hull};
  if (drawn.seed % 3 == 1) options.snap = 0;
  if (drawn.seed % 3 == 2) options.snap = std::ldexp(default_snap(drawn.pslg), static_cast<int>(drawn.seed / 3 % 32));
  const Result<Repaired> once = repair(drawn.pslg, options);
  const bool is_valid_before = find_problems(drawn.pslg, {.convex_hull = options.convex_hull}).empty();
  if (is_valid_before && options.snap == 0.0 && !(once && once->log.empty() && once->domain.pslg() == drawn.pslg))
    fail("the repair of a valid domain without snapping changes it");
  if (!once) {
    if (once.error().kind == ErrorKind::internal || once.error().message.empty())
      fail("repair ends with an internal error: " + once.error().message);
    return 0;
  }
  const Pslg& repaired = once->domain.pslg();
  if (const auto problems = find_problems(repaired, {.convex_hull = options.convex_hull}); !problems.empty())
    fail("the repaired domain is not valid: " + problems.front().message());
  Comparison(drawn.pslg, *once).judge();

  if (options.snap) options.snap = once->snap;
  const Result<Repaired> twice = repair(repaired, options);
  if (!twice) fail("a repaired domain cannot be repaired: " + twice.error().message);
  if (!twice->log.empty()) fail("repairing again changes the domain: " + twice->log.front());
  if (twice->domain.pslg() != repaired) fail("repairing again changes the domain and does not say so");
  return 0;
}

}  // namespace pardel::fuzz
