// The cells in VTK's files: their types (source: vtkCellType.h), and the values of some of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../array.hpp"

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

/// Of the values of all cells, keeps those of the first `leading` cells and of `cells`, in this order. Precondition: no
/// cell moves backwards.
inline void keep_cells(Array<double>& values, std::size_t components, std::size_t leading,
                       const std::vector<std::size_t>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t k = 0; k < components; ++k)
      values[(leading + i) * components + k] = values[cells[i] * components + k];
  values.resize((leading + cells.size()) * components);
}

}  // namespace pardel::files
