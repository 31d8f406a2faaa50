// The options that set the format of a mesh that is written.
#pragma once

#include <CLI/App.hpp>

#include "choice.hpp"
#include "marker_value.hpp"
#include "mesh_format.hpp"
#include "names.hpp"

namespace pardel::cli {

inline void add_mesh_format_options(CLI::App& app, MeshFormatOptions& format) {
  app.add_flag("--msh-ascii", format.msh_ascii, "Write .msh as text (default: binary)");
  app.add_option("--format", format.of_stream,
                 "Format of the output - (standard output): msh, off, svg, vtu, vtk,\n2dm, gr3 or inp")
      ->transform(choice(stream_format_names))
      ->type_name("FORMAT");
  app.add_option("--order", format.order,
                 "Order of the elements, 1 (default) or 2: triangles of six nodes, lines of three, in\n"
                 ".node and .ele, .msh and .vtu")
      ->check(CLI::IsMember({1, 2}).description(""))
      ->type_name("N");
  app.add_option("--open-boundary", format.open_boundaries,
                 "In .gr3 and .14: edges of the boundary with these markers are open; the others are land")
      ->delimiter(',')
      ->check(marker_value())
      ->type_name("MARKER[,MARKER]");
}

/// An option of `mesh` and `convert`, and a switch of `triangle`.
inline void add_drop_option(CLI::App& app, bool& drop_unused) {
  app.add_flag("-j,--drop-unused", drop_unused, "Leave out the vertices that are in no triangle");
}

}  // namespace pardel::cli
