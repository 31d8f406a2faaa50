// pardel-mpi check: checks a mesh in pieces where they lie.
#pragma once

#include "../cli/command.hpp"
#include "job.hpp"

namespace pardel::mpi {

[[nodiscard]] cli::Command add_check(CLI::App& program, Job& job);

}  // namespace pardel::mpi
