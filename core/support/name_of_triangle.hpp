// What messages about a file call a triangle.
#pragma once

#include <cstdint>
#include <string>

#include "../mesh.hpp"

namespace pardel {

/// "triangle 4 (vertices 10, 30, 20)". The triangle and the vertices have the numbers of the file; vertices are named,
/// because not every file numbers triangles. `of_mesh`: what follows the number, such as " of the mesh".
[[nodiscard]] inline std::string name_of_triangle(const Mesh& mesh, Index triangle, const char* of_mesh = "") {
  const auto corner = [&](unsigned i) { return std::to_string(number_in_file(mesh, mesh.triangles[triangle].v[i])); };
  return "triangle " + std::to_string(number_of_triangle_in_file(mesh, triangle)) + of_mesh + " (vertices " +
         corner(0) + ", " + corner(1) + ", " + corner(2) + ")";
}

}  // namespace pardel
