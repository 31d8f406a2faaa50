// The lattice of a run of pardel mesh, read back from its report, in colours.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

enum class HueBy : std::uint8_t {
  tile,    ///< neighbouring cells differ
  phase,   ///< cells of one colour work at the same time
  thread,  ///< the first that worked on the cell
};

/// For each triangle the hue (for write_svg) of the cell of the finest lattice that its centroid lies in; none where no
/// thread worked on the cell. `report`: a pardel.report/1 of this mesh; anything else gives invalid_input.
[[nodiscard]] Result<std::vector<std::uint16_t>> tile_hues(const Mesh& mesh, const std::filesystem::path& report,
                                                           HueBy by);

}  // namespace pardel::cli
