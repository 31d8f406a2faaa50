// Conflicts, faces and repair on random segments that cross, overlap and touch. The results are compared with exact
// constructions and with properties that they must have.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <variant>

#include "../../../parallel/repair.hpp"
#include "../../../parallel/segments/conflicts.hpp"
#include "../../../parallel/segments/faces.hpp"
#include "../../../parallel/segments/plane_sweep.hpp"
#include "../../../parallel/segments/reach.hpp"
#include "../../../parallel/validate.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/shares.hpp"
#include "invalid_domains.hpp"

namespace pardel::engine {
namespace {

using properties::Exhibit;
using K = CGAL::Exact_predicates_exact_constructions_kernel;

K::Point_2 exact(Point p) { return {p.x, p.y}; }
K::Segment_2 exact(const Pslg& pslg, Index s) {
  return {exact(pslg.points[pslg.segments[s].a]), exact(pslg.points[pslg.segments[s].b])};
}
bool is_end(const K::Segment_2& s, const K::Point_2& p) { return p == s.source() || p == s.target(); }

/// Finds the conflicts by definition: tests all pairs of segments, and all pairs of a point and a segment.
std::vector<Conflict> conflicts_by_definition(const Pslg& pslg) {
  std::vector<Conflict> conflicts;
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    const K::Segment_2 first = exact(pslg, s);
    for (Index p = 0; p < pslg.points.size(); ++p)
      if (first.has_on(exact(pslg.points[p])) && !is_end(first, exact(pslg.points[p])))
        conflicts.push_back({ConflictKind::point_on_segment, p, s});
    for (Index t = s + 1; t < pslg.segments.size(); ++t) {
      const K::Segment_2 second = exact(pslg, t);
      const auto common = CGAL::intersection(first, second);
      if (!common) continue;
      const auto* point = boost::get<K::Point_2>(&*common);
      if (point == nullptr)
        conflicts.push_back({ConflictKind::overlapping, s, t});
      else if (!is_end(first, *point) && !is_end(second, *point))
        conflicts.push_back({ConflictKind::crossing, s, t});
    }
  }
  std::ranges::sort(conflicts);
  return conflicts;
}

constexpr const char* messes = "segments that cross, overlap and touch, on four lattices";

Pslg some_mess(Exhibit& exhibit) {
  Pslg pslg = *testing::mess();
  exhibit.show(pslg);
  return pslg;
}

std::vector<Index> points_of_no_segment(const Pslg& pslg) {
  std::set<Index> ends;
  for (const Segment& s : pslg.segments) ends.insert({s.a, s.b});
  std::vector<Index> loose;
  for (Index i = 0; i < pslg.points.size(); ++i)
    if (!ends.contains(i)) loose.push_back(i);
  return loose;
}

PARDEL_PROPERTY(Conflicts, are_those_of_the_definition,
                {.statement = "the conflicts found are those that pairwise intersection in rational arithmetic finds",
                 .source = "parallel/segments/conflicts.hpp",
                 .families = messes}) {
  const Pslg pslg = some_mess(exhibit);
  const std::vector<Index> loose = points_of_no_segment(pslg);
  const Swept swept = sweep_plane({.points = pslg.points, .segments = pslg.segments, .candidates = loose});
  RC_ASSERT(swept.conflicts == conflicts_by_definition(pslg));
}

PARDEL_PROPERTY(Conflicts, have_their_crossing_where_rational_arithmetic_has_it,
                {.statement = "the place of a crossing is the exact intersection up to rounding of each coordinate",
                 .source = "parallel/segments/conflicts.hpp",
                 .families = messes}) {
  const Pslg pslg = some_mess(exhibit);
  for (const Conflict& c : sweep_plane({.points = pslg.points, .segments = pslg.segments}).conflicts) {
    if (c.kind != ConflictKind::crossing) continue;
    const auto common = CGAL::intersection(exact(pslg, c.first), exact(pslg, c.second));
    const K::Point_2 truth = *boost::get<K::Point_2>(&*common);
    const Point place = place_of(c, pslg.points, pslg.segments);
    const auto is_near = [](double x, const K::FT& exact_x) {
      return CGAL::abs(K::FT(x) - exact_x) <= K::FT(0x1p-51) * CGAL::abs(exact_x);
    };
    RC_ASSERT(is_near(place.x, truth.x()) && is_near(place.y, truth.y()));
  }
}

/// Random segments after repair. The faces have all shapes, with islands and dangling ends.
Pslg some_planar_graph(Exhibit& exhibit) {
  const Pslg pslg = some_mess(exhibit);
  Result<Repaired> result = repair(pslg, {.snap = 0});
  RC_ASSERT(result.ok());
  return std::move(result->domain).pslg();
}

Index number_of_components(const Pslg& pslg, Index& vertices) {
  std::vector<Index> parent(pslg.points.size());
  for (Index i = 0; i < parent.size(); ++i) parent[i] = i;
  const auto root = [&](Index i) {
    while (parent[i] != i) i = parent[i];
    return i;
  };
  std::set<Index> ends;
  for (const Segment& s : pslg.segments) {
    ends.insert({s.a, s.b});
    parent[root(s.a)] = root(s.b);
  }
  vertices = static_cast<Index>(ends.size());
  return static_cast<Index>(std::ranges::count_if(ends, [&](Index i) { return parent[i] == i; }));
}

PARDEL_PROPERTY(Faces, are_as_many_as_eulers_formula_says,
                {.statement = "faces + vertices = segments + 1 + components",
                 .source = "parallel/segments/faces.hpp",
                 .families = messes}) {
  const Pslg pslg = some_planar_graph(exhibit);
  const Swept swept = sweep_plane({.points = pslg.points, .segments = pslg.segments});
  Index vertices = 0;
  const Index components = number_of_components(pslg, vertices);
  RC_ASSERT(Faces(pslg.points, pslg.segments, swept.below).count() + vertices == pslg.segments.size() + 1 + components);
}

PARDEL_PROPERTY(Faces, change_across_a_segment_and_nowhere_else,
                {.statement = "along a straight walk, the face changes at the segments that are crossed, from one of "
                              "their sides to the other",
                 .source = "parallel/segments/faces.hpp",
                 .families = messes}) {
  const Pslg pslg = some_planar_graph(exhibit);
  const double extent = pslg.points.back().y;
  const auto anywhere = rc::gen::map(rc::gen::inRange(-50, 1100), [=](int k) { return k * 0.001 * extent; });
  const Point p{*anywhere, *anywhere}, q{*anywhere, *anywhere};
  const std::vector<Point> places{p, q, {-extent, *anywhere}};
  const Swept swept = sweep_plane({.points = pslg.points, .segments = pslg.segments, .queries = places});
  RC_PRE(p != q && swept.through[0] == no_index && swept.through[1] == no_index);
  const Faces faces(pslg.points, pslg.segments, swept.below);
  const auto containing = [&](std::size_t place) { return faces.above(swept.below[pslg.points.size() + place]); };

  // Walk from p to q across the segments between them, but not through their ends.
  const K::Segment_2 walk(exact(p), exact(q));
  std::vector<std::pair<K::FT, Index>> crossed;
  for (Index s = 0; s < pslg.segments.size(); ++s) {
    const K::Segment_2 segment = exact(pslg, s);
    const auto common = CGAL::intersection(walk, segment);
    if (!common) continue;
    const auto* point = boost::get<K::Point_2>(&*common);
    const bool inside = point != nullptr && !is_end(segment, *point);
    RC_PRE(inside);  // a named variable, because RapidCheck cannot show a pointer
    crossed.emplace_back(CGAL::squared_distance(exact(p), *point), s);
  }
  std::ranges::sort(crossed);
  Index face = containing(0);
  for (const auto& [distance, s] : crossed) {
    const K::Segment_2 segment = exact(pslg, s);
    const bool p_is_left = CGAL::left_turn(segment.source(), segment.target(), exact(p));
    RC_ASSERT((p_is_left ? faces.left_of(s) : faces.right_of(s)) == face);
    face = p_is_left ? faces.right_of(s) : faces.left_of(s);
  }
  RC_ASSERT(face == containing(1));
  RC_ASSERT(containing(2) == Faces::exterior);
}

double distance_to(const Pslg& pslg, Index s, Point p) {
  const Point a = pslg.points[pslg.segments[s].a], b = pslg.points[pslg.segments[s].b];
  const double ux = b.x - a.x, uy = b.y - a.y, wx = p.x - a.x, wy = p.y - a.y;
  const double t = std::clamp((ux * wx + uy * wy) / (ux * ux + uy * uy), 0.0, 1.0);
  return std::hypot(wx - t * ux, wy - t * uy);
}

PARDEL_PROPERTY(Repair, leaves_no_problem,
                {.statement = "the repaired domain is valid", .source = "parallel/repair.hpp", .families = messes}) {
  const Result<Repaired> result = repair(some_mess(exhibit), {.snap = 0});
  RC_ASSERT(result.ok());
  RC_ASSERT(find_problems(result->domain.pslg()).empty());
}

PARDEL_PROPERTY(Repair, repairing_twice_changes_nothing,
                {.statement = "repairing a repaired domain changes nothing",
                 .source = "parallel/repair.hpp",
                 .families = messes}) {
  const Pslg once = some_planar_graph(exhibit);
  const Result<Repaired> twice = repair(once, {.snap = 0});
  RC_ASSERT(twice.ok());
  RC_ASSERT(twice->domain.pslg() == once);
  RC_ASSERT(twice->log.empty());
}

PARDEL_PROPERTY(Repair, gives_added_points_the_value_of_an_affine_attribute,
                {.statement = "if an attribute is an affine function of the coordinates, each point that repair adds "
                              "to a segment has the value of this function, wherever on the segment it lies",
                 .source = "parallel/repair.hpp",
                 .families = messes}) {
  Pslg pslg = some_mess(exhibit);
  double extent = 0;
  for (const Point p : pslg.points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  const auto affine = [=](Point p) { return 3 * p.x - 2 * p.y + 0.25 * extent; };
  pslg.attributes_per_point = 2;
  pslg.point_attributes.clear();
  for (const Point p : pslg.points) pslg.point_attributes.insert(pslg.point_attributes.end(), {affine(p), -affine(p)});
  const Result<Repaired> result = repair(pslg, {.snap = 0});
  RC_ASSERT(result.ok());
  const Pslg& domain = result->domain.pslg();
  properties::classify(domain.points.size() > pslg.points.size(), "some points are added", 40);
  for (std::size_t i = 0; i < domain.points.size(); ++i)
    for (const int sign : {1, -1}) {
      const double found = domain.point_attributes[2 * i + (sign > 0 ? 0 : 1)];
      RC_ASSERT(std::abs(found - sign * affine(domain.points[i])) <= 1e-12 * extent);
    }
}

PARDEL_PROPERTY(Repair, moves_no_point,
                {.statement = "without a snapping distance no point moves",
                 .source = "parallel/repair.hpp",
                 .families = messes}) {
  const Pslg mess = some_mess(exhibit);
  const Result<Repaired> result = repair(mess, {.snap = 0});
  RC_ASSERT(result.ok());
  for (std::size_t i = 0; i < mess.points.size(); ++i)
    RC_ASSERT(result->domain.pslg().points[result->point_map[i]] == mess.points[i]);
}

PARDEL_PROPERTY(Repair, keeps_every_segment_as_a_chain_within_rounding,
                {.statement = "the ends of a segment are joined by new segments on the old one, up to rounding",
                 .source = "parallel/repair.hpp",
                 .families = messes}) {
  const Pslg mess = some_mess(exhibit);
  const Result<Repaired> result = repair(mess, {.snap = 0});
  RC_ASSERT(result.ok());
  const double rounding = 1e-14 * mess.points.back().y;
  for (Index s = 0; s < mess.segments.size(); ++s) {
    // The points that can be reached along new segments on the old segment.
    std::set<Index> reached{result->point_map[mess.segments[s].a]};
    for (std::size_t size = 0; size < reached.size();) {
      size = reached.size();
      for (const Segment& piece : result->domain.pslg().segments) {
        if (distance_to(mess, s, result->domain.pslg().points[piece.a]) > rounding ||
            distance_to(mess, s, result->domain.pslg().points[piece.b]) > rounding)
          continue;
        if (reached.contains(piece.a) || reached.contains(piece.b)) reached.insert({piece.a, piece.b});
      }
    }
    RC_ASSERT(reached.contains(result->point_map[mess.segments[s].b]));
  }
}

PARDEL_PROPERTY(
    Repair, maps_every_piece_to_a_segment_that_it_lies_on_and_carries_its_marker,
    {.statement = "every new segment lies on the old one that it is mapped to, up to rounding, and has its marker",
     .source = "parallel/repair.hpp",
     .families = messes}) {
  const Pslg mess = some_mess(exhibit);
  const Result<Repaired> result = repair(mess, {.snap = 0});
  RC_ASSERT(result.ok());
  const double rounding = 1e-14 * mess.points.back().y;
  RC_ASSERT(result->segment_map.size() == result->domain.pslg().segments.size());
  for (std::size_t i = 0; i < result->segment_map.size(); ++i) {
    const Segment& piece = result->domain.pslg().segments[i];
    const Index s = result->segment_map[i];
    RC_ASSERT(piece.marker == mess.segments[s].marker);
    RC_ASSERT(distance_to(mess, s, result->domain.pslg().points[piece.a]) <= rounding);
    RC_ASSERT(distance_to(mess, s, result->domain.pslg().points[piece.b]) <= rounding);
  }
}

PARDEL_PROPERTY(Repair, with_a_snapping_distance_leaves_no_two_points_closer,
                {.statement = "after snapping, no two points are closer than the distance, and none moved further",
                 .source = "parallel/repair.hpp",
                 .families = messes}) {
  const Pslg mess = some_mess(exhibit);
  const double snap = 0.003 * mess.points.back().y;
  const Result<Repaired> result = repair(mess, {.snap = snap});
  RC_ASSERT(result.ok());
  RC_ASSERT(find_problems(result->domain.pslg()).empty());
  const std::vector<Point>& points = result->domain.pslg().points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      RC_ASSERT(std::hypot(points[i].x - points[j].x, points[i].y - points[j].y) >= snap);
  for (std::size_t i = 0; i < mess.points.size(); ++i) {
    const Point moved = points[result->point_map[i]];
    RC_ASSERT(std::hypot(moved.x - mess.points[i].x, moved.y - mess.points[i].y) < snap);
  }
}

/// A mess in which each end of a segment is a point of its own, a few roundings beside the common point.
Pslg some_torn_mess(Exhibit& exhibit) {
  const Pslg mess = *testing::mess();
  const double rounding = mess.points.back().y * 0x1p-50;
  const auto offset = rc::gen::map(rc::gen::inRange(-4, 5), [=](int k) { return k * rounding; });
  Pslg torn;
  torn.points = mess.points;
  for (Segment s : mess.segments) {
    for (Index* end : {&s.a, &s.b}) {
      const Point p = mess.points[*end];
      *end = static_cast<Index>(torn.points.size());
      torn.points.push_back({p.x + *offset, p.y + *offset});
    }
    torn.segments.push_back(s);
  }
  exhibit.show(torn);
  return torn;
}

constexpr const char* torn_messes = "the same, with ends torn apart by a few roundings";

PARDEL_PROPERTY(Repair, by_default_closes_all_tiny_gaps_and_then_changes_nothing,
                {.statement = "after repair with the default snapping distances, no two points are closer than the "
                              "distance at their scale, no point and segment closer than half of it, and a second "
                              "repair changes nothing",
                 .source = "parallel/repair.hpp",
                 .families = torn_messes}) {
  const Result<Repaired> result = repair(some_torn_mess(exhibit));
  RC_ASSERT(result.ok());
  const Pslg& pslg = result->domain.pslg();
  RC_ASSERT(find_problems(pslg).empty());
  // The distance is a 16th of the default, a 256th and so on if that failed.
  const double share = 0x1p-38 * std::min(1.0, result->snap / default_snap(pslg));
  const Reach reach(Snapping::share_of_scale(share * (1 - 1e-3)), pslg.points, pslg.segments);
  for (Index p = 0; p < pslg.points.size(); ++p) {
    const double scale = reach.scale_of_point(p);
    for (Index q = 0; q < p; ++q)
      RC_ASSERT(std::hypot(pslg.points[p].x - pslg.points[q].x, pslg.points[p].y - pslg.points[q].y) >=
                reach.between_points(p, q));
    for (Index s = 0; s < pslg.segments.size(); ++s)
      RC_ASSERT(p == pslg.segments[s].a || p == pslg.segments[s].b ||
                distance_to(pslg, s, pslg.points[p]) >= reach.between(scale, reach.scale_of_segment(s)) / 2);
  }
  const Result<Repaired> twice = repair(pslg);
  RC_ASSERT(twice.ok());
  RC_ASSERT(twice->domain.pslg() == pslg);
  RC_ASSERT(twice->log.empty());
}

PARDEL_PROPERTY(Repair, by_default_moves_points_and_segments_by_little_more_than_the_distance,
                {.statement = "no point moves by twice the default snapping distance, and no segment by four times",
                 .source = "parallel/repair.hpp",
                 .families = torn_messes}) {
  const Pslg torn = some_torn_mess(exhibit);
  const Result<Repaired> result = repair(torn);
  RC_ASSERT(result.ok());
  for (std::size_t i = 0; i < torn.points.size(); ++i) {
    const Point moved = result->domain.pslg().points[result->point_map[i]];
    RC_ASSERT(std::hypot(moved.x - torn.points[i].x, moved.y - torn.points[i].y) < 2 * result->snap);
  }
  for (std::size_t i = 0; i < result->segment_map.size(); ++i) {
    const Segment& piece = result->domain.pslg().segments[i];
    for (const Index end : {piece.a, piece.b})
      RC_ASSERT(distance_to(torn, result->segment_map[i], result->domain.pslg().points[end]) < 4 * result->snap);
  }
}

}  // namespace
}  // namespace pardel::engine
