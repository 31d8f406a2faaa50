// The words that "did you mean" suggests.
#include "../../cli/similar_word.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pardel::cli {
namespace {

TEST(SimilarWord, the_edit_distance_counts_insertions_deletions_and_replacements) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("mesh", "mesh"), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("mseh", "mesh"), 2U);
}

TEST(SimilarWord, is_the_nearest_one_and_none_if_all_are_far) {
  const std::vector<std::string> known = {"mesh", "check", "--max-area", "--max-edge"};
  EXPECT_EQ(similar_word("mseh", known), "mesh");
  EXPECT_EQ(similar_word("--max-aera", known), "--max-area");
  EXPECT_EQ(similar_word("--max-ege", known), "--max-edge");
  EXPECT_EQ(similar_word("fly", known), "");
  EXPECT_EQ(similar_word("", known), "");
}

}  // namespace
}  // namespace pardel::cli
