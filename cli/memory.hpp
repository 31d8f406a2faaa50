// How much memory this process may still take.
#pragma once

#include <cstdint>

namespace pardel::cli {

/// In bytes: the least of what the system has available, what the control group allows and what RLIMIT_AS allows;
/// 0 where nothing is known.
[[nodiscard]] std::uint64_t available_memory();

}  // namespace pardel::cli
