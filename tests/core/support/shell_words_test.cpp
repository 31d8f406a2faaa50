#include "../../../core/support/shell_words.hpp"

#include <gtest/gtest.h>

namespace pardel {
namespace {

using Words = std::vector<std::string>;

Words split(std::string_view line) {
  const Result<Words> words = split_words(line);
  return words ? *words : Words{"error"};
}

TEST(SplitWords, splits_at_blanks) {
  EXPECT_EQ(split("  mesher\t{poly} -o  {out} "), (Words{"mesher", "{poly}", "-o", "{out}"}));
}

TEST(SplitWords, keeps_blanks_between_quotation_marks) {
  EXPECT_EQ(split(R"(sh -c 'a "b" \c' "d 'e' \"f\" \\ \g" h" i"j)"),
            (Words{"sh", "-c", R"(a "b" \c)", R"(d 'e' "f" \ \g)", "h ij"}));
}

TEST(SplitWords, keeps_the_character_after_a_backslash) {
  EXPECT_EQ(split(R"(my\ mesher \'a\\)"), (Words{"my mesher", R"('a\)"}));
}

TEST(SplitWords, returns_an_empty_word_for_empty_quotation_marks) {
  EXPECT_EQ(split(R"(a '' "")"), (Words{"a", "", ""}));
}

TEST(SplitWords, returns_no_words_for_an_empty_line) { EXPECT_EQ(split(" "), Words{}); }

TEST(SplitWords, an_open_quotation_mark_and_a_last_backslash_are_errors) {
  for (const char* line : {"a 'b", "a \"b", "a\\"}) EXPECT_FALSE(split_words(line).ok()) << line;
}

TEST(Replaced, replaces_every_occurrence_once) {
  EXPECT_EQ(replaced("{a}{a}b", "{a}", "{a}{a}"), "{a}{a}{a}{a}b");
  EXPECT_EQ(replaced("none", "{a}", "b"), "none");
}

TEST(FilledIn, replaces_placeholders_and_searches_no_value_again) {
  const std::pair<std::string_view, std::string> values[] = {{"{a}", "{b}"}, {"{b}", "2"}};
  EXPECT_EQ(filled_in("-o{a}{b}{c}{a", values), "-o{b}2{c}{a");
  EXPECT_EQ(filled_in("", values), "");
}

}  // namespace
}  // namespace pardel
