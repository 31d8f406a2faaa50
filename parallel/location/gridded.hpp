// The triangles of a list in the cells of a grid.
#pragma once

#include <optional>
#include <span>

#include "../../core/array.hpp"
#include "../threads/threads.hpp"
#include "located_triangles.hpp"
#include "location_grid.hpp"

namespace pardel::engine {

struct GriddedTriangles {
  LocationGrid grid;
  Array<Index> start;      ///< of each cell in `triangles`; one more at the end
  Array<Index> triangles;  ///< those with points in each cell, in ascending order, and few others

  [[nodiscard]] std::span<const Index> in_cell(std::size_t cell) const {
    return triangles.span().subspan(start[cell], start[cell + 1] - start[cell]);
  }
};

/// Puts triangles into a grid that has about half as many cells. The cells have the shape of the typical triangle's
/// box. The grid lies over most of the triangles; its unbounded cells have those outside. Nothing if most triangles
/// would be in one cell, or in very many cells. O(n) for n triangles.
[[nodiscard]] std::optional<GriddedTriangles> gridded(const LocatedTriangles& all, std::span<const Index> list,
                                                      const Threads& threads);

}  // namespace pardel::engine
