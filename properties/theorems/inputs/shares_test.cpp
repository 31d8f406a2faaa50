// Tests that shares count cases, not tags, and that a property fails if it does not keep a promised share.
#include "../framework/shares.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "../framework/property.hpp"

namespace pardel::properties {
namespace {

TEST(Shares, count_each_case_once_however_often_it_is_tagged) {
  const rc::detail::Distribution distribution{
      {{"\"walls\"", "\"walls\"", "\"bend\""}, 30}, {{"\"walls\""}, 20}, {{}, 50}};
  const Shares shares = shares_of(distribution);
  EXPECT_EQ(shares.cases, (std::map<std::string, std::uint64_t>{{"walls", 50}, {"bend", 30}}));
  EXPECT_TRUE(shares.promised.empty());
}

TEST(Shares, are_compared_with_what_was_promised) {
  const auto of = [](int kind_of_case, int others) {
    return shares_of(
        {{{"\"promised 5 two words\"", "\"two words\""}, kind_of_case}, {{"\"promised 5 two words\""}, others}});
  };
  EXPECT_TRUE(broken_promises(of(100, 1900), 2000).empty());
  ASSERT_EQ(broken_promises(of(99, 1901), 2000).size(), 1U);
  EXPECT_EQ(broken_promises(of(99, 1901), 2000)[0],
            "Only 99 of 2000 cases are of the kind \"two words\"; at least 5 % must be.");
  EXPECT_EQ(broken_promises(of(0, 2000), 2000).size(), 1U) << "a kind that never occurs";
  EXPECT_TRUE(broken_promises(of(0, 499), 499).empty()) << "too few cases to judge";
}

TEST(Shares, cannot_be_promised_as_zero) {
  EXPECT_THROW(classify(true, "kind", 0), std::invalid_argument);
  EXPECT_THROW(classify(true, "kind", -1), std::invalid_argument);
}

void a_kind_that_never_occurs(Exhibit& /*exhibit*/) {
  const int number = *rc::gen::inRange(0, 100);
  classify(number < 50, "small", 40);
  classify(number == 100, "large", 0.01);
}

TEST(Shares, that_are_not_kept_fail_the_property) {
  unsetenv("PARDEL_RECORDS");  // the catalogue has no row for this property
  const Statement statement{"a statement", "a source"};
  // Shares are judged from 500 cases on; under sanitizers RC_PARAMS asks for fewer.
  const char* const given = std::getenv("RC_PARAMS");
  const std::string parameters = given == nullptr ? "" : given;
  setenv("RC_PARAMS", "max_success=1000", 1);
  EXPECT_NONFATAL_FAILURE(check_property(statement, &a_kind_that_never_occurs), "are of the kind \"large\"");
  setenv("RC_PARAMS", parameters.c_str(), 1);
}

}  // namespace
}  // namespace pardel::properties
