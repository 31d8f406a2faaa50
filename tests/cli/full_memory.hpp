// Lets a test use up the memory.
#pragma once

namespace pardel::testing {

/// While an object of this class exists, its thread cannot allocate memory: operator new throws std::bad_alloc.
class FullMemory {
 public:
  FullMemory();
  ~FullMemory();
  FullMemory(const FullMemory&) = delete;
  FullMemory& operator=(const FullMemory&) = delete;
};

}  // namespace pardel::testing
