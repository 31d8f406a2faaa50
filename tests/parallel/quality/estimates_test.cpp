#include "../../../parallel/quality/estimates.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "../../../properties/domains/generators/random.hpp"

namespace pardel::engine {
namespace {

TEST(Estimate, is_the_nearest_multiple_of_a_part) {
  EXPECT_EQ(estimate(0), 0);
  EXPECT_EQ(estimate(1.75), 1.75);
  EXPECT_EQ(estimate(3 + 0.4 / parts_of_estimate), 3);
  EXPECT_EQ(estimate(3 + 0.6 / parts_of_estimate), 3 + 1 / parts_of_estimate);
  EXPECT_EQ(estimate(1e300), 2e12);
  EXPECT_EQ(estimate_below(3 + 0.9 / parts_of_estimate), 3);
  EXPECT_EQ(estimate_below(3), 3);
  EXPECT_EQ(estimate_below(0.4 / parts_of_estimate), 0);
}

TEST(Estimate, has_sums_that_do_not_depend_on_the_order) {
  generators::Random random(1);
  std::vector<double> terms;
  for (int i = 0; i < 10'000; ++i) terms.push_back(estimate(static_cast<double>(random.below(1'000'000'007)) / 977));
  const double sum = std::accumulate(terms.begin(), terms.end(), 0.0);
  for (int i = 0; i < 20; ++i) {
    random.shuffle(terms);
    EXPECT_EQ(std::accumulate(terms.begin(), terms.end(), 0.0), sum);
  }
}

}  // namespace
}  // namespace pardel::engine
