// Defects of geometry: vertices in the wrong place, and edges that are not Delaunay.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../checker/arithmetic/exact.hpp"
#include "defect_groups.hpp"

namespace pardel::defects {
namespace {

using edit::Side;
using enum ViolationKind;

bool strictly_delaunay_violated(const Mesh& mesh, Side s) {
  if (edit::across(mesh, s) == no_index) return false;
  const Side o = edit::opposite(mesh, s);
  const auto& v = mesh.triangles[s.t].v;
  return checker::exactly::in_circle(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]],
                                     mesh.points[edit::apex(mesh, o)]) > 0;
}

bool all_positive(const Mesh& mesh, const std::vector<Index>& ids) {
  return std::ranges::all_of(ids, [&](Index t) {
    const auto& v = mesh.triangles[t].v;
    return edit::orientation(mesh, v[0], v[1], v[2]) > 0;
  });
}

/// True if an unconstrained side of these triangles is not locally Delaunay.
bool some_not_delaunay(const Mesh& mesh, const std::vector<Index>& ids) {
  const auto walls = edit::constrained(mesh);
  return std::ranges::any_of(ids, [&](Index t) {
    return std::ranges::any_of(std::array{0, 1, 2}, [&](int i) {
      const Side s{t, i};
      return !walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s))) &&
             strictly_delaunay_violated(mesh, s);
    });
  });
}

/// The length of the shortest constrained edge at v.
double chain_step(const Mesh& mesh, Index v) {
  double step = HUGE_VAL;
  for (const ConstrainedEdge& e : mesh.constrained_edges)
    if (e.a == v || e.b == v) step = std::min(step, edit::length(mesh, e.a, e.b));
  return step;
}

/// Moves a vertex of a segment's chain at right angles to the segment, by `share` of the shortest constrained edge at
/// it, to a side where all triangles stay counter-clockwise. False if there is no such side.
bool move_off_segment(const Pslg& pslg, Mesh& mesh, Index v, double share) {
  if (!is_on_segment(pslg, mesh, v)) return false;
  const Segment& segment = pslg.segments[segment_of_origin(mesh.origin[v])];
  const Point a = pslg.points[segment.a], b = pslg.points[segment.b], at = mesh.points[v];
  const double by = share * chain_step(mesh, v) / std::hypot(b.x - a.x, b.y - a.y);
  const auto star = edit::star(mesh, v);
  return std::ranges::any_of(std::array{1.0, -1.0}, [&](double side) {
    const Point to{at.x - side * by * (b.y - a.y), at.y + side * by * (b.x - a.x)};
    return edit::move(mesh, v, to, [&] { return all_positive(mesh, star); });
  });
}

