#include "../../../core/formats/fields.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pardel::files {
namespace {

/// What read_digits() makes of a text: the digits, and their value.
std::pair<std::string, std::int64_t> digits_of(std::string_view text) {
  std::int64_t value = -1;
  const char* const end = read_digits(text.data(), text.data() + text.size(), value);
  return {std::string(text.data(), end), value};
}

TEST(Digits, are_read_up_to_the_first_other_character_and_to_the_end_of_the_text) {
  const std::string digits = "987654321098765432";
  for (std::size_t n = 1; n <= digits.size(); ++n) {
    const std::pair expected(digits.substr(0, n), std::int64_t{std::stoll(digits.substr(0, n))});
    EXPECT_EQ(digits_of(expected.first), expected);
    for (int other = 0; other < 256; ++other) {
      if (other >= '0' && other <= '9') continue;
      const std::string end(1, static_cast<char>(other));
      EXPECT_EQ(digits_of(expected.first + end), expected) << n << " digits, then " << other;
      EXPECT_EQ(digits_of(expected.first + end + "12345678"), expected) << n << " digits, then " << other;
      EXPECT_EQ(digits_of(expected.first + end + "\xff\xff\xff\xff\xff\xff\xff\xff"), expected) << n << ", " << other;
    }
  }
}

TEST(Digits, may_be_zeros) {
  for (std::size_t n = 1; n <= 18; ++n) {
    EXPECT_EQ(digits_of(std::string(n, '0') + " "), std::pair(std::string(n, '0'), std::int64_t{0}));
    EXPECT_EQ(digits_of(std::string(n - 1, '0') + "7"), std::pair(std::string(n - 1, '0') + "7", std::int64_t{7}));
  }
}

TEST(Digits, are_eighteen_at_most) {
  EXPECT_EQ(digits_of("1234567890123456789"),
            std::pair(std::string("123456789012345678"), std::int64_t{123456789012345678}));
}

TEST(Digits, are_none_in_other_texts) {
  for (const std::string text : {"", "-", "-1", "+1", " 1", "x12345678", "/1234567", ":1234567",
                                 "\xb0"
                                 "1234567"}) {
    EXPECT_EQ(digits_of(text), std::pair(std::string(), std::int64_t{0})) << text;
  }
}

TEST(CharacterSet, has_its_characters_only) {
  constexpr CharacterSet set(" #\n");
  for (int code = 0; code < 256; ++code) {
    const char c = static_cast<char>(code);
    EXPECT_EQ(set.has(c), c == ' ' || c == '#' || c == '\n') << code;
  }
}

}  // namespace
}  // namespace pardel::files
