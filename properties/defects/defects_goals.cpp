// Defects of size and shape: triangles that miss a bound by the smallest representable amount, or by a large amount.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../checker/arithmetic/exact.hpp"
#include "defect_groups.hpp"

namespace pardel::defects {
namespace {

using edit::Side;
using enum ViolationKind;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool exceeds_area(const Mesh& mesh, Index t, double cap) {
  const auto& v = mesh.triangles[t].v;
  return checker::exactly::area_exceeds(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], cap);
}

/// The triangle with the largest area in `region`, or in the mesh if `region` is no_index.
Index largest(const Mesh& mesh, Index region) {
  Index best = no_index;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    if (region != no_index && mesh.region[t] != region) continue;
    if (best == no_index || edit::area(mesh, t) > edit::area(mesh, best)) best = t;
  }
  return best;
}

/// The largest double for which `exceeds` is true. Precondition: `about` is positive and near to this double.
template <class Exceeds>
double just_exceeded(double about, const Exceeds& exceeds) {
  while (exceeds(about)) about = std::nextafter(about, infinity);
  while (!exceeds(about)) about = std::nextafter(about, 0);
  return about;
}

double just_too_small_a_cap(const Mesh& mesh, Index t) {
  return just_exceeded(edit::area(mesh, t), [&](double cap) { return exceeds_area(mesh, t, cap); });
}

/// Deletes an interior vertex (of the region, or of the mesh if `region` is no_index). Afterwards a triangle is larger
/// than the largest triangle was before. Returns an area cap that held before and does not hold now; 0 if no vertex is
/// suitable.
double delete_vertex_against_cap(Mesh& mesh, Index region, std::uint64_t seed) {
  const Index worst = largest(mesh, region);
  if (worst == no_index) return 0;
  const double cap = just_exceeded(edit::area(mesh, worst), [&](double c) { return exceeds_area(mesh, worst, c); });
  const double kept = std::nextafter(cap, infinity);
  const bool deleted = at_some_vertex(mesh, seed, [&](Index v) {
    if (!is_interior(mesh, v)) return false;
    const auto around = edit::neighbour_vertices(mesh, v);
    return std::ranges::any_of(around, [&](Index to) {
      Mesh merged = mesh;
      if (!edit::collapse(merged, v, to)) return false;
      edit::erase_unused_point(merged, v);
      if (!exceeds_area(merged, largest(merged, region), kept)) return false;
      mesh = std::move(merged);
      return true;
    });
  });
  return deleted ? kept : 0;
}

double longest_edge(const Mesh& mesh, Index t) {
  const auto& v = mesh.triangles[t].v;
  return std::max({edit::length(mesh, v[0], v[1]), edit::length(mesh, v[1], v[2]), edit::length(mesh, v[2], v[0])});
}

/// True if all corners are interior vertices. Then no small input angle can justify the triangle.
bool is_far_from_input(const Mesh& mesh, Index t) {
  return std::ranges::all_of(mesh.triangles[t].v, [&](Index v) { return is_interior(mesh, v); });
}

/// Sets the angle bound `more` degrees above the smallest angle of the triangles far from the input. Returns false if
/// no triangle is far from the input.
bool demand_more(const Mesh& mesh, Goal& goal, double more) {
  double worst = 180;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (is_far_from_input(mesh, t)) worst = std::min(worst, edit::smallest_angle_deg(mesh, t));
  if (worst > 60) return false;
  goal.min_angle_deg = worst + more;
  return true;
}

/// The largest bound on edges that this edge exceeds.
double just_too_small_a_length(const Mesh& mesh, Side s) {
  const Point a = mesh.points[edit::tail(mesh, s)], b = mesh.points[edit::head(mesh, s)];
  return just_exceeded(edit::length(mesh, edit::tail(mesh, s), edit::head(mesh, s)),
                       [&](double bound) { return checker::exactly::length_exceeds(a, b, bound); });
}

/// Sets the bound on edges such that only one edge exceeds it, by the least amount. Changes nothing and returns false
/// if another edge is as long, or if the longest edge lies inside (or on the boundary) although the other is wanted.
bool forbid_longest_edge(const Mesh& mesh, Goal& goal, bool on_boundary) {
  Side longest{0, 0};
  const auto compare = [&](Side s, Side t) {
    return checker::exactly::compare_lengths(mesh.points[edit::tail(mesh, s)], mesh.points[edit::head(mesh, s)],
                                             mesh.points[edit::tail(mesh, t)], mesh.points[edit::head(mesh, t)]);
  };
  at_some_side(mesh, 0, [&](Side s) {
    if (compare(s, longest) > 0) longest = s;
    return false;
  });
  const auto ends = [&](Side s) { return edit::ends(edit::tail(mesh, s), edit::head(mesh, s)); };
  const bool another =
      at_some_side(mesh, 0, [&](Side s) { return ends(s) != ends(longest) && compare(s, longest) == 0; });
  if (another || (edit::across(mesh, longest) == no_index) != on_boundary) return false;
  goal.max_edge = just_too_small_a_length(mesh, longest);
  return true;
}

