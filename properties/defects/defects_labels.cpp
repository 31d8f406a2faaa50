// Defects of labels: constrained edges, markers, origins, regions; and inputs to which the mesh does not belong.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../checker/arithmetic/exact.hpp"
#include "defect_groups.hpp"

namespace pardel::defects {
namespace {

using edit::Side;
using enum ViolationKind;

template <class Attempt>
bool at_some_constrained(Mesh& mesh, std::uint64_t seed, const Attempt& attempt) {
  return at_some(mesh.constrained_edges.size(), seed, [&](Index e) { return attempt(mesh.constrained_edges[e]); });
}

bool on_boundary(const Mesh& mesh, const ConstrainedEdge& e) {
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (const Side s{t, i}; edit::ends(edit::tail(mesh, s), edit::head(mesh, s)) == edit::ends(e.a, e.b))
        return edit::across(mesh, s) == no_index;
  return false;
}

/// True if a segment between these input points would cross no segment and pass through no point.
bool free_of_others(const Pslg& pslg, Index a, Index b) {
  const auto turn = [&](Index p, Index q, Index r) {
    return checker::exactly::orientation(pslg.points[p], pslg.points[q], pslg.points[r]);
  };
  for (Index v = 0; v < pslg.points.size(); ++v)
    if (v != a && v != b && turn(a, b, v) == 0) return false;
  return std::ranges::none_of(pslg.segments, [&](const Segment& s) {
    return turn(a, b, s.a) * turn(a, b, s.b) < 0 && turn(s.a, s.b, a) * turn(s.a, s.b, b) < 0;
  });
}

/// True if an edge of the mesh crosses ab and both its ends are further from the line ab than rounding explains.
bool some_edge_crosses(const Mesh& mesh, Index a, Index b) {
  const auto is_clear = [&](Index v) {
    const double far = 0x1p-20 * edit::length(mesh, a, b);
    return checker::exactly::line_offset_exceeds(mesh.points[v], mesh.points[a], mesh.points[b], {far, far});
  };
  return at_some_side(mesh, 0, [&](Side s) {
    const Index p = edit::tail(mesh, s), q = edit::head(mesh, s);
    return edit::across(mesh, s) != no_index &&
           edit::orientation(mesh, a, b, p) * edit::orientation(mesh, a, b, q) < 0 &&
           edit::orientation(mesh, p, q, a) * edit::orientation(mesh, p, q, b) < 0 && is_clear(p) && is_clear(q);
  });
}

/// Replaces the entry of Mesh::origin of one vertex for which `suits` is true.
template <class Suits>
bool change_origin(Mesh& mesh, std::uint64_t seed, Index origin, const Suits& suits) {
  return at_some_vertex(mesh, seed, [&](Index v) {
    if (!suits(v) || mesh.origin[v] == origin) return false;
    mesh.origin[v] = origin;
    return true;
  });
}

constexpr Defect label_defects[] = {
    {"a constrained edge is not listed",
     missing_constrained_edge,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       auto& edges = mesh.constrained_edges;
       return at_some(edges.size(), seed, [&](Index e) {
         edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(e));
         return true;
       });
     }},
    {"no constrained edge is listed",
     missing_constrained_edge,
     {Field::constrained_edges, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.constrained_edges.empty()) return false;
       mesh.constrained_edges.clear();
       return true;
     }},
    {"a free edge is listed as constrained",
     wrong_constrained_edge,
     {Field::constrained_edges},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto walls = edit::constrained(mesh);
       return !pslg.segments.empty() && at_some_side(mesh, seed, [&](Side s) {
         const auto [a, b] = edit::ends(edit::tail(mesh, s), edit::head(mesh, s));
         if (walls.contains({a, b})) return false;
         mesh.constrained_edges.push_back({a, b, another(seed, pslg.segments.size()), 0});
         return true;
       });
     }},
    {"a free edge is listed as one of the hull",
     wrong_constrained_edge,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto walls = edit::constrained(mesh);
       return at_some_side(mesh, seed, [&](Side s) {
         const auto [a, b] = edit::ends(edit::tail(mesh, s), edit::head(mesh, s));
         if (walls.contains({a, b})) return false;
         mesh.constrained_edges.push_back({a, b, no_index, 1});
         return true;
       });
     }},
    {"two vertices that share no edge are listed as a constrained edge",
     wrong_constrained_edge,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       if (mesh.constrained_edges.empty()) return false;
       return at_some_vertex(mesh, seed, [&](Index a) {
         const auto around = edit::neighbour_vertices(mesh, a);
         const Index b = another(seed, mesh.points.size());
         if (a == b || around.empty() || std::ranges::count(around, b) != 0) return false;
         mesh.constrained_edges.push_back({a, b, mesh.constrained_edges[0].segment, 0});
         return true;
       });
     }},
    {"a constrained edge is listed twice",
     wrong_constrained_edge,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.constrained_edges.size(), seed, [&](Index e) {
         const ConstrainedEdge copy = mesh.constrained_edges[e];
         mesh.constrained_edges.push_back({copy.b, copy.a, copy.segment, copy.marker});
         return true;
       });
     }},
    {"a constrained edge names another segment",
     wrong_constrained_edge,
     {Field::constrained_edges},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_constrained(mesh, seed, [&](ConstrainedEdge& e) {
         if (pslg.segments.size() < 2 || e.segment == no_index) return false;
         e.segment = static_cast<Index>((e.segment + 1) % pslg.segments.size());
         return true;
       });
     }},
    {"a piece of a segment is listed as an edge of the hull",
     wrong_constrained_edge,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_constrained(mesh, seed,
                                  [&](ConstrainedEdge& e) { return std::exchange(e.segment, no_index) != no_index; });
     }},
    {"an edge has lost its marker",
     wrong_edge_marker,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_constrained(mesh, seed, [&](ConstrainedEdge& e) { return std::exchange(e.marker, 0) != 0; });
     }},
    {"an edge has another marker",
     wrong_edge_marker,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_constrained(mesh, seed, [&](ConstrainedEdge& e) {
         ++e.marker;
         return true;
       });
     }},
    {"an unmarked edge of the boundary is not marked 1",
     wrong_edge_marker,
     {Field::constrained_edges},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_constrained(mesh, seed, [&](ConstrainedEdge& e) {
         const bool unmarked = e.segment == no_index || pslg.segments[e.segment].marker == 0;
         if (!unmarked || !on_boundary(mesh, e)) return false;
         e.marker = 0;
         return true;
       });
     }},
    {"an unmarked edge inside is marked as boundary",
     wrong_edge_marker,
     {Field::constrained_edges},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_constrained(mesh, seed, [&](ConstrainedEdge& e) {
         const bool unmarked = e.segment == no_index || pslg.segments[e.segment].marker == 0;
         if (!unmarked || on_boundary(mesh, e)) return false;
         e.marker = 1;
         return true;
       });
     }},
    {"a vertex has lost its marker",
     wrong_vertex_marker,
     {Field::markers},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.point_markers.size(), seed,
                      [&](Index v) { return std::exchange(mesh.point_markers[v], 0) != 0; });
     }},
    {"a vertex on a segment has lost its marker",
     wrong_vertex_marker,
     {Field::markers},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.point_markers.size(), seed, [&](Index v) {
         return is_on_segment(pslg, mesh, v) && std::exchange(mesh.point_markers[v], 0) != 0;
       });
     }},
    {"a vertex inside has a marker",
     wrong_vertex_marker,
     {Field::markers},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.point_markers.size(), seed,
                      [&](Index v) { return is_interior(mesh, v) && std::exchange(mesh.point_markers[v], 17) != 17; });
     }},
    {"a triangle lies in another region",
     wrong_region,
     {Field::regions},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.region.size(), seed, [&](Index t) {
         const auto regions = static_cast<Index>(mesh.region_attributes.size());
         if (regions < 2 || mesh.region[t] == no_index) return false;
         mesh.region[t] = (mesh.region[t] + 1) % regions;
         return true;
       });
     }},
    {"two regions have swapped their triangles",
     wrong_region,
     {Field::regions, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.region_attributes.size() < 2) return false;
       for (Index& r : mesh.region) r = r == 0 ? 1 : r == 1 ? 0 : r;
       return true;
     }},
    {"a triangle has lost its region",
     wrong_region,
     {Field::regions},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.region.size(), seed,
                      [&](Index t) { return std::exchange(mesh.region[t], no_index) != no_index; });
     }},
    {"a triangle outside all regions is given one",
     wrong_region,
     {Field::regions},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return !mesh.region_attributes.empty() && at_some(mesh.region.size(), seed, [&](Index t) {
         if (mesh.region[t] != no_index) return false;
         mesh.region[t] = 0;
         return true;
       });
     }},
    {"a region has another attribute",
     wrong_region,
     {Field::region_attributes},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.region_attributes.size(), seed, [&](Index r) {
         mesh.region_attributes[r] = edit::another_number(mesh.region_attributes[r]);
         return true;
       });
     }},
    {"a vertex of a segment is listed as interior",
     wrong_origin,
     {Field::origins},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return change_origin(mesh, seed, interior_vertex, [&](Index v) { return is_on_segment(pslg, mesh, v); });
     }},
    {"an interior vertex is listed on a segment",
     wrong_origin,
     {Field::origins},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return !pslg.segments.empty() &&
              change_origin(mesh, seed, origin_on_segment(another(seed, pslg.segments.size())),
                            [&](Index v) { return is_interior(mesh, v); });
     }},
    {"a vertex of a segment is listed on another segment",
     wrong_origin,
     {Field::origins},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return !pslg.segments.empty() &&
              change_origin(mesh, seed, origin_on_segment(another(seed, pslg.segments.size())),
                            [&](Index v) { return is_on_segment(pslg, mesh, v); });
     }},
    {"a new vertex is listed as input",
     wrong_origin,
     {Field::origins},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return change_origin(mesh, seed, input_vertex, [&](Index v) { return v >= pslg.points.size(); });
     }},
    {"an input vertex is listed as new",
     wrong_origin,
     {Field::origins},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return change_origin(mesh, seed, interior_vertex, [&](Index v) { return v < pslg.points.size(); });
     }},
    {"an interior vertex is listed on the hull",
     wrong_origin,
     {Field::origins},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return change_origin(mesh, seed, hull_vertex, [&](Index v) { return is_interior(mesh, v); });
     }},
    {"an origin is a segment that does not exist",
     wrong_origin,
     {Field::origins},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return change_origin(mesh, seed, origin_on_segment(static_cast<Index>(pslg.segments.size() + 3)),
                            [&](Index v) { return is_on_segment(pslg, mesh, v); });
     }},
    {"the input has a segment that the mesh lacks",
     broken_segment,
     {Field::input_segments},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       const Index a = another(seed, pslg.points.size());
       return !pslg.segments.empty() && at_some(pslg.points.size(), seed, [&](Index b) {
         if (a == b || !free_of_others(pslg, a, b) || !some_edge_crosses(mesh, a, b)) return false;
         pslg.segments.push_back({a, b, 0});
         return true;
       });
     }},
    {"the input has a point that the mesh lacks",
     missing_input_vertex,
     {Field::input_points},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_triangle(mesh, seed, [&](Index t) {
         pslg.points.push_back(edit::centroid(mesh, t));
         if (!pslg.point_markers.empty()) pslg.point_markers.push_back(0);
         pslg.point_attributes.resize(pslg.points.size() * pslg.attributes_per_point);
         return true;
       });
     }},
    {"the input has a hole that the mesh lacks",
     covered_exterior,
     {Field::input_holes},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       const auto face = edit::faces(mesh);
       if (std::ranges::count(face, 0) == std::ssize(face)) return false;  // nothing would be left
       return at_some_triangle(mesh, seed, [&](Index t) {
         if (edit::region_of(mesh, t) != no_index) return false;
         pslg.holes.push_back(edit::centroid(mesh, t));
         return true;
       });
     }},
    {"the mesh has a hole that the input lacks",
     uncovered_domain,
     {Field::input_holes},
     [](Pslg& pslg, Mesh&, Goal&, std::uint64_t seed) {
       return at_some(pslg.holes.size(), seed, [&](Index h) {
         pslg.holes.erase(pslg.holes.begin() + static_cast<std::ptrdiff_t>(h));
         return true;
       });
     }},
};

}  // namespace

std::span<const Defect> defects_of_labels() { return label_defects; }

}  // namespace pardel::defects
