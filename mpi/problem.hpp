// The domain and the goal of a command.
#pragma once

#include <filesystem>
#include <span>

#include "../cli/goal_options.hpp"
#include "../core/goal.hpp"
#include "../core/ranks.hpp"
#include "../core/result.hpp"
#include "../parallel/validate.hpp"

namespace pardel::mpi {

struct Problem {
  ValidPslg domain;
  Goal goal;
};

/// Error: `usage` if there are several ranks and one of the inputs is standard input, which mpirun gives to one rank.
[[nodiscard]] Status check_inputs(std::span<const std::filesystem::path> inputs, const Ranks& ranks);

/// Reads and validates the domain, and the field of sizes if there is one, as every rank does for itself.
[[nodiscard]] Result<Problem> read_problem(const std::filesystem::path& domain, const cli::GoalOptions& goal,
                                           int threads);

}  // namespace pardel::mpi
