// The choices of the user among the forms of the files of meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "../core/formats.hpp"

namespace pardel::cli {

struct MeshFormatOptions {
  bool msh_ascii = false;
  std::optional<MeshFormat> of_stream;  ///< the format of the output -

  int order = 1;
  std::vector<int> open_boundaries;

  [[nodiscard]] MeshFileOptions for_file(const std::filesystem::path& output) const {
    return {.msh = msh_ascii ? MshEncoding::ascii : MshEncoding::binary,
            .format = output == "-" ? of_stream : std::nullopt,
            .elements = order == 2 ? ElementOrder::second : ElementOrder::first,
            .open_boundaries = open_boundaries};
  }
};

}  // namespace pardel::cli
