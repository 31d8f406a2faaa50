// The names of fields in a VTU file, and in a legacy file of VTK.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../formats.hpp"
#include "../support/same_attribute.hpp"
#include "../support/smallest_angle.hpp"
#include "xml_tag.hpp"

namespace pardel::files {

/// True if the mesh has a field with the name of the array that write_vtu() computes. It is written instead.
[[nodiscard]] inline bool has_own_quality(const Mesh& mesh) {
  return std::ranges::any_of(mesh.fields, [](const Field& field) {
    return field.place == Field::Place::triangles && field.name == vtu_quality;
  });
}

/// True for a field that has the name and the values of the array that write_vtu() computes. The first triangles
/// decide.
[[nodiscard]] inline bool is_quality(const Field& field, const Mesh& mesh) {
  if (field.place != Field::Place::triangles || field.name != vtu_quality || field.components != 1) return false;
  constexpr std::size_t enough = 100;
  for (std::size_t t = 0; t < std::min(enough, mesh.triangles.size()); ++t) {
    const auto& v = mesh.triangles[t].v;
    const double angle = smallest_angle({mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]});
    if (!is_same_attribute(angle, field.values[t]) && !(std::abs(angle - field.values[t]) < 1e-6)) return false;
  }
  return true;
}

/// One name per field. The arrays of points have distinct names, and so have those of cells, different from those of
/// the mesh itself: where a name is taken, a number follows it.
[[nodiscard]] inline std::vector<std::string> names_of_vtu_fields(const Mesh& mesh) {
  std::vector<std::string> at_points = {"marker", "attributes", vtu_vertex_numbers},
                           in_triangles = {"region", "marker"};
  std::vector<std::string> names;
  for (const Field& field : mesh.fields) {
    std::vector<std::string>& taken = field.place == Field::Place::points ? at_points : in_triangles;
    std::string name = field.name;
    for (int n = 2; std::ranges::find(taken, name) != taken.end(); ++n) name = field.name + " " + std::to_string(n);
    taken.push_back(name);
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace pardel::files
