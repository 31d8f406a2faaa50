// The interval for a median.
#include "../../bench/sign_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace pardel::bench {
namespace {

std::vector<double> first_numbers(std::size_t n) {
  std::vector<double> values(n);
  std::iota(values.rbegin(), values.rend(), 1.0);  // not ascending
  return values;
}

TEST(SignInterval, of_few_values_is_everything) {
  for (std::size_t n = 0; n <= 5; ++n) {
    const Interval all = sign_interval(first_numbers(n), 0.95);
    EXPECT_EQ(all.low, 0);
    EXPECT_TRUE(std::isinf(all.high));
  }
}

/// By the binomial distribution: of 6 throws, none is heads in 1 of 64 cases; of 15, at most 3 in 576 of 32768.
TEST(SignInterval, begins_at_the_value_that_the_binomial_distribution_says) {
  EXPECT_EQ(sign_interval(first_numbers(6), 0.95).low, 1);
  EXPECT_EQ(sign_interval(first_numbers(6), 0.95).high, 6);
  EXPECT_EQ(sign_interval(first_numbers(15), 0.95).low, 4);
  EXPECT_EQ(sign_interval(first_numbers(15), 0.95).high, 12);
  EXPECT_EQ(sign_interval(first_numbers(15), 0.99).low, 3);
}

TEST(SignInterval, contains_the_median_as_often_as_it_says) {
  constexpr int rounds = 4000;
  std::mt19937 random(2004);
  std::exponential_distribution<double> draw;
  int missed = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> values(21);
    for (double& value : values) value = draw(random);
    const Interval interval = sign_interval(values, 0.95);
    if (interval.low > std::log(2) || interval.high < std::log(2)) ++missed;
  }
  // For 21 values, the exact probability is 2.66 %: 106 of 4000, with a standard deviation of 10.
  EXPECT_GT(missed, 60);
  EXPECT_LT(missed, 155);
}

}  // namespace
}  // namespace pardel::bench
