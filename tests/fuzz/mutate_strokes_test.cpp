// The mutator and the cross-over of the fuzz targets work on whole strokes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../../fuzz/mesh_case.hpp"

extern "C" {
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1, const std::uint8_t* data2,
                                      std::size_t size2, std::uint8_t* out, std::size_t max_out_size, unsigned seed);
/// Stands for libFuzzer's own mutator, which these tests do not examine.
std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }
}

namespace pardel::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A header of zeros, and strokes whose bytes are all `first`, `first + 1`, ...
Bytes strokes(std::uint8_t first, std::size_t count) {
  Bytes bytes(header_bytes);
  for (std::size_t i = 0; i < count * stroke_bytes; ++i)
    bytes.push_back(static_cast<std::uint8_t>(first + i / stroke_bytes));
  return bytes;
}

Bytes mutated_by_seed(Bytes bytes, unsigned seed, std::size_t most) {
  const std::size_t size = bytes.size();
  bytes.resize(std::max(most, size));
  bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), size, most, seed));
  return bytes;
}

TEST(MutateStrokes, a_mutation_gives_a_header_and_whole_strokes) {
  constexpr std::size_t most = header_bytes + most_strokes * stroke_bytes;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Bytes after = mutated_by_seed(strokes(50, 4), seed, most);
    ASSERT_GE(after.size(), header_bytes);
    EXPECT_LE(after.size(), most);
    EXPECT_EQ((after.size() - header_bytes) % stroke_bytes, 0U);
  }
}

TEST(MutateStrokes, strokes_are_inserted_removed_and_moved) {
  std::size_t longer = 0, shorter = 0, same_length = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Bytes before = strokes(50, 4), after = mutated_by_seed(before, seed, 400);
    longer += after.size() > before.size();
    shorter += after.size() < before.size();
    same_length += after.size() == before.size() && after != before;
  }
  EXPECT_GT(longer, 50U);
  EXPECT_GT(shorter, 20U);
  EXPECT_GT(same_length, 100U);
}

TEST(MutateStrokes, a_mutation_writes_no_more_than_there_is_space_for) {
  for (unsigned seed = 0; seed < 200; ++seed)
    EXPECT_LE(mutated_by_seed(strokes(50, 4), seed, header_bytes + 33).size(), header_bytes + 33);
}

TEST(MutateStrokes, the_cross_over_draws_strokes_of_both_domains_and_no_others) {
  const Bytes first = strokes(10, 5), second = strokes(100, 5);
  std::size_t mixed = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Bytes child(400);
    child.resize(LLVMFuzzerCustomCrossOver(first.data(), first.size(), second.data(), second.size(), child.data(),
                                           child.size(), seed));
    bool has_first = false, has_second = false;
    for (std::size_t at = header_bytes; at < child.size(); at += stroke_bytes) {
      const std::uint8_t mark = child[at];
      EXPECT_TRUE(std::all_of(child.begin() + static_cast<std::ptrdiff_t>(at),
                              child.begin() + static_cast<std::ptrdiff_t>(at + stroke_bytes),
                              [&](std::uint8_t byte) { return byte == mark; }));
      has_first |= mark >= 10 && mark < 15;
      has_second |= mark >= 100 && mark < 105;
    }
    mixed += has_first && has_second;
  }
  EXPECT_GT(mixed, 100U);
}

}  // namespace
}  // namespace pardel::fuzz
