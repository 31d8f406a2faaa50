// Deferral by keys. Keys are coarser than lengths: the quick test may miss a triangle that can be deferred, but it
// never defers one that is due.
#include "../../../parallel/refinement/deferral.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

Assessment random_assessment(Random& random) {
  const double shortest = std::exp2(random.uniform(-20, 20)), longest = shortest * std::exp2(random.uniform(0, 4));
  return {Assessment::Need::split_triangle, 0, BucketQueue::key(shortest), longest, /*left_alone=*/false};
}

TEST(Deferral, by_keys_implies_deferral_by_the_exact_rule) {
  Random random(1);
  int deferred = 0;
  for (int round = 0; round < 100'000; ++round) {
    const Assessment a = random_assessment(random);
    Deferral later;
    if (random.below(2) == 0) later.longest_squared = a.longest_squared * random.uniform(0.5, 2);
    if (random.below(2) == 0) later.last_key = a.key - 1 + static_cast<unsigned>(random.below(3));
    if (!later.defers_by_keys(Deferred({EdgeRef(0, 0), 0}, a))) continue;
    ++deferred;
    ASSERT_TRUE(later.defers(a, Measure{})) << a.longest_squared << ' ' << later.longest_squared;
  }
  EXPECT_GT(deferred, 20'000);
}

TEST(Deferral, by_keys_holds_where_squared_lengths_differ_by_a_quarter) {
  Random random(2);
  for (int round = 0; round < 10'000; ++round) {
    const Assessment a = random_assessment(random);
    EXPECT_TRUE(
        (Deferral{.longest_squared = 1.25 * a.longest_squared}.defers_by_keys(Deferred({EdgeRef(0, 0), 0}, a))));
    EXPECT_TRUE((Deferral{.last_key = a.key - 1}.defers_by_keys(Deferred({EdgeRef(0, 0), 0}, a))));
  }
}

/// The last pass defers nothing.
TEST(Deferral, without_bounds_defers_nothing) {
  Random random(3);
  for (int round = 0; round < 10'000; ++round) {
    const Assessment a = random_assessment(random);
    EXPECT_FALSE(Deferral{}.defers_by_keys(Deferred({EdgeRef(0, 0), 0}, a)));
    EXPECT_FALSE(Deferral{}.defers(a, Measure{}));
  }
}

}  // namespace
}  // namespace pardel::engine
