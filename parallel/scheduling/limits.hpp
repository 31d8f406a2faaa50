// The limits on the size of a mesh: indices for its triangles, and memory for all of it.
#pragma once

#include <cstdint>

#include "../../core/result.hpp"
#include "../options.hpp"

namespace pardel::engine {

/// Fails with `resources` where a mesh of at least `needed` triangles cannot fit. The caller then learns it at once,
/// not after an hour of refinement.
[[nodiscard]] Status check_size(double needed, const Options& options);

/// True where a mesh of so many vertices takes more memory, at its peak, than options.max_memory.
[[nodiscard]] bool outgrows_memory(std::uint64_t vertices, const Options& options);

[[nodiscard]] Error too_many_triangles();
[[nodiscard]] Error too_much_memory(const Options& options);

}  // namespace pardel::engine
