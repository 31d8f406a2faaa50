// What a pass leaves for a later one is told by keys, which are coarser than lengths: they may call for a look at a
// triangle in vain, but never pass one over that is due.
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

TEST(Deferral, is_seen_in_the_keys_only_where_it_applies) {
  Random random(1);
  int seen = 0;
  for (int round = 0; round < 100'000; ++round) {
    const Assessment a = random_assessment(random);
    Deferral later;
    if (random.below(2) == 0) later.longest_squared = a.longest_squared * random.uniform(0.5, 2);
    if (random.below(2) == 0) later.last_key = a.key - 1 + static_cast<unsigned>(random.below(3));
    if (!later.applied_to(Deferred({EdgeRef(0, 0), 0}, a))) continue;
    ++seen;
    ASSERT_TRUE(later.applies_to(a, Measure{})) << a.longest_squared << ' ' << later.longest_squared;
  }
  EXPECT_GT(seen, 20'000);
}

TEST(Deferral, is_seen_in_the_keys_where_lengths_differ_by_a_quarter) {
  Random random(2);
  for (int round = 0; round < 10'000; ++round) {
    const Assessment a = random_assessment(random);
    EXPECT_TRUE((Deferral{.longest_squared = 1.25 * a.longest_squared}.applied_to(Deferred({EdgeRef(0, 0), 0}, a))));
    EXPECT_TRUE((Deferral{.last_key = a.key - 1}.applied_to(Deferred({EdgeRef(0, 0), 0}, a))));
  }
}

/// The last pass of all leaves nothing.
TEST(Deferral, without_bounds_applies_to_nothing) {
  Random random(3);
  for (int round = 0; round < 10'000; ++round) {
    const Assessment a = random_assessment(random);
    EXPECT_FALSE(Deferral{}.applied_to(Deferred({EdgeRef(0, 0), 0}, a)));
    EXPECT_FALSE(Deferral{}.applies_to(a, Measure{}));
  }
}

}  // namespace
}  // namespace pardel::engine