constexpr Defect geometry_defects[] = {
    {"an edge is flipped",
     not_delaunay,
     {Field::corners, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto walls = edit::constrained(mesh);
       return at_some_side(mesh, seed, [&](Side s) {
         if (walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s)))) return false;
         if (edit::across(mesh, s) == no_index) return false;
         const Index t = s.t, u = edit::across(mesh, s);
         Mesh flipped = mesh;
         if (!edit::flip(flipped, s) || !some_not_delaunay(flipped, {t, u})) return false;
         mesh = std::move(flipped);
         return true;
       });
     }},
    {"a vertex has moved so far that an edge is no longer Delaunay",
     not_delaunay,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         if (!is_interior(mesh, v)) return false;
         const auto star = edit::star(mesh, v);
         const auto around = edit::neighbour_vertices(mesh, v);
         return std::ranges::any_of(around, [&](Index to) {
           return edit::move(mesh, v, edit::between(mesh.points[v], mesh.points[to]),
                             [&] { return all_positive(mesh, star) && some_not_delaunay(mesh, star); });
         });
       });
     }},
    {"a vertex lies on an edge of the triangles around it",
     degenerate_triangle,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const Index v = edit::apex(mesh, s), a = edit::tail(mesh, s), b = edit::head(mesh, s);
         if (!is_interior(mesh, v)) return false;
         // This works only if the rounded midpoint lies exactly on the edge.
         return edit::move(mesh, v, edit::between(mesh.points[a], mesh.points[b]),
                           [&] { return edit::orientation(mesh, a, b, v) == 0; });
       });
     }},
    {"a vertex lies on another",
     degenerate_triangle,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         if (!is_interior(mesh, edit::apex(mesh, s))) return false;
         mesh.points[edit::apex(mesh, s)] = mesh.points[edit::tail(mesh, s)];
         return true;
       });
     }},
    {"a vertex has moved across an edge of the triangles around it",
     degenerate_triangle,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const Index v = edit::apex(mesh, s);
         if (!is_interior(mesh, v)) return false;
         const Point middle = edit::between(mesh.points[edit::tail(mesh, s)], mesh.points[edit::head(mesh, s)]);
         mesh.points[v] = edit::between(mesh.points[v], middle, 1.0625);
         return true;
       });
     }},
    {"a vertex has moved out of the domain",
     degenerate_triangle,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         if (!is_interior(mesh, v)) return false;
         double far = 1;
         for (const Point& p : mesh.points) far = std::max({far, std::abs(p.x), std::abs(p.y)});
         mesh.points[v].x += 4 * far;
         return true;
       });
     }},
    {"two new vertices have swapped places",
     degenerate_triangle,
     {Field::coordinates, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const Index a = edit::tail(mesh, s), b = edit::head(mesh, s);
         if (!is_interior(mesh, a) || !is_interior(mesh, b)) return false;
         std::swap(mesh.points[a], mesh.points[b]);
         return true;
       });
     }},
    {"an input vertex has moved by one unit in the last place",
     missing_input_vertex,
     {Field::coordinates},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(pslg.points.size(), seed, [&](Index v) {
         mesh.points[v].x = std::nextafter(mesh.points[v].x, HUGE_VAL);
         return true;
       });
     }},
    {"an input vertex has moved, and all its triangles are still counter-clockwise",
     missing_input_vertex,
     {Field::coordinates},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(pslg.points.size(), seed, [&](Index v) {
         const auto star = edit::star(mesh, v);
         if (star.empty()) return false;
         const Point to = edit::between(mesh.points[v], edit::centroid(mesh, star[0]), 0x1p-10);
         return edit::move(mesh, v, to, [&] { return all_positive(mesh, star); });
       });
     }},
    {"two input vertices have swapped numbers",
     missing_input_vertex,
     {Field::coordinates | Field::markers | Field::attributes | Field::corners | Field::constrained_edges, any_number},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       const Index a = another(seed, pslg.points.size()), b = another(seed + 1, pslg.points.size());
       if (a == b) return false;
       std::vector<Index> to(mesh.points.size());
       for (Index v = 0; v < to.size(); ++v) to[v] = v == a ? b : v == b ? a : v;
       edit::renumber(mesh, to);
       return true;
     }},
    {"input vertices do not come first",
     missing_input_vertex,
     {vertex_entries | Field::corners | Field::constrained_edges, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       const auto n = static_cast<Index>(mesh.points.size());
       std::vector<Index> to(n);
       for (Index v = 0; v < n; ++v) to[v] = n - 1 - v;
       edit::renumber(mesh, to);
       return true;
     }},
    {"an input vertex in the interior is removed from the triangulation",
     missing_input_vertex,
     {Field::corners, any_number},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto walls = edit::constrained(mesh);
       return at_some(pslg.points.size(), seed, [&](Index v) {
         if (std::ranges::any_of(walls, [&](const auto& e) { return e.first == v || e.second == v; })) return false;
         const auto around = edit::neighbour_vertices(mesh, v);
         return std::ranges::any_of(around, [&](Index to) { return edit::collapse(mesh, v, to); });
       });
     }},
    {"a vertex of a segment's chain lies a millionth off the segment",
     chain_off_segment,
     {Field::coordinates},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) { return move_off_segment(pslg, mesh, v, 1e-6); });
     }},
    {"a segment's chain makes a visible bend",
     chain_off_segment,
     {Field::coordinates},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) { return move_off_segment(pslg, mesh, v, 0.125); });
     }},
    {"two vertices of a segment's chain have swapped places",
     degenerate_triangle,
     {Field::coordinates, 2},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.constrained_edges.size(), seed, [&](Index e) {
         const auto [a, b] = edit::ends(mesh.constrained_edges[e].a, mesh.constrained_edges[e].b);
         if (!is_on_segment(pslg, mesh, a) || !is_on_segment(pslg, mesh, b)) return false;
         std::swap(mesh.points[a], mesh.points[b]);
         return true;
       });
     }},
    {"a vertex splits a triangle, and the edges are not Delaunay",
     not_delaunay,
     {vertex_entries | triangle_entries, 3},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         Mesh split = mesh;
         const Index v = edit::split_triangle(split, t, edit::centroid(mesh, t));
         if (!some_not_delaunay(split, edit::star(split, v))) return false;
         mesh = std::move(split);
         return true;
       });
     }},
    {"a sliver is added at an edge",
     small_angle,
     {vertex_entries | triangle_entries, 3},
     [](Pslg&, Mesh& mesh, Goal& goal, std::uint64_t seed) {
       if (goal.min_angle_deg <= 0) return false;
       return at_some_side(mesh, seed, [&](Side s) {
         if (!std::ranges::all_of(mesh.triangles[s.t].v, [&](Index v) { return is_interior(mesh, v); })) return false;
         const Point middle = edit::between(mesh.points[edit::tail(mesh, s)], mesh.points[edit::head(mesh, s)]);
         edit::split_triangle(mesh, s.t, edit::between(middle, mesh.points[edit::apex(mesh, s)], 0x1p-12));
         return true;
       });
     }},
    {"an edge of the mesh crosses a segment",
     broken_segment,
     {Field::corners, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto walls = edit::constrained(mesh);
       return at_some_side(mesh, seed, [&](Side s) {
         return walls.contains(edit::ends(edit::tail(mesh, s), edit::head(mesh, s))) && edit::flip(mesh, s);
       });
     }},
    {"an edge of the mesh crosses a segment, and the list of constrained edges hides it",
     broken_segment,
     {Field::corners | Field::constrained_edges, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const auto lost = edit::ends(edit::tail(mesh, s), edit::head(mesh, s));
         const auto listed = std::ranges::find_if(
             mesh.constrained_edges, [&](const ConstrainedEdge& e) { return edit::ends(e.a, e.b) == lost; });
         if (listed == mesh.constrained_edges.end() || !edit::flip(mesh, s)) return false;
         mesh.constrained_edges.erase(listed);
         return true;
       });
     }},
};

}  // namespace

std::span<const Defect> defects_of_geometry() { return geometry_defects; }

}  // namespace pardel::defects
