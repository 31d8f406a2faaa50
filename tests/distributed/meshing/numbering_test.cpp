// Ranges of vertices with consecutive numbers.
#include "../../../distributed/meshing/numbering.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace pardel::engine {
namespace {

/// The vertices 3, 4, 10, 11, 12 and 20 have the numbers 100, 101, 7, 8, 9 and 50.
VertexNumbers sample() {
  VertexNumbers numbers;
  numbers.add({10, 13}, 7);
  numbers.add({20, 21}, 50);
  numbers.add({3, 5}, 100);
  numbers.add({15, 15}, 1);
  numbers.settle();
  return numbers;
}

TEST(VertexNumbers, are_those_of_the_range) {
  const VertexNumbers numbers = sample();
  EXPECT_EQ(numbers.of(3), 100U);
  EXPECT_EQ(numbers.of(4), 101U);
  EXPECT_EQ(numbers.of(12), 9U);
  EXPECT_EQ(numbers.of(20), 50U);
  for (const Index without : {0U, 2U, 5U, 9U, 13U, 15U, 19U, 21U}) EXPECT_FALSE(numbers.has(without)) << without;
  for (const Index with : {3U, 4U, 10U, 11U, 12U, 20U}) EXPECT_TRUE(numbers.has(with)) << with;
}

TEST(VertexNumbers, are_visited_in_the_order_of_vertices) {
  const VertexNumbers numbers = sample();
  const auto visited = [&](Index first, Index last) {
    std::vector<std::pair<Index, std::uint64_t>> all;
    numbers.for_each(first, last, [&](Index v, std::uint64_t number) { all.emplace_back(v, number); });
    return all;
  };
  using Expected = std::vector<std::pair<Index, std::uint64_t>>;
  EXPECT_EQ(visited(0, 100), (Expected{{3, 100}, {4, 101}, {10, 7}, {11, 8}, {12, 9}, {20, 50}}));
  EXPECT_EQ(visited(4, 12), (Expected{{4, 101}, {10, 7}, {11, 8}}));
  EXPECT_EQ(visited(13, 20), Expected{});
}

}  // namespace
}  // namespace pardel::engine
