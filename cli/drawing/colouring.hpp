// The colours of the triangles of a picture, and their legend.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "../../core/mesh.hpp"
#include "../../core/result.hpp"
#include "colour.hpp"

namespace pardel::cli {

/// The property of a triangle that sets its colour.
enum class ColourBy : std::uint8_t {
  quality,  ///< the smallest angle
  size,     ///< the longest edge
  region,   ///< the attribute of the region
  tile,     ///< the tile (cell of the lattice) of `pardel mesh`; neighbouring tiles have different colours
  phase,    ///< tiles that are refined at the same time have the same colour
  thread,   ///< one colour per thread; the first thread that worked on the tile counts
};

struct Legend {
  std::string title;  ///< empty: there is no legend
  std::vector<Colour> colours;
  std::vector<std::string> labels;  ///< one per colour; for a scale one more: the limits of the bands
  [[nodiscard]] bool is_scale() const { return labels.size() == colours.size() + 1; }
};

struct Colouring {
  std::vector<Colour> palette;
  std::vector<std::uint16_t> colour_of;  ///< per triangle, an index into the palette
  Legend legend;
};

/// `report`: the report of the run that made the mesh, for tile, phase and thread. Errors: those of tile_hues().
[[nodiscard]] Result<Colouring> colouring(const Mesh& mesh, ColourBy by, const std::filesystem::path& report);

}  // namespace pardel::cli
