// Array: elements keep their values while it grows and shrinks across the size from which a block has its own memory
// mapping, and all memory is given back.
#include "../../core/array.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <vector>

namespace pardel {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;

/// 0, 1, 2, ... as 64-bit numbers.
std::vector<std::uint64_t> numbers(std::size_t n) {
  std::vector<std::uint64_t> values(n);
  std::iota(values.begin(), values.end(), std::uint64_t{0});
  return values;
}

bool counts_up(const Array<std::uint64_t>& array) {
  for (std::size_t i = 0; i < array.size(); ++i)
    if (array[i] != i) return false;
  return true;
}

/// A number of /proc/self/statm, in bytes.
std::size_t memory_of_process(std::size_t place) {
  std::ifstream file("/proc/self/statm");
  std::size_t pages = 0;
  for (std::size_t k = 0; k <= place; ++k) file >> pages;
  return pages * 4096;
}
std::size_t address_space() { return memory_of_process(0); }
std::size_t resident_memory() { return memory_of_process(1); }

TEST(Array, of_zeroes_contains_zeroes_that_take_no_memory_before_they_are_written) {
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, megabyte / 8 - 1, megabyte}) {
    auto array = Array<std::uint64_t>::zeroes(n);
    ASSERT_EQ(array.size(), n);
    for (const std::uint64_t value : array) ASSERT_EQ(value, 0U);
    array.push_back(5);
    EXPECT_EQ(array.back(), 5U);
  }
  const std::size_t before = resident_memory();
  auto array = Array<std::uint64_t>::zeroes(32 * megabyte);
  array[0] = 1;
  EXPECT_LT(resident_memory(), before + 16 * megabyte) << "of 256 MB";
  EXPECT_THROW((void)Array<std::uint64_t>::zeroes(SIZE_MAX / 4), std::bad_alloc);
}

TEST(Array, keeps_its_elements_while_it_grows_element_by_element) {
  Array<std::uint64_t> array;
  for (std::uint64_t i = 0; i < megabyte; ++i) {
    array.push_back(i);
    ASSERT_EQ(array.size(), i + 1);
    ASSERT_EQ(array.back(), i);
  }
  EXPECT_TRUE(counts_up(array)) << "8 MB; the block gets its own mapping at 1 MB";
}

TEST(Array, keeps_its_elements_at_every_step_of_size) {
  const std::size_t limit = megabyte / sizeof(std::uint64_t);  // from here on a block has its own mapping
  const std::array sizes{std::size_t{1}, limit - 1, limit, limit + 1, 2 * limit, 2 * limit + 1, 9 * limit};
  for (const std::size_t before : sizes)
    for (const std::size_t after : sizes) {
      Array<std::uint64_t> array{std::span<const std::uint64_t>(numbers(before))};
      array.reserve(after);
      EXPECT_EQ(array.size(), before) << "reserving adds no element";
      EXPECT_TRUE(counts_up(array)) << before << " to " << after;
      array.resize(after, 7);
      ASSERT_EQ(array.size(), after);
      for (std::size_t i = before; i < after; ++i) ASSERT_EQ(array[i], 7u) << before << " to " << after;
      array.resize(std::min(before, after));
      array.shrink_to_fit();
      EXPECT_TRUE(counts_up(array)) << before << " to " << after;
      array.resize_uninitialised(after);
      ASSERT_EQ(array.size(), after);
      array.resize(std::min(before, after));
      EXPECT_TRUE(counts_up(array)) << before << " to " << after;
    }
}

TEST(Array, may_append_its_own_elements) {
  Array<std::uint64_t> array(1, 5);
  for (int i = 0; i < 1000; ++i) array.push_back(array[0]);
  array.resize(5000, array.back());
  EXPECT_EQ(array.size(), 5000u);
  for (const std::uint64_t value : array) ASSERT_EQ(value, 5u);
}

TEST(Array, moves_no_element_up_to_the_reserved_size) {
  for (const std::size_t n : {std::size_t{100}, std::size_t{1'000'000}}) {
    Array<std::uint64_t> array;
    array.reserve(n);
    const std::uint64_t* const place = array.data();
    for (const std::uint64_t value : numbers(n / 2)) array.push_back(value);
    array.append(std::span<const std::uint64_t>(numbers(n - n / 2)));
    array.reserve(n / 3);
    EXPECT_EQ(array.data(), place) << n;
    EXPECT_EQ(array.size(), n);
  }
}

