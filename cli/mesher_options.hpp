// The options of `pardel mesh` for a sequential mesher that does the work (off_the_shelf/).
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>

#include "../core/result.hpp"
#include "../off_the_shelf/mesh_with_mesher.hpp"

namespace pardel::cli {

struct MesherArguments {
  std::string name;  ///< a name or a command; empty: pardel works in its own way
  MesherOptions how;
};

void add_mesher_options(CLI::App& app, MesherArguments& arguments);

/// A `usage` error for options that --mesher has no use for. `has_cells`: --cells is given.
[[nodiscard]] Status check_use(const MesherArguments& arguments, const Options& options, bool has_cells);

/// The mesher. Errors: `usage` for a command that cannot be used, `io` for a program that does not exist.
[[nodiscard]] Result<std::unique_ptr<SubdomainMesher>> find_mesher(const std::string& name);

}  // namespace pardel::cli
