#include "array.hpp"

#include <algorithm>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace pardel::detail {

#if defined(MREMAP_MAYMOVE) && defined(MADV_HUGEPAGE)

namespace {

/// The length of a mapping is a multiple of this. The system then aligns the mapping and needs no small pages for it.
constexpr std::size_t huge_page = std::size_t{2} << 20U;
/// A block of this size or more has its own memory mapping.
constexpr std::size_t large = std::size_t{1} << 20U;

std::size_t whole_pages(std::size_t bytes) { return (bytes + huge_page - 1) / huge_page * huge_page; }

void* map(std::size_t bytes) {
  void* block =
      mmap(nullptr, whole_pages(bytes), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (block == MAP_FAILED) return nullptr;
  // Huge pages cause fewer page faults and fewer TLB misses. If the system does not provide them, small pages are used.
  (void)madvise(block, whole_pages(bytes), MADV_HUGEPAGE);
  return block;
}

}  // namespace

void* grow_block(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  if (old_bytes < large && new_bytes < large) return std::realloc(block, new_bytes);
  if (old_bytes >= large && new_bytes >= large) {
    void* grown = mremap(block, whole_pages(old_bytes), whole_pages(new_bytes), MREMAP_MAYMOVE);
    return grown == MAP_FAILED ? nullptr : grown;
  }
  void* grown = new_bytes >= large ? map(new_bytes) : std::malloc(new_bytes);
  if (grown == nullptr) return nullptr;
  if (block != nullptr) std::memcpy(grown, block, std::min(old_bytes, new_bytes));
  free_block(block, old_bytes);
  return grown;
}

void* zero_block(std::size_t bytes) { return bytes >= large ? map(bytes) : std::calloc(bytes, 1); }

void free_block(void* block, std::size_t bytes) {
  if (bytes >= large)
    munmap(block, whole_pages(bytes));
  else
    std::free(block);
}

#else

void* grow_block(void* block, std::size_t, std::size_t new_bytes) { return std::realloc(block, new_bytes); }
void* zero_block(std::size_t bytes) { return std::calloc(bytes, 1); }
void free_block(void* block, std::size_t) { std::free(block); }

#endif

}  // namespace pardel::detail