constexpr Defect goal_defects[] = {
    {"an angle is a millionth of a degree below the bound",
     small_angle,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) { return demand_more(mesh, goal, 1e-6); }},
    {"an angle is two degrees below the bound",
     small_angle,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) { return demand_more(mesh, goal, 2); }},
    {"a triangle far from all segments is flattened",
     small_angle,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return goal.min_angle_deg > 0 && at_some_side(mesh, seed, [&](Side s) {
                if (!is_far_from_input(mesh, s.t)) return false;
                const Index v = edit::apex(mesh, s);
                const Point foot = edit::between(mesh.points[edit::tail(mesh, s)], mesh.points[edit::head(mesh, s)]);
                return edit::move(mesh, v, edit::between(foot, mesh.points[v], 0.03125),
                                  [&] { return edit::smallest_angle_deg(mesh, s.t) < goal.min_angle_deg / 2; });
              });
     }},
    {"the largest triangle exceeds the cap by the least amount",
     large_area,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) {
       goal.max_area = just_too_small_a_cap(mesh, largest(mesh, no_index));
       return true;
     }},
    {"half of the triangles are too large",
     large_area,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) {
       goal.max_area = edit::area(mesh, largest(mesh, no_index)) / 2;
       return true;
     }},
    {"a vertex is deleted, and its triangles merge beyond the cap",
     large_area,
     {vertex_entries | triangle_entries | Field::constrained_edges | Field::bounds, any_number},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       const double cap = delete_vertex_against_cap(mesh, no_index, seed);
       if (cap > 0) goal.max_area = cap;
       return cap > 0;
     }},
    {"a region's triangle exceeds its cap by the least amount",
     region_area,
     {Field::input_regions},
     [](Pslg& pslg, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return goal.region_caps && at_some(pslg.regions.size(), seed, [&](Index r) {
                const Index t = largest(mesh, r);
                if (t == no_index) return false;
                pslg.regions[r].max_area = just_too_small_a_cap(mesh, t);
                return true;
              });
     }},
    {"a vertex is deleted in a region, and its triangles merge beyond the region's cap",
     region_area,
     {Field::coordinates | Field::origins | Field::markers | triangle_entries | Field::constrained_edges |
          Field::input_regions,
      any_number},
     [](Pslg& pslg, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return goal.region_caps && at_some(pslg.regions.size(), seed, [&](Index r) {
                const double cap = delete_vertex_against_cap(mesh, r, seed);
                if (cap > 0) pslg.regions[r].max_area = cap;
                return cap > 0;
              });
     }},
    {"an edge exceeds its bound by the least amount",
     long_edge,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         goal.max_edge = just_too_small_a_length(mesh, s);
         return true;
       });
     }},
    {"the longest edge lies on the boundary, and it alone exceeds its bound by the least amount",
     long_edge,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) { return forbid_longest_edge(mesh, goal, true); }},
    {"the longest edge lies inside, and it alone exceeds its bound by the least amount",
     long_edge,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) { return forbid_longest_edge(mesh, goal, false); }},
    {"the sizing function demands shorter edges everywhere",
     size_exceeded,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t) {
       const double wanted = longest_edge(mesh, largest(mesh, no_index)) / 2;
       goal.size = [wanted](Point) { return wanted; };
       return true;
     }},
    {"the sizing function demands shorter edges at one triangle",
     size_exceeded,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const Point at = edit::centroid(mesh, t);
         const double near = longest_edge(mesh, t) * 0x1p-20, wanted = longest_edge(mesh, t) * 0.875;
         goal.size = [=](Point p) { return std::hypot(p.x - at.x, p.y - at.y) < near ? wanted : 1e300; };
         return true;
       });
     }},
    {"the test of the user demands smaller triangles everywhere",
     user_test,
     {Field::bounds},
     [](Pslg&, Mesh&, Goal& goal, std::uint64_t seed) {
       goal.user_test = [](const std::array<Point, 3>&, double area) { return area >= 0; };
       goal.user_test_is_free_of_state = seed % 2 == 0;
       return true;
     }},
    {"the test of the user demands that one triangle is refined",
     user_test,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const auto& v = mesh.triangles[t].v;
         const std::array<Point, 3> wanted{mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]};
         goal.user_test = [wanted](const std::array<Point, 3>& corners, double) {
           return std::ranges::is_permutation(corners, wanted);
         };
         return true;
       });
     }},
    {"a source of the limit on gradation demands shorter edges at one triangle",
     size_exceeded,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const Point at = edit::centroid(mesh, t);
         const double wanted = longest_edge(mesh, t) * 0.875;
         goal.grading = 1;
         goal.sources = {{at, at, wanted, wanted}};
         return true;
       });
     }},
    {"the narrow places demand shorter edges",
     size_exceeded,
     {Field::bounds},
     [](Pslg&, Mesh&, Goal& goal, std::uint64_t) {
       goal.feature_edges = 1e6;
       return true;
     }},
    {"an edge of a segment is not Delaunay although the goal is conforming",
     not_conforming,
     {Field::bounds},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       if (goal.conforming) return false;
       const auto walls = edit::constrained(mesh);
       return at_some_side(mesh, seed, [&](Side s) {
         if (edit::across(mesh, s) == no_index) return false;
         if (!walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s)))) return false;
         const auto& v = mesh.triangles[s.t].v;
         const Index beyond = edit::apex(mesh, edit::opposite(mesh, s));
         if (checker::exactly::in_circle(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]],
                                         mesh.points[beyond]) <= 0)
           return false;
         goal.conforming = true;
         return true;
       });
     }},
};

}  // namespace

std::span<const Defect> defects_of_goals() { return goal_defects; }

}  // namespace pardel::defects
