// The arguments of `pardel mesh`.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "../core/result.hpp"
#include "../parallel/options.hpp"
#include "goal_options.hpp"
#include "mesh_format_options.hpp"
#include "mesher_options.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

struct MeshArguments {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
  GoalOptions goal;
  Options options{.placement = Placement::automatic, .interior = Interior::automatic};
  int threads = 0;  ///< 0: all cores
  std::vector<Index> cells;
  std::optional<double> max_memory_gib;
  bool refine = false;
  bool repair = false;
  std::optional<double> snap;
  bool check = false;
  bool paranoid = false;
  MesherArguments mesher;
  MeshFormatOptions format;
  bool drop_unused = false;
  std::filesystem::path json;
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
};

/// Adds the options that say how the mesher works. `cells`: the columns and rows, if they are given.
void add_ways_to_work(CLI::App& app, Options& options, std::vector<Index>& cells);
/// Takes over the columns and rows. Error: `usage` if the decomposition has none.
[[nodiscard]] Status set_cells(const std::vector<Index>& cells, Options& options);

// Options that both programs have.
CLI::Option* add_keep_option(CLI::App& app, Options& options);
CLI::Option* add_min_edge_option(CLI::App& app, Options& options);
CLI::Option* add_memory_option(CLI::App& app, std::optional<double>& gib);
/// Adds --repair, which is returned, and --snap.
CLI::Option* add_repair_options(CLI::App& app, bool& repair, std::optional<double>& snap);
CLI::Option* add_check_option(CLI::App& app, bool& check);
CLI::Option* add_report_option(CLI::App& app, std::filesystem::path& json);
/// In bytes. `otherwise`: the limit without the option.
[[nodiscard]] std::uint64_t memory_limit(std::optional<double> gib, std::uint64_t otherwise);

/// Refuses --interior fill where no triangle would be laid.
[[nodiscard]] Status check_interior(Interior interior, const GoalOptions& goal);

/// Adds the options of the command, and its help.
void add_mesh_options(CLI::App& app, MeshArguments& arguments);

/// Sets the options whose values depend on several arguments, and the number of threads of the process.
[[nodiscard]] Status complete_options(MeshArguments& arguments);

/// The meshes and the report.
[[nodiscard]] std::vector<std::filesystem::path> all_outputs(const MeshArguments& arguments);

/// Checks that all files can be written, before the work starts.
[[nodiscard]] Status check_outputs(const MeshArguments& arguments);

}  // namespace pardel::cli
