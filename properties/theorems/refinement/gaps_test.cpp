// Refinement of domains with a gap that is much too narrow to be resolved: only triangles at the gap miss a bound.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../../parallel/validate.hpp"
#include "../../domains/dealt_domain.hpp"
#include "../framework/mesh_of_ranks.hpp"
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
  const double gap = (*rc::gen::element(1, -1)) * std::ldexp(1.0, -*rc::gen::inRange(20, 61));
  drawn.near = {drawn.from.x + along * dx - gap * dy, drawn.from.y + along * dy + gap * dx};
  drawn.pslg.points.push_back(drawn.near);
  if (!drawn.pslg.point_markers.empty()) drawn.pslg.point_markers.push_back(0);
  drawn.pslg.point_attributes.resize(drawn.pslg.points.size() * drawn.pslg.attributes_per_point);
  RC_PRE(static_cast<bool>(validate(drawn.pslg)));
  drawn.width = extent(drawn.pslg);
  exhibit.show(drawn.pslg);
  return drawn;
}

/// Is the point on the edge at the gap, up to rounding?
bool lies_on_edge(const Gapped& drawn, Point p) {
  const double dx = drawn.to.x - drawn.from.x, dy = drawn.to.y - drawn.from.y;
  const double off = (p.y - drawn.from.y) * dx - (p.x - drawn.from.x) * dy;
  const double along = (p.x - drawn.from.x) * dx + (p.y - drawn.from.y) * dy;
  const double squared = dx * dx + dy * dy;
  return std::abs(off) <= 1e-12 * squared && along >= 0 && along <= squared;
}

/// A bound on areas or on lengths, without one on angles.
Goal some_size(const Gapped& drawn) {
  Goal goal{.min_angle_deg = 0};
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

bool touches_gap(const Gapped& drawn, const Mesh& mesh, Index triangle) {
  const auto corners = mesh.triangles[triangle].v;
  const auto on_edge = std::ranges::count_if(corners, [&](Index v) { return lies_on_edge(drawn, mesh.points[v]); });
  return on_edge >= 2 || std::ranges::any_of(corners, [&](Index v) { return mesh.points[v] == drawn.near; });
}

PARDEL_PROPERTY(Gap, is_the_only_place_where_triangles_are_too_large,
                {.statement = "In a domain with a gap that cannot be resolved, each triangle that is larger than a "
                              "bound on size touches the gap: its point is a corner, or a side lies on its edge. For "
                              "a smaller bound there are no more of them. Several ranks make the same mesh.",
                 .source = "properties/THEORY.md, refinement: the floor",
                 .families = families_with_a_gap}) {
  const Gapped drawn = some_gapped(exhibit);
  const Goal goal = some_size(drawn);
  const Options options = some_options();
  const Meshed large = meshed({drawn.pslg, goal}, exhibit, options);
  const Goal stricter = smaller(goal, *rc::gen::element(0.5, 0.7));
  const Meshed made = meshed({drawn.pslg, stricter}, exhibit, options);
  for (const Exemption& e : made.report.exempt) RC_ASSERT(touches_gap(drawn, made.mesh, e.triangle));
  RC_ASSERT(made.report.exempt.size() <= large.report.exempt.size());

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