TEST(Array, grows_in_few_steps) {
  Array<std::uint64_t> array;
  const std::uint64_t* place = nullptr;
  int moves = 0;
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    array.push_back(i);
    if (array.data() != place) ++moves;
    place = array.data();
  }
  EXPECT_LE(moves, 30) << "each step makes the capacity half as large again";
}

TEST(Array, gives_all_its_memory_back) {
  const auto use = [] {
    Array<std::uint64_t> array;
    for (const std::size_t megabytes : {1, 3, 64, 2, 40}) {
      array.resize_uninitialised(megabytes * megabyte / sizeof(std::uint64_t));
      array.shrink_to_fit();
    }
    Array<std::uint64_t> copy = array, other;
    other = std::move(copy);
    other.clear();
    other.shrink_to_fit();
    EXPECT_EQ(other.size(), 0u);
  };
  use();  // the memory that the allocator keeps for itself
  const std::size_t before = address_space();
  for (int i = 0; i < 20; ++i) use();
  EXPECT_LE(address_space(), before + 32 * megabyte);
}

TEST(Array, leaves_no_memory_behind_where_it_gets_or_loses_a_mapping_of_its_own) {
  const auto use = [] {
    Array<char> array;
    array.resize_uninitialised(megabyte - 1);
    array.shrink_to_fit();
    array.reserve(megabyte);
    array.resize_uninitialised(megabyte / 2);
    array.shrink_to_fit();
  };
  use();
  const std::size_t before = address_space();
  for (int i = 0; i < 1000; ++i) use();
  EXPECT_LE(address_space(), before + 500 * megabyte) << "AddressSanitizer keeps the last 256 MB";
}

TEST(Array, returns_the_memory_behind_its_end) {
  Array<std::uint64_t> array;
  array.resize(64 * megabyte / sizeof(std::uint64_t));
  const std::size_t large = address_space();
  array.resize(4 * megabyte / sizeof(std::uint64_t));
  array.shrink_to_fit();
  EXPECT_LE(address_space(), large - 56 * megabyte);
  array.shrink_to_fit();
  EXPECT_EQ(array.size(), 4 * megabyte / sizeof(std::uint64_t)) << "shrinking twice changes nothing";
}

TEST(Array, refuses_a_size_that_no_memory_has) {
  Array<std::uint64_t> array(3, 1);
  EXPECT_THROW(array.reserve(SIZE_MAX / 4), std::bad_alloc);
  EXPECT_THROW(array.reserve(SIZE_MAX / sizeof(std::uint64_t)), std::bad_alloc);
  EXPECT_EQ(array, Array<std::uint64_t>(3, 1)) << "and keeps its elements";
}

TEST(Array, hands_its_bytes_to_an_array_of_another_type) {
  Array<std::int64_t> negative(3, -1);
  const void* const place = negative.data();
  const auto bits = Array<std::uint64_t>::recast(std::move(negative));
  EXPECT_EQ(bits, Array<std::uint64_t>(3, ~std::uint64_t{0}));
  EXPECT_EQ(static_cast<const void*>(bits.data()), place);
  EXPECT_TRUE(negative.empty());
  negative.push_back(7);
  EXPECT_EQ(negative, Array<std::int64_t>(1, 7)) << "the other array can be used again";
}

TEST(Array, that_handed_its_bytes_on_is_empty_and_can_grow_again) {
  Array<std::int64_t> array(3, -1);
  const auto bits = Array<std::uint64_t>::recast(std::move(array));
  EXPECT_TRUE(array.empty());  // NOLINT(bugprone-use-after-move): recast() leaves an empty array
  array.push_back(5);
  EXPECT_EQ(array, Array<std::int64_t>(1, 5));
  EXPECT_EQ(bits.size(), 3U);
}

TEST(Array, equals_arrays_of_the_same_elements_only) {
  const Array<int> one(2, 1);
  EXPECT_TRUE(one == Array<int>(2, 1));
  EXPECT_FALSE(one == Array<int>(3, 1));
  EXPECT_FALSE(one == Array<int>(1, 1));
  Array<int> other = one;
  other.back() = 2;
  EXPECT_FALSE(one == other);
  other.pop_back();
  other.push_back(1);
  EXPECT_TRUE(one == other);
}

}  // namespace
}  // namespace pardel
