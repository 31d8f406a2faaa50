// Defects of coverage: parts of the domain without triangles, and triangles outside the domain.
#include <algorithm>
#include <map>

#include "defect_groups.hpp"

namespace pardel::defects {
namespace {

using edit::Side;
using enum ViolationKind;

bool touches_constraint(const Mesh& mesh, Index t) {
  const auto walls = edit::constrained(mesh);
  return std::ranges::any_of(std::array{0, 1, 2}, [&](int i) {
    return walls.contains(edit::ends(edit::tail(mesh, {t, i}), edit::head(mesh, {t, i})));
  });
}

bool disjoint(const Triangle& t, const Triangle& u) {
  return std::ranges::none_of(t.v, [&](Index v) { return std::ranges::count(u.v, v) != 0; });
}

/// Removes the triangles for which `drop` is true. Changes nothing and returns false if it is true for none or for all.
template <class Drop>
bool drop_triangles(Mesh& mesh, const Drop& drop) {
  std::vector<Index> ids;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (drop(t)) ids.push_back(t);
  if (ids.empty() || ids.size() == mesh.triangles.size()) return false;
  edit::erase_triangles(mesh, ids);
  return true;
}

/// For each boundary vertex the next vertex of the boundary, with the outside of the mesh on the left. Vertices at
/// which two parts of the boundary touch have no entry.
std::map<Index, Index> outside_paths(const Mesh& mesh) {
  std::map<Index, Index> next;
  std::map<Index, int> times;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (const Side s{t, i}; edit::across(mesh, s) == no_index) {
        next[edit::head(mesh, s)] = edit::tail(mesh, s);
        ++times[edit::head(mesh, s)];
      }
  for (const auto& [v, count] : times)
    if (count > 1) next.erase(v);
  return next;
}

/// True if a, b, c are counter-clockwise and none of the other vertices lies in the triangle or on its border.
bool is_ear(const Mesh& mesh, Index a, Index b, Index c, const std::vector<Index>& others) {
  if (edit::orientation(mesh, a, b, c) <= 0) return false;
  return std::ranges::none_of(others, [&](Index v) {
    return v != a && v != b && v != c && edit::orientation(mesh, a, b, v) >= 0 &&
           edit::orientation(mesh, b, c, v) >= 0 && edit::orientation(mesh, c, a, v) >= 0;
  });
}

/// Triangulates a simple counter-clockwise polygon by cutting ears. False if there is no ear.
bool fill(Mesh& mesh, std::vector<Index> polygon) {
  std::vector<std::array<Index, 3>> ears;
  while (polygon.size() > 2) {
    const std::size_t n = polygon.size();
    const bool cut = at_some(n, 0, [&](Index k) {
      const Index a = polygon[k], b = polygon[(k + 1) % n], c = polygon[(k + 2) % n];
      if (!is_ear(mesh, a, b, c, polygon)) return false;
      ears.push_back({a, b, c});
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>((k + 1) % n));
      return true;
    });
    if (!cut) return false;
  }
  for (const auto& v : ears) edit::append_triangle(mesh, v);
  edit::relink(mesh);
  return true;
}

/// The loop of outside_paths() from v; empty if the path does not return to v.
std::vector<Index> loop_from(const std::map<Index, Index>& next, Index v) {
  std::vector<Index> loop = {v};
  for (auto at = next.find(v); at != next.end(); at = next.find(at->second)) {
    if (at->second == v) return loop;
    if (loop.size() > next.size()) break;
    loop.push_back(at->second);
  }
  return {};
}

double signed_area(const Mesh& mesh, const std::vector<Index>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point p = mesh.points[polygon[i]], q = mesh.points[polygon[(i + 1) % polygon.size()]];
    sum += p.x * q.y - q.x * p.y;
  }
  return sum / 2;
}

std::vector<Index> all_vertices(const Mesh& mesh) {
  std::vector<Index> all;
  for (Index v = 0; v < mesh.points.size(); ++v) all.push_back(v);
  return all;
}

/// Adds the triangle on the outer side of the boundary side s whose third corner is a new point at p.
bool add_outside(Mesh& mesh, Side s, Point p) {
  const Index tip = edit::append_point(mesh, p);
  if (edit::orientation(mesh, edit::head(mesh, s), edit::tail(mesh, s), tip) <= 0) {
    edit::erase_unused_point(mesh, tip);
    return false;
  }
  edit::append_triangle(mesh, {edit::head(mesh, s), edit::tail(mesh, s), tip}, edit::region_of(mesh, s.t));
  edit::relink(mesh);
  return true;
}

