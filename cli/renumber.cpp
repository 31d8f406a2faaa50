#include "renumber.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "../core/support/used_vertices.hpp"

namespace pardel::cli {
namespace {

Array<double> renumbered(const Field& field, std::span<const Index> number, std::size_t count) {
  const std::size_t width = field.components;
  Array<double> values(count * width, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t old = 0; old < number.size(); ++old)
    if (number[old] != no_index)
      std::copy_n(field.values.begin() + old * width, width, values.begin() + number[old] * width);
  return values;
}

/// Vertex `old` becomes vertex `number[old]`; it is removed if `number[old]` is no_index. The new numbers are distinct
/// and below `count`. The caller fills the data of new vertices that no old vertex becomes.
void renumber(Mesh& mesh, std::span<const Index> number, std::size_t count) {
  const std::size_t width = mesh.attributes_per_point;
  Array<Point> points(count);
  Array<Index> origin(mesh.origin.empty() ? 0 : count, input_vertex);
  Array<double> attributes(count * width, 0.0);
  Array<int> markers(mesh.point_markers.empty() ? 0 : count, 0);
  for (std::size_t old = 0; old < number.size(); ++old) {
    if (number[old] == no_index) continue;
    points[number[old]] = mesh.points[old];
    if (!origin.empty()) origin[number[old]] = mesh.origin[old];
    if (!markers.empty()) markers[number[old]] = mesh.point_markers[old];
    for (std::size_t k = 0; k < width; ++k) {
      attributes[number[old] * width + k] = mesh.point_attributes[old * width + k];
    }
  }
  for (Field& field : mesh.fields)
    if (field.place == Field::Place::points) field.values = renumbered(field, number, count);
  mesh.numbers = {};
  mesh.points.swap(points);
  mesh.origin.swap(origin);
  mesh.point_attributes.swap(attributes);
  mesh.point_markers.swap(markers);
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t.v) v = number[v];
  }
  std::erase_if(mesh.constrained_edges,
                [&](const ConstrainedEdge& e) { return number[e.a] == no_index || number[e.b] == no_index; });
  for (ConstrainedEdge& e : mesh.constrained_edges) {
    e.a = number[e.a];
    e.b = number[e.b];
  }
}

}  // namespace

std::vector<Index> remove_unused_vertices(Mesh& mesh) {
  const std::vector<char> is_used = used_vertices(mesh);
  std::vector<Index> number(is_used.size(), no_index);
  Index count = 0;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0) number[v] = count++;
  renumber(mesh, number, count);
  return number;
}

std::vector<Index> restore_numbering(Mesh& mesh, const Pslg& original, std::span<const Index> point_map) {
  std::vector<Index> number(mesh.points.size(), no_index);
  std::vector<Index> merged;
  for (Index i = 0; i < point_map.size(); ++i) {
    if (point_map[i] != no_index && number[point_map[i]] == no_index) {
      number[point_map[i]] = i;
    } else {
      merged.push_back(i);
    }
  }
  auto count = static_cast<Index>(original.points.size());
  for (Index& n : number) {
    if (n == no_index) n = count++;
  }
  renumber(mesh, number, count);
  const std::size_t width = mesh.attributes_per_point;
  for (const Index i : merged) {
    mesh.points[i] = original.points[i];
    if (!mesh.point_markers.empty() && !original.point_markers.empty()) {
      mesh.point_markers[i] = original.point_markers[i];
    }
    for (std::size_t k = 0; k < width; ++k)
      mesh.point_attributes[i * width + k] = original.point_attributes[i * width + k];
  }
  return number;
}

}  // namespace pardel::cli
