// Whether a mesh has room: numbers for its triangles, memory for all of it.
#pragma once

#include <cstdint>

#include "../../core/result.hpp"
#include "../options.hpp"

namespace pardel::engine {

/// Better no mesh at once than none after an hour: `resources` where one of at least `needed` triangles cannot fit.
[[nodiscard]] Status check_size(double needed, const Options& options);

/// Whether a mesh of so many vertices takes more memory at its peak than options.max_memory.
[[nodiscard]] bool outgrows_memory(std::uint64_t vertices, const Options& options);

[[nodiscard]] Error too_many_triangles();
[[nodiscard]] Error too_much_memory(const Options& options);

}  // namespace pardel::engine
