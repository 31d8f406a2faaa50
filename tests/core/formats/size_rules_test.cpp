#include <gtest/gtest.h>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "broken_text.hpp"

namespace pardel {
namespace {

TEST(SizeRules, are_points_markers_and_regions_one_per_line) {
  const TemporaryFolder folder;
  const auto rules =
      read_size_rules(folder.write("a", "# the shore\nmarker -3 0.5\n\npoint 1 -2e3 4 # a well\nregion 2.5 8\n"));
  ASSERT_TRUE(rules.ok()) << rules.error().message;
  ASSERT_EQ(rules->markers.size(), 1U);
  EXPECT_EQ(rules->markers[0].marker, -3);
  EXPECT_EQ(rules->markers[0].length, 0.5);
  EXPECT_EQ(rules->markers[0].line, 2U);
  ASSERT_EQ(rules->points.size(), 1U);
  EXPECT_EQ(rules->points[0].place, (Point{1, -2000}));
  EXPECT_EQ(rules->points[0].length, 4);
  ASSERT_EQ(rules->regions.size(), 1U);
  EXPECT_EQ(rules->regions[0].attribute, 2.5);
  EXPECT_EQ(rules->regions[0].length, 8);
  EXPECT_EQ(rules->regions[0].line, 5U);
}

TEST(SizeRules, that_cannot_be_read_are_named_with_their_line) {
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& text) {
    return message_of(read_size_rules(folder.write("a", text)), folder);
  };
  EXPECT_EQ(failure("marker 1 2\nedge 1 2\n"), "a:2: expected 'point', 'marker' or 'region', found \"edge\"");
  EXPECT_EQ(failure("marker 1 0\n"), "a:1: expected a length greater than 0, found 0");
  EXPECT_EQ(failure("marker 1.5 1\n"), "a:1: expected a marker, a whole number, found \"1.5\"");
  EXPECT_EQ(failure("point 1 1\n"), "a:1: expected a length, found the end of the line");
  EXPECT_EQ(failure("point 1 1 1 1\n"), "a:1: expected the end of the line, found \"1\"");
  EXPECT_EQ(failure("region x 1\n"), "a:1: expected the attribute of a region, found \"x\"");
  EXPECT_EQ(failure("# nothing\n"), "a:2: expected a rule: 'point X Y LENGTH', 'marker M LENGTH' or 'region R LENGTH'");
}

}  // namespace
}  // namespace pardel
