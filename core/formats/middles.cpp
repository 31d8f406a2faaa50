#include "middles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "../support/shortest.hpp"

namespace pardel::files {
namespace {

/// Removes the values of the points that have no new index. The other indices ascend.
template <class T>
void keep(Array<T>& values, std::size_t per_point, const std::vector<Index>& number) {
  std::size_t end = 0;
  for (std::size_t node = 0; node < number.size(); ++node)
    for (std::size_t k = 0; k < per_point && number[node] != no_index; ++k)
      values[end++] = values[node * per_point + k];
  values.resize(end);
}

/// The numbers that the points have in the file, if they do not follow one another. Numbers in a file ascend.
void keep_numbers(Mesh& mesh, const std::vector<Index>& number) {
  NumbersInFile numbers;
  for (Index node = 0; node < number.size(); ++node)
    if (number[node] != no_index) numbers.of_points.push_back(number_in_file(mesh, node));
  const std::size_t kept = numbers.of_points.size();
  const bool follow = kept == 0 || numbers.of_points.back() - static_cast<unsigned>(mesh.first_id.value) == kept - 1;
  mesh.numbers = follow ? NumbersInFile{} : std::move(numbers);
}

}  // namespace

Middles middles_of(const Mesh& mesh) {
  EdgeTable table = edge_table(mesh);
  Middles middles{std::move(table.edges), std::move(table.edge_of_side), {}};
  const std::vector<ConstrainedEdge>& lines = mesh.constrained_edges;
  middles.of_line.resize(lines.size(), no_index);
  const ConstrainedEdgeIndex index(mesh);
  // The same for all lines with these ends.
  const auto middle_of = [&](Index a, Index b) -> Index* {
    const ConstrainedEdge* line = index.find(a, b);
    return line == nullptr ? nullptr : &middles.of_line[static_cast<std::size_t>(line - lines.data())];
  };
  for (Index e = 0; e < middles.edges.size(); ++e)
    if (Index* const middle = middle_of(middles.edges[e].a, middles.edges[e].b)) *middle = e;
  for (Index line = 0; line < lines.size(); ++line) {
    Index& middle = *middle_of(lines[line].a, lines[line].b);
    if (middle == no_index) {  // no edge of a triangle
      middle = static_cast<Index>(middles.edges.size());
      middles.edges.push_back({lines[line].a, lines[line].b, lines[line].marker});
    }
    middles.of_line[line] = middle;
  }
  return middles;
}

std::vector<Field> with_middles(std::vector<Field> fields, const Middles& middles) {
  for (Field& field : fields) {
    if (field.place != Field::Place::points) continue;
    const std::size_t of_vertices = field.values.size(), of_middles = middles.edges.size() * field.components;
    field.values.resize(of_vertices + of_middles);
    for (std::size_t i = 0; i < of_middles; ++i)
      field.values[of_vertices + i] = middles.mean(field.values, field.components, i);
  }
  return fields;
}

std::string why_curved(NumberedNode middle, NumberedNode a, NumberedNode b, double unit) {
  const Point at{std::midpoint(a.at.x, b.at.x), std::midpoint(a.at.y, b.at.y)};
  const Point edge{b.at.x - a.at.x, b.at.y - a.at.y}, off{middle.at.x - at.x, middle.at.y - at.y};
  const double length = std::hypot(edge.x, edge.y);
  const double largest = std::max({std::abs(a.at.x), std::abs(a.at.y), std::abs(b.at.x), std::abs(b.at.y)});
  const double rounding = 8 * unit * largest;
  const Point along = length > 0 ? Point{edge.x / length, edge.y / length} : Point{1, 0};
  if (std::abs(off.x * along.x + off.y * along.y) <= 1e-3 * length + rounding &&
      std::abs(off.x * along.y - off.y * along.x) <= 1e-9 * length + rounding)
    return {};
  return "the middle node " + std::to_string(middle.number) + " is at " + shortest(middle.at) +
         ", not in the middle of the edge from node " + std::to_string(a.number) + " to node " +
         std::to_string(b.number) + ", " + shortest(at) + "; curved edges are not supported";
}

std::vector<Index> remove_middles(Mesh& mesh, std::vector<char> is_middle) {
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index corner : triangle.v) is_middle[corner] = 0;
  }
  for (const ConstrainedEdge& edge : mesh.constrained_edges) is_middle[edge.a] = is_middle[edge.b] = 0;
  std::vector<Index> number(mesh.points.size(), no_index);
  Index kept = 0;
  for (std::size_t node = 0; node < number.size(); ++node)
    if (is_middle[node] == 0) number[node] = kept++;
  keep_numbers(mesh, number);
  keep(mesh.points, 1, number);
  keep(mesh.point_attributes, mesh.attributes_per_point, number);
  if (!mesh.point_markers.empty()) keep(mesh.point_markers, 1, number);
  for (Field& field : mesh.fields)
    if (field.place == Field::Place::points) keep(field.values, field.components, number);
  for (Triangle& triangle : mesh.triangles) {
    for (Index& corner : triangle.v) corner = number[corner];
  }
  for (ConstrainedEdge& edge : mesh.constrained_edges) {
    edge.a = number[edge.a];
    edge.b = number[edge.b];
  }
  mesh.left_out.add("the middle nodes of triangles");
  return number;
}

}  // namespace pardel::files