constexpr Defect coverage_defects[] = {
    {"a triangle in the middle is dropped",
     uncovered_domain,
     {triangle_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         return !touches_constraint(mesh, t) && drop_triangles(mesh, [&](Index u) { return u == t; });
       });
     }},
    {"a triangle at the boundary is dropped",
     uncovered_domain,
     {triangle_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         return edit::across(mesh, s) == no_index && drop_triangles(mesh, [&](Index u) { return u == s.t; });
       });
     }},
    {"all triangles of a vertex are dropped",
     uncovered_domain,
     {triangle_entries, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         const auto star = edit::star(mesh, v);
         return drop_triangles(mesh, [&](Index u) { return std::ranges::count(star, u) != 0; });
       });
     }},
    {"a face of the domain is missing",
     uncovered_domain,
     {triangle_entries, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto face = edit::faces(mesh);
       return drop_triangles(mesh, [&](Index t) { return face[t] == face[another(seed, face.size())]; });
     }},
    {"no triangle is left",
     missing_input_vertex,
     {triangle_entries, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       mesh.triangles.clear();
       mesh.region.clear();
       return true;
     }},
    {"a hole is filled",
     covered_exterior,
     {Field::corners, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto next = outside_paths(mesh);
       return at_some_vertex(mesh, seed, [&](Index v) {
         const std::vector<Index> loop = loop_from(next, v);
         return signed_area(mesh, loop) > 0 && fill(mesh, loop);
       });
     }},
    {"a concave corner of the outside is filled",
     covered_exterior,
     {Field::corners},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto next = outside_paths(mesh);
       const auto all = all_vertices(mesh);
       return at_some_vertex(mesh, seed, [&](Index a) {
         if (!next.contains(a) || !next.contains(next.at(a))) return false;
         const Index b = next.at(a), c = next.at(b);
         if (!is_ear(mesh, a, b, c, all)) return false;
         edit::append_triangle(mesh, {a, b, c});
         edit::relink(mesh);
         return true;
       });
     }},
    {"a triangle is added outside",
     covered_exterior,
     {vertex_entries | triangle_entries},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         if (edit::across(mesh, s) != no_index) return false;
         const Point a = mesh.points[edit::tail(mesh, s)], b = mesh.points[edit::head(mesh, s)];
         const Point middle = edit::between(a, b);
         return add_outside(mesh, s, {middle.x + (b.y - a.y) / 8, middle.y - (b.x - a.x) / 8});
       });
     }},
    {"a triangle reaches over a gap onto others",
     overlap,
     {Field::coordinates | Field::origins | Field::markers | Field::corners},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](Side s) {
         const Index other = another(seed, mesh.triangles.size());
         if (edit::across(mesh, s) != no_index || !disjoint(mesh.triangles[s.t], mesh.triangles[other])) return false;
         return add_outside(mesh, s, edit::centroid(mesh, other));
       });
     }},
    {"a copy of a triangle with new corners lies on the triangle",
     overlap,
     {vertex_entries | triangle_entries, 3},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         std::array<Index, 3> copy{};
         for (int i = 0; i < 3; ++i) copy[i] = edit::append_point(mesh, mesh.points[mesh.triangles[t].v[i]]);
         edit::append_triangle(mesh, copy, edit::region_of(mesh, t));
         return true;
       });
     }},
    {"a triangle outside touches the boundary in a vertex",
     covered_exterior,
     {vertex_entries | triangle_entries, 2},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       // A sliver outside the mesh, next to the side s, with a corner at the tail of s.
       return at_some_side(mesh, seed, [&](Side s) {
         if (edit::across(mesh, s) != no_index) return false;
         const Index v = edit::tail(mesh, s);
         const Point a = mesh.points[v], b = mesh.points[edit::head(mesh, s)];
         const Point out{(b.y - a.y) / 64, (a.x - b.x) / 64};
         const Point near{a.x + (b.x - a.x) / 4, a.y + (b.y - a.y) / 4};
         const Index p = edit::append_point(mesh, {near.x + 2 * out.x, near.y + 2 * out.y});
         const Index q = edit::append_point(mesh, {near.x + out.x, near.y + out.y});
         edit::append_triangle(mesh, {v, p, q}, edit::region_of(mesh, s.t));
         return true;
       });
     }},
    {"a vertex is there twice: the mesh is slit open along two edges",
     uncovered_domain,
     {vertex_entries | Field::corners, 8},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         const auto star = edit::star(mesh, v);
         if (!is_interior(mesh, v) || star.size() < 4) return false;
         // In half of the triangles around v, the copy replaces v.
         const Index copy = edit::append_point(mesh, mesh.points[v]);
         Index t = star[0];
         for (std::size_t k = 0; k < star.size() / 2; ++k) {
           auto& corners = mesh.triangles[t].v;
           const auto i = static_cast<int>(std::ranges::find(corners, v) - corners.begin());
           corners[i] = copy;
           t = mesh.triangles[t].n[(i + 1) % 3];
         }
         edit::relink(mesh);
         return true;
       });
     }},
};

}  // namespace

std::span<const Defect> defects_of_coverage() { return coverage_defects; }

}  // namespace pardel::defects
