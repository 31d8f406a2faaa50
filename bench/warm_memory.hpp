// Makes the host of a virtual machine provide memory before a measured run starts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../cli/memory.hpp"
#include "run_in_child.hpp"
#include "workloads/touch_memory.hpp"

namespace pardel::bench {

/// The host of a virtual machine may provide memory only when it is first written, and take it back some seconds after
/// it was freed. The first run that writes the memory waits for it, the next run does not, so times vary by chance. In
/// a child process this function writes and frees `known_bytes` bytes (the memory that the measured run takes; 0 if
/// unknown), but at least 1 GiB and at most half of the available memory.
inline void warm_memory(std::uint64_t known_bytes) {
  constexpr std::uint64_t least = std::uint64_t{1} << 30U;
  const std::uint64_t available = cli::available_memory();
  const std::uint64_t bytes = std::max(least, known_bytes);
  const auto size = static_cast<std::size_t>(available == 0 ? bytes : std::min(bytes, available / 2));
  (void)run_in_child<bool>([size] { return workloads::touch_memory(size); });
}

}  // namespace pardel::bench
