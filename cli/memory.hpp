// The memory that is left for this process.
#pragma once

#include <cstdint>

namespace pardel::cli {

/// In bytes: the least of the memory that the system has available, that the control group allows and that RLIMIT_AS
/// allows; 0 where none of them is known.
[[nodiscard]] std::uint64_t available_memory();

}  // namespace pardel::cli
