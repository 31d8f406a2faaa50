// Defects of arrays and numbers: wrong lengths, indices out of range, coordinates that are not finite.
#include <cmath>
#include <limits>

#include "defect_groups.hpp"

namespace pardel::defects {
namespace {

using enum ViolationKind;

/// Removes all entries. Returns false if there are none.
template <class List>
bool clear(List& list) {
  if (list.empty()) return false;
  list.clear();
  return true;
}

constexpr Defect array_defects[] = {
    {"a corner of a triangle is the index just past the last vertex",
     index_out_of_range,
     {Field::corners},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](edit::Side s) {
         mesh.triangles[s.t].v[s.i] = static_cast<Index>(mesh.points.size());
         return true;
       });
     }},
    {"a corner of a triangle is no_index",
     index_out_of_range,
     {Field::corners},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](edit::Side s) {
         mesh.triangles[s.t].v[s.i] = no_index;
         return true;
       });
     }},
    {"a neighbour is the index just past the last triangle",
     index_out_of_range,
     {Field::neighbours},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_side(mesh, seed, [&](edit::Side s) {
         mesh.triangles[s.t].n[s.i] = static_cast<Index>(mesh.triangles.size());
         return true;
       });
     }},
    {"a triangle has a region that does not exist",
     index_out_of_range,
     {Field::regions},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.region.size(), seed, [&](Index t) {
         mesh.region[t] = static_cast<Index>(mesh.region_attributes.size());
         return true;
       });
     }},
    {"a constrained edge has a vertex that does not exist",
     index_out_of_range,
     {Field::constrained_edges},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.constrained_edges.size(), seed, [&](Index e) {
         mesh.constrained_edges[e].b = static_cast<Index>(mesh.points.size() + 7);
         return true;
       });
     }},
    {"a constrained edge has a segment that does not exist",
     index_out_of_range,
     {Field::constrained_edges},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(mesh.constrained_edges.size(), seed, [&](Index e) {
         mesh.constrained_edges[e].segment = static_cast<Index>(pslg.segments.size());
         return true;
       });
     }},
    {"the last point is cut off",
     index_out_of_range,
     {vertex_entries},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.points.size() == pslg.points.size()) return false;
       mesh.points.pop_back();
       mesh.origin.pop_back();
       if (!mesh.point_markers.empty()) mesh.point_markers.pop_back();
       mesh.point_attributes.resize(mesh.points.size() * mesh.attributes_per_point);
       return true;
     }},
    {"the second half of the triangles is cut off",
     index_out_of_range,
     {triangle_entries, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.triangles.size() < 4) return false;
       mesh.triangles.resize(mesh.triangles.size() / 2);
       if (!mesh.region.empty()) mesh.region.resize(mesh.triangles.size());
       return true;
     }},
    {"a coordinate is not a number",
     non_finite_coordinate,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         mesh.points[v].x = std::numeric_limits<double>::quiet_NaN();
         return true;
       });
     }},
    {"a coordinate is infinite",
     non_finite_coordinate,
     {Field::coordinates},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some_vertex(mesh, seed, [&](Index v) {
         mesh.points[v].y = -std::numeric_limits<double>::infinity();
         return true;
       });
     }},
    {"origins end one vertex early",
     wrong_count,
     {Field::origins},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.origin.size() < 2) return false;
       mesh.origin.pop_back();
       return true;
     }},
    {"the origins are missing",
     wrong_count,
     {Field::origins, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) { return clear(mesh.origin); }},
    {"the regions are missing",
     wrong_count,
     {Field::regions, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) { return clear(mesh.region); }},
    {"the vertex markers are missing",
     wrong_count,
     {Field::markers, any_number},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t) {
       return !pslg.point_markers.empty() && clear(mesh.point_markers);
     }},
    {"the attributes of points are missing",
     wrong_count,
     {Field::attributes, any_number},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (!clear(mesh.point_attributes)) return false;
       mesh.attributes_per_point = 0;
       return true;
     }},
    {"regions end one triangle early",
     wrong_count,
     {Field::regions},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.region.size() < 2) return false;
       mesh.region.pop_back();
       return true;
     }},
    {"there is one region more than triangles",
     wrong_count,
     {Field::regions},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.region.empty()) return false;
       mesh.region.push_back(mesh.region.back());
       return true;
     }},
    {"there is one vertex marker more than vertices",
     wrong_count,
     {Field::markers},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.point_markers.empty()) return false;
       mesh.point_markers.push_back(0);
       return true;
     }},
    {"vertex markers stop after the input",
     wrong_count,
     {Field::markers, any_number},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.point_markers.size() <= pslg.points.size()) return false;
       mesh.point_markers.resize(pslg.points.size());
       return true;
     }},
    {"the last point attribute is missing",
     wrong_count,
     {Field::attributes},
     [](Pslg&, Mesh& mesh, Goal&, std::uint64_t) {
       if (mesh.point_attributes.empty()) return false;
       mesh.point_attributes.pop_back();
       return true;
     }},
    {"an input vertex has another attribute",
     wrong_attribute,
     {Field::attributes},
     [](Pslg& pslg, Mesh& mesh, Goal&, std::uint64_t seed) {
       return at_some(pslg.point_attributes.size(), seed, [&](Index k) {
         mesh.point_attributes[k] = edit::another_number(mesh.point_attributes[k]);
         return true;
       });
     }},
};

}  // namespace

std::span<const Defect> defects_of_arrays() { return array_defects; }

}  // namespace pardel::defects
