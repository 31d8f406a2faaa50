// Defects of topology: triangles that are joined wrongly, wrong neighbours, vertices without triangles.
#include <algorithm>
#include <utility>

#include "defect_groups.hpp"

namespace pardel::defects {
namespace {

using edit::Side;
using enum ViolationKind;

/// True if no edge joins a corner of t to a corner of u, and they share no corner.
bool far_apart(const Mesh& mesh, Index t, Index u) {
  return std::ranges::none_of(mesh.triangles[t].v, [&](Index v) {
    const auto around = edit::star(mesh, v);
    return std::ranges::any_of(around, [&](Index w) {
      return std::ranges::any_of(mesh.triangles[w].v,
                                 [&](Index c) { return std::ranges::count(mesh.triangles[u].v, c) != 0; });
    });
  });
}

/// Removes two triangles and joins the borders of the two gaps by a tube of six triangles.
void add_handle(Mesh& mesh, Index t, Index u) {
  const auto a = mesh.triangles[t].v, b = mesh.triangles[u].v;
  edit::erase_triangles(mesh, {t, u});
  for (int i = 0; i < 3; ++i) {
    const int j = (3 - i) % 3, before = (j + 2) % 3;
    edit::append_triangle(mesh, {a[i], a[(i + 1) % 3], b[j]});
    edit::append_triangle(mesh, {b[before], b[j], a[(i + 1) % 3]});
  }
  edit::relink(mesh);
}

constexpr Defect topology_defects[] = {
    {"a triangle is there twice",
     duplicate_triangle,
     {triangle_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const Triangle copy = mesh.triangles[t];
         edit::append_triangle(mesh, copy.v, edit::region_of(mesh, t));
         mesh.triangles.back().n = copy.n;
         return true;
       });
     }},
    {"a triangle is there twice, written from another corner",
     duplicate_triangle,
     {triangle_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const auto v = mesh.triangles[t].v;
         edit::append_triangle(mesh, {v[1], v[2], v[0]}, edit::region_of(mesh, t));
         edit::relink(mesh);
         return true;
       });
     }},
    {"a triangle is clockwise",
     degenerate_triangle,
     {Field::corners},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         std::swap(mesh.triangles[t].v[0], mesh.triangles[t].v[1]);
         std::swap(mesh.triangles[t].n[0], mesh.triangles[t].n[1]);
         return true;
       });
     }},
    {"all triangles are clockwise",
     degenerate_triangle,
     {Field::corners, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       for (Triangle& t : mesh.triangles) {
         std::swap(t.v[0], t.v[1]);
         std::swap(t.n[0], t.n[1]);
       }
       return true;
     }},
    {"a triangle has one vertex twice",
     degenerate_triangle,
     {Field::corners},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         mesh.triangles[s.t].v[s.i] = edit::tail(mesh, s);
         return true;
       });
     }},
    {"a neighbour is another triangle",
     wrong_neighbour,
     {Field::neighbours},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const Index other = another(seed, mesh.triangles.size());
         if (edit::across(mesh, s) == no_index || other == s.t || other == edit::across(mesh, s)) return false;
         mesh.triangles[s.t].n[s.i] = other;
         return true;
       });
     }},
    {"a triangle is its own neighbour",
     wrong_neighbour,
     {Field::neighbours},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         mesh.triangles[s.t].n[s.i] = s.t;
         return true;
       });
     }},
    {"a neighbour is missing on one side",
     wrong_neighbour,
     {Field::neighbours},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         if (edit::across(mesh, s) == no_index) return false;
         mesh.triangles[s.t].n[s.i] = no_index;
         return true;
       });
     }},
    {"two neighbours do not list each other",
     wrong_neighbour,
     {Field::neighbours, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         if (edit::across(mesh, s) == no_index) return false;
         const Side o = edit::opposite(mesh, s);
         mesh.triangles[o.t].n[o.i] = no_index;
         mesh.triangles[s.t].n[s.i] = no_index;
         return true;
       });
     }},
    {"a triangle's neighbours are in the wrong order",
     wrong_neighbour,
     {Field::neighbours},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         auto& n = mesh.triangles[t].n;
         if (n[0] == n[1] && n[1] == n[2]) return false;
         std::rotate(n.begin(), n.begin() + 1, n.end());
         return true;
       });
     }},
    {"a boundary edge has a neighbour",
     wrong_neighbour,
     {Field::neighbours},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const Index other = another(seed, mesh.triangles.size());
         if (edit::across(mesh, s) != no_index || other == s.t) return false;
         mesh.triangles[s.t].n[s.i] = other;
         return true;
       });
     }},
    {"an edge has three triangles",
     non_manifold_edge,
     {vertex_entries | triangle_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         if (edit::across(mesh, s) == no_index) return false;
         const Index tip = edit::append_point(mesh, edit::centroid(mesh, s.t));
         edit::append_triangle(mesh, {edit::tail(mesh, s), edit::head(mesh, s), tip}, edit::region_of(mesh, s.t));
         edit::relink(mesh);
         return true;
       });
     }},
    {"an interior vertex has a second fan of triangles",
     non_manifold_vertex,
     {vertex_entries | triangle_entries, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const auto v = mesh.triangles[t].v;
         if (!is_interior(mesh, v[0])) return false;
         const Point at = mesh.points[v[0]];
         const Index p = edit::append_point(mesh, edit::between(at, mesh.points[v[1]], 0.25));
         const Index q = edit::append_point(mesh, edit::between(at, mesh.points[v[2]], 0.25));
         edit::append_triangle(mesh, {v[0], p, q}, edit::region_of(mesh, t));
         return true;
       });
     }},
    {"two triangles are joined by a handle",
     euler_characteristic,
     {triangle_entries, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         const Index u = another(seed, mesh.triangles.size());
         if (!far_apart(mesh, t, u)) return false;
         add_handle(mesh, t, u);
         return true;
       });
     }},
    {"a vertex without triangles is appended",
     unused_vertex,
     {vertex_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         edit::append_point(mesh, edit::centroid(mesh, t));
         return true;
       });
     }},
    {"a vertex has lost its triangles to a neighbour",
     unused_vertex,
     {triangle_entries, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         if (!is_interior(mesh, v)) return false;
         const auto around = edit::neighbour_vertices(mesh, v);
         return std::ranges::any_of(around, [&](Index to) { return edit::collapse(mesh, v, to); });
       });
     }},
};

}  // namespace

std::span<const Defect> defects_of_topology() { return topology_defects; }

}  // namespace pardel::defects
