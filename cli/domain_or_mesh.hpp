// The commands whose input is a domain or a mesh.
#pragma once

#include <filesystem>
#include <variant>

#include "../core/formats.hpp"
#include "../core/result.hpp"
#include "exit_code.hpp"
#include "progress_bar.hpp"
#include "read_geojson.hpp"

namespace pardel::cli {

/// Reads a domain or a mesh, and calls act(pslg) or act(mesh), which returns a Status.
template <class Act>
[[nodiscard]] Result<ExitCode> with_domain_or_mesh(const std::filesystem::path& file, ProgressBar& bar,
                                                   const Act& act) {
  bar.begin("reading " + file.string());
  if (is_geojson(file)) {
    const Result<Pslg> drawn = read_geojson(file);
    if (!drawn) return drawn.error();
    if (Status done = act(*drawn); !done) return done.error();
    return ExitCode::done;
  }
  const Result<std::variant<Pslg, Mesh>> read = read_pslg_or_mesh(file);
  if (!read) return read.error();
  if (Status done = std::visit(act, *read); !done) return done.error();
  return ExitCode::done;
}

}  // namespace pardel::cli
