#include "../../../parallel/arithmetic/distance.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

TEST(Distance, is_exact_where_the_sum_of_squares_is_a_square) {
  EXPECT_EQ(distance({1, 2}, {4, 6}), 5);
  EXPECT_EQ(distance({4, 6}, {1, 2}), 5);
  EXPECT_EQ(distance({-7, 3}, {-7, 3}), 0);
}

TEST(Distance, covers_the_range_of_valid_coordinates) {
  EXPECT_EQ(distance({-0x1.8p200, 0}, {0, 0x1p201}), 0x1.4p201);
  EXPECT_EQ(distance({0x1.8p-140, 0}, {0, 0x1p-139}), 0x1.4p-139);
}

}  // namespace
}  // namespace pardel::engine
