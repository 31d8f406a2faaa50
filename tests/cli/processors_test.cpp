// The number of processors that a control group grants.
#include "../../cli/processors.hpp"

#include <gtest/gtest.h>

namespace pardel::cli {
namespace {

TEST(ProcessorsGranted, are_the_quota_divided_by_the_period_rounded_up) {
  EXPECT_EQ(processors_granted("200000 100000"), 2);
  EXPECT_EQ(processors_granted("200000 100000\n"), 2);
  EXPECT_EQ(processors_granted("250000 100000"), 3);
  EXPECT_EQ(processors_granted("1000 100000"), 1);
  EXPECT_EQ(processors_granted("50000 25000"), 2);
  EXPECT_EQ(processors_granted("0 100000"), 1);
}

TEST(ProcessorsGranted, are_not_limited_without_a_quota) {
  for (const char* text : {"max 100000", "max", "", "200000", "200000 ", "200000 0", "200000 x", " 2 1"})
    EXPECT_EQ(processors_granted(text), std::nullopt) << text;
}

}  // namespace
}  // namespace pardel::cli
