// The options that set the format of a mesh that is written.
#pragma once

#include <CLI/App.hpp>
#include <optional>

#include "../core/formats.hpp"
#include "choice.hpp"
#include "names.hpp"

namespace pardel::cli {

struct MeshFormatOptions {
  bool msh_ascii = false;
  std::optional<MeshFormat> of_stream;  ///< the format of the output -

  [[nodiscard]] MshEncoding msh() const { return msh_ascii ? MshEncoding::ascii : MshEncoding::binary; }
};

inline void add_mesh_format_options(CLI::App& app, MeshFormatOptions& format) {
  app.add_flag("--msh-ascii", format.msh_ascii, "Write .msh as text (default: binary)");
  app.add_option("--format", format.of_stream, "Format of the output - (standard output): msh, off, svg or vtu")
      ->transform(choice(stream_format_names))
      ->type_name("FORMAT");
}

}  // namespace pardel::cli
