// Known files of the formats for which the library has no writer, or writes only one of several variants.
#pragma once

#include <string>

#include "known_file.hpp"

namespace pardel::fuzz {

/// A list of numbers, one per line, as in .area files and files of sizes. In an .area, -1 stands for no bound.
[[nodiscard]] KnownFile any_list(generators::Random& random, bool may_be_negative);
/// An ESRI ASCII grid.
[[nodiscard]] KnownFile any_grid(generators::Random& random);
/// An array of NumPy, `lengths.npy`, with its world file.
[[nodiscard]] KnownFile any_array(generators::Random& random);
/// A mesh in a .msh of version 2.2, as text. The tags of its physical groups are the regions and the markers.
[[nodiscard]] KnownFile any_msh_2(generators::Random& random);
/// A mesh in a .vtu whose arrays are text or base64, inline or appended, plain or compressed by zlib.
[[nodiscard]] KnownFile any_vtu(generators::Random& random);

}  // namespace pardel::fuzz
