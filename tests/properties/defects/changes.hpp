// What a defect changed: the number of entries, by field, in which two cases differ.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <ranges>
#include <vector>

#include "../../../core/goal.hpp"
#include "../../../core/mesh.hpp"
#include "../../../core/pslg.hpp"
#include "../../../properties/defects/defects.hpp"

namespace pardel::defects {

/// A mesh with the Pslg and the goal that it belongs to.
struct MeshedCase {
  Pslg pslg;
  Mesh mesh;
  Goal goal;
};

/// The number of entries that differ: those at the same place, or those that are left between the common beginning and
/// the common end of the two lists, whichever are fewer. So an entry that was replaced, inserted or removed counts
/// once.
template <class List>
std::size_t differing_entries(const List& before, const List& after) {
  const std::size_t shorter = std::min(before.size(), after.size()), longer = std::max(before.size(), after.size());
  std::size_t replaced = longer - shorter, same_at_start = 0, same_at_end = 0;
  for (std::size_t i = 0; i < shorter; ++i) replaced += before[i] == after[i] ? 0 : 1;
  while (same_at_start < shorter && before[same_at_start] == after[same_at_start]) ++same_at_start;
  while (same_at_end < shorter - same_at_start &&
         before[before.size() - 1 - same_at_end] == after[after.size() - 1 - same_at_end])
    ++same_at_end;
  return std::min(replaced, longer - same_at_start - same_at_end);
}

/// The attributes of each point, for a Mesh or a Pslg. The last row may be shorter. Before them one row with their
/// number per point.
template <class Owner>
std::vector<std::vector<double>> attribute_rows(const Owner& owner) {
  const std::size_t width = owner.attributes_per_point;
  std::vector<std::vector<double>> rows{{double(width)}};
  for (std::size_t i = 0; i < owner.point_attributes.size(); ++i) {
    if (width == 0 || i % width == 0) rows.emplace_back();
    rows.back().push_back(owner.point_attributes[i]);
  }
  return rows;
}

template <class Member>
std::vector<Member> of_triangles(const Mesh& mesh, Member Triangle::*member) {
  std::vector<Member> list;
  for (const Triangle& t : mesh.triangles) list.push_back(t.*member);
  return list;
}

inline std::size_t differing_points(const Pslg& a, const Pslg& b) {
  return std::max({differing_entries(a.points, b.points), differing_entries(a.point_markers, b.point_markers),
                   differing_entries(attribute_rows(a), attribute_rows(b))});
}

inline std::size_t differing_bounds(const Goal& a, const Goal& b) {
  return std::size_t{a.min_angle_deg != b.min_angle_deg} + std::size_t{a.max_area != b.max_area} +
         std::size_t{a.max_edge != b.max_edge} + std::size_t{a.grading != b.grading || a.sources != b.sources} +
         std::size_t{a.feature_edges != b.feature_edges} + std::size_t{a.region_caps != b.region_caps} +
         std::size_t{bool(a.size) != bool(b.size)} + std::size_t{bool(a.user_test) != bool(b.user_test)} +
         std::size_t{a.conforming != b.conforming} + std::size_t{a.convex_hull != b.convex_hull};
}

/// The number of entries that differ, for each field with such entries.
inline std::map<Field, std::size_t> changes(const MeshedCase& a, const MeshedCase& b) {
  const Mesh &m = a.mesh, &n = b.mesh;
  std::map<Field, std::size_t> found{
      {Field::corners, differing_entries(of_triangles(m, &Triangle::v), of_triangles(n, &Triangle::v))},
      {Field::neighbours, differing_entries(of_triangles(m, &Triangle::n), of_triangles(n, &Triangle::n))},
      {Field::coordinates, differing_entries(m.points, n.points)},
      {Field::origins, differing_entries(m.origin, n.origin)},
      {Field::markers, differing_entries(m.point_markers, n.point_markers)},
      {Field::attributes, differing_entries(attribute_rows(m), attribute_rows(n))},
      {Field::regions, differing_entries(m.region, n.region)},
      {Field::region_attributes, differing_entries(m.region_attributes, n.region_attributes)},
      {Field::constrained_edges, differing_entries(m.constrained_edges, n.constrained_edges)},
      {Field::input_points, differing_points(a.pslg, b.pslg)},
      {Field::input_segments, differing_entries(a.pslg.segments, b.pslg.segments)},
      {Field::input_holes, differing_entries(a.pslg.holes, b.pslg.holes)},
      {Field::input_regions, differing_entries(a.pslg.regions, b.pslg.regions)},
      {Field::bounds, differing_bounds(a.goal, b.goal)}};
  std::erase_if(found, [](const auto& entry) { return entry.second == 0; });
  return found;
}

}  // namespace pardel::defects
