// Refinement of domains with a gap that is much too narrow to be resolved: only triangles at the gap miss a bound, and
// only the one on angles.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../../parallel/validate.hpp"
#include "../../domains/dealt_domain.hpp"
#include "../framework/mesh_of_ranks.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

constexpr const char* families_with_a_gap =
    "lattice domains of every family, with a point 2^-20 to 2^-60 times the length of an edge of the border away from "
    "it, also in its middle";

/// A domain with a point near an edge of its border or a segment.
struct Gapped {
  Pslg pslg;
  Point near, from, to;  ///< the point, and the ends of the edge
  double width = 0;      ///< the largest extent of the domain
};

double extent(const Pslg& pslg) {
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(pslg.points, {}, &Point::y);
  return std::max(right.x - left.x, high.y - low.y);
}

/// Adds the point to a random edge. Discards domains in which it has no place.
Gapped some_gapped(Exhibit& exhibit) {
  generators::LatticeDomain domain = *generators::domains();
  RC_TAG(std::string(generators::name(domain.family)));
  domain.offset = {};  // far from the origin, doubles do not resolve the gap
  Gapped drawn;
  drawn.pslg = to_pslg(domain);
  const Mesh triangulated = value_of(triangulate(drawn.pslg)).mesh;
  const ConstrainedEdge edge = *rc::gen::elementOf(triangulated.constrained_edges);
  drawn.from = triangulated.points[edge.a];
  drawn.to = triangulated.points[edge.b];
  const double dx = drawn.to.x - drawn.from.x, dy = drawn.to.y - drawn.from.y;
  const double along = *rc::gen::element(0.5, 0.5, 0.25, 0.375, 0.7, 0.0);
  // Those below 2^-42 are narrower than the shortest edge that is made there; many below 2^-52 are rounded to 0.
  const int exponent = *rc::gen::arbitrary<bool>() ? *rc::gen::inRange(20, 61) : *rc::gen::inRange(42, 53);
  const double gap = (*rc::gen::element(1, -1)) * std::ldexp(1.0, -exponent);
  drawn.near = {drawn.from.x + along * dx - gap * dy, drawn.from.y + along * dy + gap * dx};
  drawn.pslg.points.push_back(drawn.near);
  if (!drawn.pslg.point_markers.empty()) drawn.pslg.point_markers.push_back(0);
  drawn.pslg.point_attributes.resize(drawn.pslg.points.size() * drawn.pslg.attributes_per_point);
  RC_PRE(static_cast<bool>(validate(drawn.pslg)));
  drawn.width = extent(drawn.pslg);
  exhibit.show(drawn.pslg);
  return drawn;
}

/// A bound on areas or on lengths, in half of the cases with one on angles.
Goal some_bounds(const Gapped& drawn) {
  Goal goal{.min_angle_deg = *rc::gen::element(0.0, 20.7)};
  if (*rc::gen::arbitrary<bool>())
    goal.max_area = drawn.width * drawn.width / *rc::gen::inRange(4, 3000);
  else
    goal.max_edge = drawn.width / *rc::gen::inRange(2, 40);
  return goal;
}

Goal smaller(Goal goal, double factor) {
  goal.max_area *= factor * factor;
  goal.max_edge *= factor;
  return goal;
}

/// True if a corner of the triangle is no farther away from the point of the gap than the edge at the gap and the
/// longest side of the triangle are long together. The point keeps the edge from being split, and the edge keeps
/// triangles from being split whose split points lie in its diametral circle.
bool is_at_gap(const Gapped& drawn, const Mesh& mesh, Index triangle) {
  const auto distance = [](Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); };
  const auto& v = mesh.triangles[triangle].v;
  const Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
  return std::min({distance(a, drawn.near), distance(b, drawn.near), distance(c, drawn.near)}) <=
         distance(drawn.from, drawn.to) + std::max({distance(a, b), distance(b, c), distance(c, a)});
}

/// Fails the case if a triangle misses a bound on size, or if one that misses the bound on angles is not at the gap.
/// Returns true if the latter bound is missed. Small angles of the domain do not count.
bool misses_angles_at_gap(const Gapped& drawn, const Meshed& made, Goal goal) {
  bool misses = false;
  for (const Exemption& e : made.report.exempt) {
    if (justified(e.reason)) continue;
    misses = true;
    RC_ASSERT(is_at_gap(drawn, made.mesh, e.triangle));
  }
  goal.min_angle_deg = 0;
  require_valid(check(drawn.pslg, made.mesh, goal));
  return misses;
}

PARDEL_PROPERTY(Gap, is_the_only_place_where_bounds_are_missed,
                {.statement = "In a domain with a gap that cannot be resolved, no triangle is larger than a bound on "
                              "size, nor than a smaller bound. Each triangle that misses a bound on angles, and not "
                              "because of a small angle of the domain, is at the gap: no farther away from its point "
                              "than the edge at the gap and the longest side are long together. Without a bound on "
                              "angles all bounds are kept. Several ranks make the same mesh.",
                 .source = "properties/THEORY.md, refinement: the floor",
                 .families = families_with_a_gap}) {
  const Gapped drawn = some_gapped(exhibit);
  const Goal goal = some_bounds(drawn), stricter = smaller(goal, *rc::gen::element(0.5, 0.7));
  const Options options = some_options();
  bool misses = misses_angles_at_gap(drawn, meshed({drawn.pslg, goal}, exhibit, options), goal);
  const Meshed made = meshed({drawn.pslg, stricter}, exhibit, options);
  misses = misses_angles_at_gap(drawn, made, stricter) || misses;
  RC_ASSERT(goal.min_angle_deg > 0 || !misses);
  classify(misses, "triangles at the gap miss the bound on angles", 10);

  const int count = *rc::gen::element(1, 1, 2, 3);
  if (count == 1) return;
  const bool is_dealt = can_divide_points(stricter, options) && *rc::gen::arbitrary<bool>();
  const ValidPslg domain = std::move(validate(drawn.pslg)).value();
  const std::string difference = difference_on_ranks(made.mesh, count, [&](pardel::Ranks& ranks) {
    return is_dealt ? mesh(domains::equal_part(drawn.pslg, ranks), stricter, options, ranks)
                    : mesh(domain, stricter, options, ranks);
  });
  RC_ASSERT(difference == "");
}

}  // namespace
}  // namespace pardel::properties
