// Meshes in version 2.2 of MSH, which the library only reads.
#include <string>

#include "../../core/support/shortest.hpp"
#include "formats.hpp"
#include "values.hpp"

namespace pardel::fuzz {

using generators::Random;

KnownFile any_msh_2(Random& random) {
  Mesh mesh = any_mesh(random);
  mesh.attributes_per_point = 0;
  mesh.point_attributes.clear();
  mesh.point_markers.clear();
  mesh.region.clear();
  mesh.region_attributes = {3, 7};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.region.push_back(static_cast<Index>(random.below(2)));
  for (ConstrainedEdge& edge : mesh.constrained_edges) edge.marker = random.between(1, 9);

  // In $ParametricNodes a node also has the dimension and the number of an entity, and parameters.
  constexpr const char* parameters[] = {"", " 0 1", " 1 1 0.5", " 2 1 0.5 0.25", " 3 1"};
  const bool parametric = random.chance(2);
  const std::string nodes = parametric ? "ParametricNodes" : "Nodes";
  std::string file =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$" + nodes + "\n" + std::to_string(mesh.points.size()) + "\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    file += std::to_string(i + 1) + " " + shortest(mesh.points[i].x) + " " + shortest(mesh.points[i].y) + " 0" +
            parameters[parametric ? random.between(1, 4) : 0] + "\n";
  file +=
      "$End" + nodes + "\n$Elements\n" + std::to_string(mesh.constrained_edges.size() + mesh.triangles.size()) + "\n";
  // An element: number, kind (1: line, 2: triangle), number of tags, physical group, entity, nodes.
  std::size_t number = 0;
  const auto begin_element = [&](const char* kind, int group) {
    file += std::to_string(++number) + kind + std::to_string(group) + " " + std::to_string(group);
  };
  for (const ConstrainedEdge& edge : mesh.constrained_edges) {
    begin_element(" 1 2 ", edge.marker);
    file += " " + std::to_string(edge.a + 1) + " " + std::to_string(edge.b + 1) + "\n";
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    begin_element(" 2 2 ", static_cast<int>(mesh.region_attributes[mesh.region[t]]));
    for (const Index v : mesh.triangles[t].v) file += " " + std::to_string(v + 1);
    file += "\n";
  }
  return {file + "$EndElements\n", std::move(mesh), false};
}

}  // namespace pardel::fuzz
