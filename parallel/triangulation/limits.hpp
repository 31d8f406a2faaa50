// The limits on the size of a mesh: the number of triangle indices, and the memory.
#pragma once

#include <cstdint>

#include "../../core/result.hpp"
#include "../options.hpp"

namespace pardel::engine {

/// Fails with `resources` if a mesh of at least `needed` triangles cannot fit. The caller then gets the error at once,
/// not after an hour of refinement.
[[nodiscard]] Status check_size(double needed, const Options& options);

/// True if a mesh with this number of vertices takes more memory, at its peak, than options.max_memory.
[[nodiscard]] bool outgrows_memory(std::uint64_t vertices, const Options& options);

[[nodiscard]] Error too_many_triangles();
[[nodiscard]] Error too_much_memory(const Options& options);

}  // namespace pardel::engine
