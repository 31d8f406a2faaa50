// The domain and the goal of a command.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../cli/goal_options.hpp"
#include "../cli/refusal.hpp"
#include "../core/goal.hpp"
#include "../core/ranks.hpp"
#include "../core/result.hpp"
#include "../parallel/validate.hpp"
#include "job.hpp"

namespace pardel::mpi {

struct Problem {
  ValidPslg domain;
  Goal goal;
  std::vector<std::string> log{};  ///< of the repair, one line per change
  double validate_seconds = 0;     ///< with the repair
};

struct HowToRead {
  int threads = 0;
  bool repair = false;
  std::optional<double> snap{};
  cli::CrossingPolygons in_sources = cli::CrossingPolygons::refused;
  std::vector<int> kept_markers{};  ///< each is that of a segment, or the domain is refused
};

/// Error: `usage` if there are several ranks and one of the inputs is standard input, which mpirun gives to one rank.
[[nodiscard]] Status check_inputs(std::span<const std::filesystem::path> inputs, const Ranks& ranks);

/// Reads and validates or repairs the domain, and reads the field of sizes if there is one, as every rank does for
/// itself.
[[nodiscard]] Result<Problem, cli::Refusal> read_problem(const std::filesystem::path& domain,
                                                         const cli::GoalOptions& goal, const HowToRead& how);

/// Collective. Without a value on all ranks if all have a problem to solve. Otherwise the refusal with which all end:
/// the error of the first rank that failed, with the problems that this rank has found.
[[nodiscard]] std::optional<cli::Refusal> common_refusal(const Result<Problem, cli::Refusal>& problem, Job& job);

}  // namespace pardel::mpi
