// The commands whose input is a domain or a mesh.
#pragma once

#include <filesystem>
#include <variant>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "exit_code.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

/// Reads a domain or a mesh. A file without a suffix, such as `-` (standard input), is GeoJSON if it begins with "{",
/// and otherwise what read_pslg_or_mesh() takes it for.
[[nodiscard]] Result<std::variant<Pslg, Mesh>> read_domain_or_mesh(const std::filesystem::path& file);

/// Reads a domain or a mesh, and calls act(pslg) or act(mesh), which returns a Status.
template <class Act>
[[nodiscard]] Result<ExitCode> with_domain_or_mesh(const std::filesystem::path& file, ProgressBar& bar,
                                                   const Act& act) {
  bar.begin("reading " + file.string());
  const Result<std::variant<Pslg, Mesh>> read = read_domain_or_mesh(file);
  if (!read) return read.error();
  if (Status done = std::visit(act, *read); !done) return done.error();
  return ExitCode::done;
}

}  // namespace pardel::cli
