// Ruppert's algorithm: no two vertices come closer than a length that the input and the goal determine.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "../../../ref/ruppert.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"
#include "wide_corners.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The least distance between two input vertices, or between a segment and an input vertex or a segment that has no
/// point in common with it.
double least_distance_of_features(const Pslg& pslg) {
  ref::Number least = CGAL::squared_distance(ref::exact(pslg.points[0]), ref::exact(pslg.points[1]));
  const auto at = [&](Index v) { return ref::exact(pslg.points[v]); };
  for (Index v = 0; v < pslg.points.size(); ++v)
    for (Index w = 0; w < v; ++w) least = std::min<ref::Number>(least, CGAL::squared_distance(at(v), at(w)));
  for (const Segment& s : pslg.segments) {
    const ref::Kernel::Segment_2 side(at(s.a), at(s.b));
    for (Index v = 0; v < pslg.points.size(); ++v)
      if (v != s.a && v != s.b) least = std::min<ref::Number>(least, CGAL::squared_distance(side, at(v)));
    // Two segments without a common point do not cross, so an end of one of them is nearest to the other.
  }
  return std::sqrt(CGAL::to_double(least));
}

/// The least circumradius of a triangle that is too large for the goal. The largest triangle in a circle is
/// equilateral, and no edge is longer than the diameter.
double least_radius_of_large_triangles(const Goal& goal) {
  return std::min(std::sqrt(4 * goal.max_area / (3 * std::numbers::sqrt3)), goal.max_edge / 2);
}

struct Measured {
  double closest = unbounded;            ///< the least distance between a vertex that was inserted and any other one
  double closest_at_corner = unbounded;  ///< between two that were inserted on segments with a common end
  double least = unbounded;              ///< between any two vertices
  double area = 0, perimeter = 0;
};

Measured measured(const Pslg& pslg, const Mesh& mesh) {
  Measured m;
  std::map<std::pair<Index, Index>, int> sides;
  for (const Triangle& t : mesh.triangles) {
    const Point p = mesh.points[t.v[0]], q = mesh.points[t.v[1]], r = mesh.points[t.v[2]];
    m.area += ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    for (std::size_t i = 0; i < 3; ++i) ++sides[std::minmax(t.v[i], t.v[(i + 1) % 3])];
  }
  const auto distance = [&](Index v, Index w) {
    return std::hypot(mesh.points[v].x - mesh.points[w].x, mesh.points[v].y - mesh.points[w].y);
  };
  for (const auto& [side, triangles] : sides)
    if (triangles == 1) m.perimeter += distance(side.first, side.second);
  std::vector<Index> segment_of(mesh.points.size(), no_index);  // of vertices inside a segment of the input
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    for (const Index v : {e.a, e.b})
      if (v >= pslg.points.size()) segment_of[v] = e.segment;
  const auto meet = [&](Index s, Index t) {
    const Segment &one = pslg.segments[s], &two = pslg.segments[t];
    return s != t && (one.a == two.a || one.a == two.b || one.b == two.a || one.b == two.b);
  };
  for (Index v = 0; v < mesh.points.size(); ++v)
    for (Index w = 0; w < v; ++w) {
      const double d = distance(v, w);
      m.least = std::min(m.least, d);
      if (v >= pslg.points.size()) m.closest = std::min(m.closest, d);
      if (segment_of[v] != no_index && segment_of[w] != no_index && meet(segment_of[v], segment_of[w]))
        m.closest_at_corner = std::min(m.closest_at_corner, d);
    }
  return m;
}

Pslg some_domain(Random& random, int /*size*/) {
  return random_wide_corners(random, {.points = 2, .points_at_sides = true, .empty_ones = true});
}

/// A goal with bounds on areas or lengths that a mesh of at most about a hundred triangles meets. The bound on lengths
/// may be just below the length of a diagonal of a quadrangle, or of its first side. In a square, the centre then
/// encroaches upon all sides and is as near to them as it can be.
Goal some_goal(const Pslg& pslg) {
  Goal goal{.min_angle_deg = *rc::gen::element(0.0, 10.0, 20.7)};
  const auto distance = [&](Index v, Index w) {
    return std::hypot(pslg.points[v].x - pslg.points[w].x, pslg.points[v].y - pslg.points[w].y);
  };
  const double diagonal = distance(0, 2);
  constexpr double hardly_less = 1 - 0x1p-20;
  switch (*rc::gen::inRange(0, 5).as("kind of size bound")) {
    case 0:
      goal.max_edge = diagonal * hardly_less;
      break;
    case 1:
      goal.max_edge = distance(0, 1) * hardly_less;
      break;
    case 2:
      goal.max_edge = diagonal / *rc::gen::inRange(1, 4);
      break;
    case 3:
      goal.max_area = diagonal * diagonal / *rc::gen::inRange(4, 40);
      break;
    default:
      break;
  }
  return goal;
}

PARDEL_PROPERTY(
    RuppertBound, keeps_vertices_apart_and_their_number_small,
    {.statement = "Let no two segments meet at less than 60 degrees. Let λ be the least distance between two input "
                  "vertices, or between a segment and an input vertex or segment that has no point in common with it. "
                  "Let s be the least circumradius of a triangle that breaks a size bound. In the mesh of Ruppert's "
                  "algorithm, every two vertices are at least μ = min(λ, s/√2) apart. So a domain of area A and "
                  "perimeter P has at most (A + ½Pμ + πμ²/4) / (πμ²/4) vertices.",
     .source = "Ruppert 1995; properties/THEORY.md, Refinement: corners of 60° and more",
     .families = "polygons of four to eight sides in any direction, with holes, islands, walls that meet, free "
                 "segments and points, some close above the middle of a side; bounds on areas or lengths, some just "
                 "below the length of a diagonal"}) {
  const Pslg pslg = *generators::generator(some_domain, with_fewer_points);
  exhibit.show(pslg);
  const Goal goal = some_goal(pslg);
  const Result<Mesh> made = ref::ruppert(pslg, goal);
  if (!made) RC_FAIL(made.error().message);
  exhibit.show(pslg, *made);
  const double lambda = least_distance_of_features(pslg), s = least_radius_of_large_triangles(goal);
  const double mu = std::min(lambda, s / std::numbers::sqrt2);
  const Measured m = measured(pslg, *made);
  RC_ASSERT(m.least >= mu * (1 - 0x1p-30));  // circumcentres are rounded
  const double disk = std::numbers::pi * mu * mu / 4, vertices = static_cast<double>(made->points.size());
  RC_ASSERT(vertices * disk <= (m.area + m.perimeter * mu / 2 + disk) * (1 + 0x1p-30));

  const Corners60 kind = kind_of(pslg);
  classify(kind.is_slanted, "some segment is parallel to no axis", 80);
  classify(kind.is_sharp, "a corner below 65 degrees", 15);
  classify(kind.has_hole, "a hole", 15);
  const bool by_input = lambda < s / std::numbers::sqrt2;
  classify(by_input && m.closest <= 1.05 * mu, "the input decides, and a new vertex is within 1.05 mu of another", 25);
  classify(!by_input && m.closest <= 1.05 * mu, "sizes decide, and a new vertex is within 1.05 mu of another", 3);
  classify(m.closest_at_corner <= 1.5 * mu, "new vertices on two segments that meet, within 1.5 mu", 5);
  classify(vertices * disk >= 0.6 * (m.area + m.perimeter * mu / 2 + disk), "0.6 of the bound on the number", 3);
}

}  // namespace
}  // namespace pardel::properties
