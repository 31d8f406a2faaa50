// The arguments of `pardel-mpi mesh`.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "../cli/goal_options.hpp"
#include "../cli/mesher_options.hpp"
#include "../core/ranks.hpp"
#include "../core/result.hpp"
#include "../parallel/options.hpp"
#include "problem.hpp"

namespace pardel::mpi {

/// How the ranks read the input.
enum class Reading : std::uint8_t { automatic, whole, parts };

struct MeshArguments {
  std::filesystem::path input;
  Reading reading = Reading::automatic;
  std::vector<std::filesystem::path> outputs;
  cli::GoalOptions goal;
  Options options{.placement = Placement::automatic};  // the interior is refined
  std::vector<Index> cells;
  cli::MesherArguments mesher;
  int threads = 0, pieces = 0;  ///< pieces: 0 for one per rank
  std::optional<double> max_memory_gib;
  bool repair = false;
  std::optional<double> snap;
  bool check = false;
  std::filesystem::path json;
  bool msh_ascii = false, quiet = false;

  [[nodiscard]] HowToRead how_to_read() const {
    return {options.threads, repair, snap, repair ? cli::CrossingPolygons::repaired : cli::CrossingPolygons::refused,
            options.kept_markers};
  }
};

/// Adds the arguments and the text after the options.
void add_mesh_options(CLI::App& app, MeshArguments& arguments);

/// True if no rank needs the whole domain.
[[nodiscard]] bool may_divide(const MeshArguments& arguments);

/// The first fault of the arguments; completes the options.
[[nodiscard]] Status check_arguments(MeshArguments& arguments, const Ranks& ranks);

}  // namespace pardel::mpi
