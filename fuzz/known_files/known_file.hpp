// Correct files of random small domains, meshes, lists and rasters, and what a reader has to read from them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../../core/raster.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace pardel::fuzz {

using Numbers = std::vector<double>;
/// What the readers of the fuzz targets read.
using Content = std::variant<Pslg, Mesh, Raster, Numbers>;

struct KnownFile {
  std::string bytes;  ///< one file, or several (file_bundle.hpp)
  Content content;    ///< without what the format does not store
  /// Does the format keep the order of triangles and constrained edges? MSH and pieces of a mesh do not.
  bool keeps_order = true;
};

/// A file that the reader of `main_file` reads; the suffix of this name sets the format.
[[nodiscard]] KnownFile any_known_file(generators::Random& random, const std::string& main_file);

/// An input that stands for a known file: the byte 0, with which no file of any format begins, and eight bytes, the
/// seed of its random numbers.
[[nodiscard]] std::string input_for_known_file(std::uint64_t seed);
/// The file for which such an input stands; nothing if the input is a file.
[[nodiscard]] std::optional<KnownFile> known_file_of(std::span<const std::uint8_t> input, const std::string& main_file);

}  // namespace pardel::fuzz
