// pardel-mpi mesh: makes a mesh in several processes, and writes it in pieces.
#pragma once

#include "../cli/command.hpp"
#include "job.hpp"

namespace pardel::mpi {

[[nodiscard]] cli::Command add_mesh(CLI::App& program, Job& job);

}  // namespace pardel::mpi
