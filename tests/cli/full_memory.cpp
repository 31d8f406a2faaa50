#include "full_memory.hpp"

#include <cstdlib>
#include <new>

namespace {
thread_local bool is_full = false;
}

namespace pardel::testing {

FullMemory::FullMemory() { is_full = true; }
FullMemory::~FullMemory() { is_full = false; }

}  // namespace pardel::testing

void* operator new(std::size_t bytes) {
  void* const block = is_full ? nullptr : std::malloc(bytes);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*bytes*/) noexcept { std::free(block); }
