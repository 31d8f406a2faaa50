// The entry point that libFuzzer calls.
#include <cstddef>
#include <cstdint>

#include "fuzz_one.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return pardel::fuzz::fuzz_one({data, size});
}
