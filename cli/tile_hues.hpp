// Colours the triangles of a mesh by the tiles (cells of the finest lattice) of the `pardel mesh` run that made the
// mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

enum class HueBy : std::uint8_t {
  tile,    ///< neighbouring cells have different hues
  phase,   ///< cells that are refined at the same time have the same hue
  thread,  ///< one hue per thread; the first thread that worked on the cell counts
};

/// Used instead of a hue: the triangle is drawn in white.
inline constexpr std::uint16_t no_hue = 360;

/// The hue of the phase 0, 1, 2 or 3, and the hue of a thread, counted from 0.
[[nodiscard]] std::uint16_t hue_of_phase(int phase);
[[nodiscard]] std::uint16_t hue_of_thread(int thread);

/// Returns a hue per triangle, in degrees below 360, or no_hue. The hue is that of the cell of the finest lattice that
/// contains the centroid of the triangle; no_hue if no thread worked on the cell. `report`: the report of the run, with
/// the schema pardel.report/1. Any other file is an `invalid_input` error.
[[nodiscard]] Result<std::vector<std::uint16_t>> tile_hues(const Mesh& mesh, const std::filesystem::path& report,
                                                           HueBy by);

}  // namespace pardel::cli
