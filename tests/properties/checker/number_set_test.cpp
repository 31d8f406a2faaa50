// Sets of numbers against std::set.
#include "../../../properties/checker/model/number_set.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../../../properties/domains/generators/random.hpp"

namespace pardel::checker {
namespace {

constexpr std::uint64_t page = 65'536;  // numbers

/// Numbers in a few runs, which begin at the ends of words and pages and elsewhere.
std::set<std::uint64_t> some_numbers(generators::Random& random) {
  std::set<std::uint64_t> numbers;
  for (std::uint64_t run = 0, runs = random.below(6); run < runs; ++run) {
    const std::uint64_t first = random.below(4) * page + random.below(3) * 64 + random.below(3);
    for (std::uint64_t i = 0, count = random.below(300); i < count; ++i)
      if (random.below(4) != 0) numbers.insert(first + i);
  }
  return numbers;
}

NumberSet set_of(const std::set<std::uint64_t>& numbers) {
  NumberSet set;
  for (const std::uint64_t number : numbers) EXPECT_TRUE(set.insert(number));
  return set;
}

TEST(NumberSet, contains_what_was_inserted_and_tells_what_was_there) {
  generators::Random random(1);
  for (int round = 0; round < 50; ++round) {
    const std::set<std::uint64_t> numbers = some_numbers(random);
    NumberSet set = set_of(numbers);
    for (const std::uint64_t number : numbers) {
      EXPECT_FALSE(set.insert(number));
      EXPECT_TRUE(set.contains(number));
      EXPECT_EQ(set.contains(number + 1), numbers.contains(number + 1));
    }
    EXPECT_FALSE(set.contains(100 * page));
    std::uint64_t missing = 0;
    while (numbers.contains(missing)) ++missing;
    EXPECT_EQ(set.first_missing(), missing);
  }
}

TEST(NumberSet, unites_with_another_set_and_lists_the_common_numbers) {
  generators::Random random(2);
  for (int round = 0; round < 50; ++round) {
    const std::set<std::uint64_t> a = some_numbers(random), b = some_numbers(random);
    NumberSet set = set_of(a);
    std::vector<std::uint64_t> common, expected;
    set.unite(set_of(b), common);
    for (const std::uint64_t number : b)
      if (a.contains(number)) expected.push_back(number);
    EXPECT_EQ(common, expected);
    std::set<std::uint64_t> all = a;
    all.insert(b.begin(), b.end());
    for (std::uint64_t number = 0; number < 5 * page; number += 1 + random.below(9))
      EXPECT_EQ(set.contains(number), all.contains(number)) << number;
  }
}

TEST(NumberSet, is_the_same_after_its_words_have_been_read_from_any_number_on) {
  generators::Random random(3);
  for (int round = 0; round < 50; ++round) {
    const std::set<std::uint64_t> numbers = some_numbers(random);
    const std::uint64_t first = random.below(2 * page), count = random.below(2 * page);
    const NumberSet part(set_of(numbers).words(first, count));
    for (std::uint64_t number = 0; number < 3 * page; number += 1 + random.below(9))
      EXPECT_EQ(part.contains(number), number < count && numbers.contains(first + number)) << number;
  }
}

}  // namespace
}  // namespace pardel::checker
