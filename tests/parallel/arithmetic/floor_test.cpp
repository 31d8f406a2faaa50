#include "../../../parallel/arithmetic/floor.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

TEST(FloorAt, a_place_is_a_part_of_its_larger_coordinate) {
  const Floor floor(0);
  EXPECT_EQ(floor.at({3, -0x1p10}), 0x1p-32);
  EXPECT_EQ(floor.at({-0x1p10, 3}), 0x1p-32);
  EXPECT_EQ(floor.squared_at({0x1p10, 0x1p10}), 0x1p-64);
  EXPECT_EQ(floor.at({0, -0x1p200}), 0x1p158);
}

TEST(FloorAt, the_origin_is_the_least_one) {
  const Floor floor(0);
  EXPECT_EQ(floor.least(), 0x1p-129);
  EXPECT_EQ(floor.at({0, 0}), 0x1p-129);
  EXPECT_EQ(floor.at({0x1p-87, 0}), 0x1p-129);
  EXPECT_EQ(floor.at({0x1p-86, 0}), 0x1p-128);
  EXPECT_GT(floor.squared_at({0, 0}), 0);
}

TEST(FloorAt, no_place_is_below_the_length_that_is_asked_for) {
  const Floor floor(0.5);
  EXPECT_EQ(floor.least(), 0.5);
  EXPECT_EQ(floor.at({1, 1}), 0.5);
  EXPECT_EQ(floor.at({0x1p50, 0}), 0x1p8);
  EXPECT_EQ(Floor(1e-300).at({0, 0}), 0x1p-129);
}

TEST(FloorAt, the_higher_end_is_that_of_an_edge) {
  const Floor floor(0);
  EXPECT_EQ(floor.along({1, 0}, {0, -4}), 0x1p-40);
  EXPECT_EQ(floor.along({0, -4}, {1, 0}), 0x1p-40);
}

}  // namespace
}  // namespace pardel::engine
