// Colours for the triangles of a mesh by the tiles of the run of pardel mesh that made it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

enum class HueBy : std::uint8_t {
  tile,    ///< neighbouring cells have different hues
  phase,   ///< cells that are refined at the same time have one hue
  thread,  ///< a hue for each thread, by the first that worked on the cell
};

/// For each triangle the hue, as write_svg() takes it, of the cell of the finest lattice that contains its centroid;
/// no_hue where no thread worked on the cell. `report`: the report of the run, with the schema pardel.report/1. Any
/// other file gives `invalid_input`.
[[nodiscard]] Result<std::vector<std::uint16_t>> tile_hues(const Mesh& mesh, const std::filesystem::path& report,
                                                           HueBy by);

}  // namespace pardel::cli
