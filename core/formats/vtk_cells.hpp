// The types of cells in VTK's files. Source: vtkCellType.h.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pardel::files {

inline constexpr std::uint8_t vtk_vertex = 1, vtk_line = 3, vtk_triangle = 5, vtk_line_of_3 = 21,
                              vtk_triangle_of_6 = 22;

/// The number of nodes of a cell, of which the corners are the first; 0 for other types.
[[nodiscard]] constexpr std::size_t nodes_of_vtk_cell(std::int64_t type) {
  if (type == vtk_triangle) return 3;
  if (type == vtk_line) return 2;
  if (type == vtk_triangle_of_6) return 6;
  if (type == vtk_line_of_3) return 3;
  return type == vtk_vertex ? 1 : 0;
}

}  // namespace pardel::files
