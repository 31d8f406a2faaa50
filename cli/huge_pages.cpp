// Replaces the program's operator new: large blocks use huge pages, if the system has them. The system takes back a
// gibibyte of huge pages in milliseconds, and a gibibyte of small pages in a tenth of a second. A process that is
// interrupted ends only when the system has taken back its memory.
#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20U;

void* allocate(std::size_t bytes) {
  if (bytes < huge_page || bytes > SIZE_MAX - huge_page) return std::malloc(bytes);
  const std::size_t whole_pages = (bytes + huge_page - 1) / huge_page * huge_page;
  void* block = std::aligned_alloc(huge_page, whole_pages);
  if (block != nullptr) (void)madvise(block, whole_pages, MADV_HUGEPAGE);
  return block;
}

}  // namespace

void* operator new(std::size_t bytes) {
  void* block = allocate(bytes == 0 ? 1 : bytes);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*bytes*/) noexcept { std::free(block); }
