// The memory that is left for this process.
#pragma once

#include <cstdint>

namespace pardel::cli {

/// In bytes: the minimum of the memory that the system has available, the memory that the control group allows, and the
/// memory that RLIMIT_AS allows. 0 if all three are unknown.
[[nodiscard]] std::uint64_t available_memory();

}  // namespace pardel::cli
