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

// The default of the other forms of new calls this one, but not under AddressSanitizer, which has its own.
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept {
  return is_full ? nullptr : std::malloc(bytes);
}
void* operator new(std::size_t bytes) {
  void* const block = operator new(bytes, std::nothrow);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, const std::nothrow_t& /*tag*/) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*bytes*/) noexcept { std::free(block); }
