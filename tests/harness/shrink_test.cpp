#include "../../cli/harness/shrink.hpp"

#include <gtest/gtest.h>

namespace pardel::harness {
namespace {

Result<bool> has_a_hole(const LatticeDomain& domain) { return !domain.holes.empty(); }

TEST(Shrink, ends_at_a_domain_of_which_no_simpler_one_fails) {
  const LatticeDomain large = make_case({1, Family::nested_holes, 3});
  const Result<Shrunk> small = shrink(large, 100'000, has_a_hole);
  ASSERT_TRUE(small.ok());
  EXPECT_TRUE(small->smallest);
  EXPECT_EQ(small->domain.holes.size(), 1);
  EXPECT_LT(weight(small->domain), weight(large));
  for (const LatticeDomain& simpler : shrinks(small->domain)) EXPECT_FALSE(*has_a_hole(simpler));
}

TEST(Shrink, does_not_exceed_the_number_of_runs) {
  const LatticeDomain large = make_case({1, Family::nested_holes, 3});
  std::size_t runs = 0;
  const Result<Shrunk> small = shrink(large, 2, [&](const LatticeDomain&) {
    ++runs;
    return Result<bool>(false);
  });
  ASSERT_TRUE(small.ok());
  EXPECT_EQ(runs, 2);
  EXPECT_EQ(small->runs, 2);
  EXPECT_FALSE(small->smallest);
  EXPECT_EQ(small->domain, large);
}

TEST(Shrink, returns_the_error_of_a_run) {
  const auto broken = [](const LatticeDomain&) { return Result<bool>(Error{ErrorKind::io, "full"}); };
  EXPECT_FALSE(shrink(make_case({1, Family::cracks, 0}), 10, broken).ok());
}

}  // namespace
}  // namespace pardel::harness
