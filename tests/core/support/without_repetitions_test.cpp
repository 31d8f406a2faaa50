// The two ways to sort values without repetitions agree.
#include "../../../core/support/without_repetitions.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pardel {
namespace {

TEST(SortWithoutRepetitions, knows_two_ways) {
  std::mt19937 random(1);
  for (unsigned end = 1; end <= 60; ++end)
    for (unsigned count : {0U, 1U, end / 2, 5 * end}) {
      std::vector<unsigned> values(count);
      for (unsigned& value : values) value = static_cast<unsigned>(random() % end);
      std::vector<unsigned> below = values;
      sort_without_repetitions(values);
      sort_without_repetitions(below, end);
      EXPECT_EQ(below, values);
    }
}

TEST(SortWithoutRepetitions, leaves_the_first_and_the_last_of_all_values) {
  std::vector<unsigned> values{3, 0, 3, 0};
  sort_without_repetitions(values, 4U);
  EXPECT_EQ(values, (std::vector<unsigned>{0, 3}));
}

}  // namespace
}  // namespace pardel
