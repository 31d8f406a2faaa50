// The memory of this process: how much it uses, and how much is left for it.
#pragma once

#include <chrono>
#include <cstdint>

namespace pardel::cli {

/// In bytes: the minimum of the memory that RLIMIT_AS allows, and of this process's share of what the system has
/// available and of what the control group allows. `sharing`: so many processes share these two; RLIMIT_AS holds for
/// each of them. 0 if all three are unknown.
[[nodiscard]] std::uint64_t available_memory(std::uint64_t sharing = 1);

/// In bytes: the physical memory that this process uses, with the pages of its program and libraries. 0 if unknown.
/// Allocates no memory.
[[nodiscard]] std::uint64_t used_memory();

/// In bytes: the most physical memory that this process has used so far.
[[nodiscard]] std::uint64_t peak_memory();

/// The time after which a process that uses `used` bytes has to look again, so that it does not use many more than
/// `limit` bytes: the time in which it could use up the rest, but at least a millisecond. In a millisecond, processes
/// with two threads were seen to touch up to 5 MiB. Precondition: used <= limit.
[[nodiscard]] std::chrono::microseconds time_to_next_look(std::uint64_t used, std::uint64_t limit);

}  // namespace pardel::cli
