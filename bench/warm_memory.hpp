// Makes the host of a virtual machine provide memory before a measured run starts.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../cli/memory.hpp"
#include "run_in_child.hpp"

namespace pardel::bench {

/// Writes and frees fresh memory. Returns false if there is not enough.
inline bool touch_memory(std::size_t size) {
  constexpr std::size_t page = 4096;
  void* block = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (block == MAP_FAILED) return false;
  (void)madvise(block, size, MADV_HUGEPAGE);
  for (std::size_t i = 0; i < size; i += page) static_cast<volatile char*>(block)[i] = 1;
  munmap(block, size);
  return true;
}

/// The host of a virtual machine may provide memory only when it is first written, and take it back some seconds after
/// it was freed. The first run that writes the memory waits for it, the next run does not, so times vary by chance. In
/// a child process this function writes and frees `known_bytes` bytes (the memory that the measured run takes; 0 if
/// unknown), but at least 1 GiB and at most half of the available memory.
inline void warm_memory(std::uint64_t known_bytes) {
  constexpr std::uint64_t least = std::uint64_t{1} << 30U;
  const std::uint64_t available = cli::available_memory();
  const std::uint64_t bytes = std::max(least, known_bytes);
  const auto size = static_cast<std::size_t>(available == 0 ? bytes : std::min(bytes, available / 2));
  (void)run_in_child<bool>([size] { return touch_memory(size); });
}

}  // namespace pardel::bench
