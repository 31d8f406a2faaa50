// pardel-mpi triangulate: the Delaunay triangulation of points, made in several processes, in pieces.
#pragma once

#include "../cli/command.hpp"
#include "job.hpp"

namespace pardel::mpi {

[[nodiscard]] cli::Command add_triangulate(CLI::App& program, Job& job);

}  // namespace pardel::mpi
