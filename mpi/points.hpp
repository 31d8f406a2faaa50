// Inputs that have only points, and errors about them.
#pragma once

#include <filesystem>

#include "../core/formats.hpp"
#include "../core/result.hpp"
#include "job.hpp"

namespace pardel::mpi {

/// Collective. The error that a command ends with, if `error` was found in the points of a file: an invalid input is
/// read again, to list its problems as 'pardel mesh' does (equal points are not listed if a coordinate cannot be used).
/// Other errors end the job.
[[nodiscard]] Error fault_of_points(const Error& error, const std::filesystem::path& file, int threads, Job& job);

}  // namespace pardel::mpi
