// Makes the system provide memory before it is measured how fast it is used.
#pragma once

#include <sys/mman.h>

#include <cstddef>

namespace pardel::workloads {

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

}  // namespace pardel::workloads
