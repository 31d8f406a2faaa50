// What messages about a file call a triangle.
#pragma once

#include <cstdint>
#include <string>

#include "../mesh.hpp"

namespace pardel {

/// "triangle 4 (vertices 10, 30, 20)". The number counts from Mesh::first_id; the vertices have the numbers of the
/// file, because not every file numbers triangles. `of_mesh`: what follows the number, such as " of the mesh".
[[nodiscard]] inline std::string name_of_triangle(const Mesh& mesh, Index triangle, const char* of_mesh = "") {
  const auto corner = [&](unsigned i) { return std::to_string(number_in_file(mesh, mesh.triangles[triangle].v[i])); };
  return "triangle " + std::to_string(std::uint64_t{triangle} + static_cast<unsigned>(mesh.first_id.value)) + of_mesh +
         " (vertices " + corner(0) + ", " + corner(1) + ", " + corner(2) + ")";
}

}  // namespace pardel
