// Memory that a run finds at hand, however long the machine has been idle.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../cli/memory.hpp"
#include "run_in_child.hpp"

namespace pardel::bench {

/// The memory of a virtual machine may be handed out by its host as it is touched, and taken back some seconds after
/// it was freed: whoever touches it first then waits for it, the next one does not. So which run pays is chance. Before
/// a run this touches as much memory as such a run is known to take (0: nothing is known), and a gibibyte at least, in
/// a process of its own, and frees it. At most half of what is available.
inline void warm_memory(std::uint64_t known_bytes) {
  constexpr std::size_t page = 4096;
  constexpr std::uint64_t least = std::uint64_t{1} << 30U;
  const std::uint64_t available = cli::available_memory();
  const std::uint64_t bytes = std::max(least, known_bytes);
  const auto size = static_cast<std::size_t>(available == 0 ? bytes : std::min(bytes, available / 2));
  (void)run_in_child<bool>([size] {
    void* block = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) return false;
    (void)madvise(block, size, MADV_HUGEPAGE);
    for (std::size_t i = 0; i < size; i += page) static_cast<volatile char*>(block)[i] = 1;
    return true;
  });
}

}  // namespace pardel::bench
