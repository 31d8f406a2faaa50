// The mutator and the cross-over of strokes (mutate_strokes.cpp) as a custom mutator of AFL++, a library that afl-fuzz
// loads (AFL_CUSTOM_MUTATOR_LIBRARY). AFL++ also changes inputs in its own ways.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../properties/domains/generators/random.hpp"

using pardel::generators::Random;

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);
extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2, std::uint8_t* out,
                                                 std::size_t max_out_size, unsigned seed);

namespace {

struct Mutator {
  Random random;
  std::vector<std::uint8_t> bytes;  ///< the last result, which belongs to the mutator
};

}  // namespace

// The functions of this name and signature are looked up by afl-fuzz (docs/custom_mutators.md of AFL++).
extern "C" {

void* afl_custom_init(void* /*afl*/, unsigned seed) { return new Mutator{Random(seed), {}}; }

void afl_custom_deinit(void* mutator) { delete static_cast<Mutator*>(mutator); }

std::size_t afl_custom_fuzz(void* mutator, const std::uint8_t* input, std::size_t size, std::uint8_t** result,
                            const std::uint8_t* other, std::size_t other_size, std::size_t max_size) {
  auto& [random, bytes] = *static_cast<Mutator*>(mutator);
  const auto seed = static_cast<unsigned>(random.next());
  std::size_t length = 0;
  if (other != nullptr && random.chance(4)) {
    bytes.resize(max_size);
    length = LLVMFuzzerCustomCrossOver(input, size, other, other_size, bytes.data(), max_size, seed);
  } else {
    bytes.assign(input, input + size);
    bytes.resize(max_size);
    length = LLVMFuzzerCustomMutator(bytes.data(), size, max_size, seed);
  }
  *result = bytes.data();
  return length;
}

// The custom mutator leaves some mutations to libFuzzer. AFL++ does such mutations itself: it runs no input of size 0.
std::size_t LLVMFuzzerMutate(std::uint8_t* /*data*/, std::size_t /*size*/, std::size_t /*max_size*/) { return 0; }

}  // extern "C"
