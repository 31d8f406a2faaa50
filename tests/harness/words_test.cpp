#include "../../cli/harness/words.hpp"

#include <gtest/gtest.h>

namespace pardel::harness {
namespace {

using Words = std::vector<std::string>;

Words split(std::string_view line) {
  const Result<Words> words = split_words(line);
  return words ? *words : Words{"error"};
}

TEST(Words, EndAtBlanks) {
  EXPECT_EQ(split("  mesher\t{poly} -o  {out} "), (Words{"mesher", "{poly}", "-o", "{out}"}));
}

TEST(Words, KeepTheirBlanksInQuotationMarks) {
  EXPECT_EQ(split(R"(sh -c 'a "b" \c' "d 'e' \"f\" \\ \g" h" i"j)"),
            (Words{"sh", "-c", R"(a "b" \c)", R"(d 'e' "f" \ \g)", "h ij"}));
}

TEST(Words, KeepWhatFollowsABackslash) { EXPECT_EQ(split(R"(my\ mesher \'a\\)"), (Words{"my mesher", R"('a\)"})); }

TEST(Words, MayBeEmpty) { EXPECT_EQ(split(R"(a '' "")"), (Words{"a", "", ""})); }

TEST(Words, OfAnEmptyLineAreNone) { EXPECT_EQ(split(" "), Words{}); }

TEST(Words, AreRefusedWithAnOpenQuotationMarkOrALastBackslash) {
  for (const char* line : {"a 'b", "a \"b", "a\\"}) EXPECT_FALSE(split_words(line).ok()) << line;
}

TEST(Replaced, ReplacesEveryOccurrenceOnce) {
  EXPECT_EQ(replaced("{a}{a}b", "{a}", "{a}{a}"), "{a}{a}{a}{a}b");
  EXPECT_EQ(replaced("none", "{a}", "b"), "none");
}

}  // namespace
}  // namespace pardel::harness
