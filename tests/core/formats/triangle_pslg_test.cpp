// Triangle's .poly and .node as input.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "broken_text.hpp"

namespace pardel {
namespace {

constexpr const char* everything = R"(# A square with a diagonal, one attribute, markers.
4 2 1 1

1 0 0 10.5 3   # first
2 1 0 11.5 0
3 1 1 12.5 -2
4 0 1 13.5 0
# segments
5 1
1 1 2 7
2 2 3 0
3 3 4 -9
4 4 1 7
5 1 3 0
1
1 5 5
2
1 0.75 0.25 4.5 0.01   # attribute and area
2 0.25 0.75 0.5        # one value for both
)";

std::string failure_of(std::string_view text) { return message_of_invalid(parse_poly(text, "f")); }

/// `everything` with the n-th line (from 1) replaced.
std::string with_line(int n, const std::string& line) {
  std::string text = everything;
  std::size_t begin = 0;
  for (int i = 1; i < n; ++i) begin = text.find('\n', begin) + 1;
  return text.replace(begin, text.find('\n', begin) - begin, line);
}

TEST(Poly, has_points_attributes_markers_segments_holes_and_regions) {
  const auto result = parse_poly(everything, "f");
  ASSERT_TRUE(result.ok()) << result.error().message;
  const Pslg& pslg = *result;
  EXPECT_EQ(pslg.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(pslg.attributes_per_point, 1);
  EXPECT_EQ(pslg.point_attributes, (std::vector<double>{10.5, 11.5, 12.5, 13.5}));
  EXPECT_EQ(pslg.point_markers, (std::vector<int>{3, 0, -2, 0}));
  EXPECT_EQ(pslg.segments, (std::vector<Segment>{{0, 1, 7}, {1, 2, 0}, {2, 3, -9}, {3, 0, 7}, {0, 2, 0}}));
  EXPECT_TRUE(pslg.has_segment_markers);
  EXPECT_EQ(pslg.holes, (std::vector<Point>{{5, 5}}));
  EXPECT_EQ(pslg.regions, (std::vector<Region>{{{0.75, 0.25}, 4.5, 0.01}, {{0.25, 0.75}, 0.5, 0.5}}));
}

TEST(Poly, reads_the_same_with_the_line_ends_of_another_system) {
  std::string text = everything;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) text.insert(at, "\r");
  EXPECT_EQ(*parse_poly(text, "f"), *parse_poly(everything, "f"));
}

TEST(Poly, counts_from_the_number_of_the_first_point) {
  const auto from_0 = parse_poly("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n", "f");
  const auto from_1 = parse_poly("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n", "f");
  ASSERT_TRUE(from_0.ok());
  ASSERT_TRUE(from_1.ok());
  EXPECT_EQ(*from_0, *from_1);
}

TEST(Poly, remembers_the_number_of_the_first_point) {
  const auto first_id = [](std::string_view text) { return parse_poly(text, "f")->first_id.value; };
  EXPECT_EQ(first_id("2 2 0 0\n0 0 0\n1 1 0\n0\n0\n"), 0);
  EXPECT_EQ(first_id("2 2 0 0\n1 0 0\n2 1 0\n0\n0\n"), 1);
  EXPECT_EQ(*parse_poly("2 2 0 0\n0 0 0\n1 1 0\n0\n0\n", "f"), *parse_poly("2 2 0 0\n1 0 0\n2 1 0\n0\n0\n", "f"));
}

TEST(Poly, needs_no_more_in_a_header_than_the_count) {
  const auto pslg = parse_poly("3\n1 0 0\n2 1 0\n3 0 1\n1\n1 1 2\n0\n", "f");
  ASSERT_TRUE(pslg.ok()) << pslg.error().message;
  EXPECT_EQ(pslg->points.size(), 3u);
  EXPECT_TRUE(pslg->point_markers.empty());
  EXPECT_FALSE(pslg->has_segment_markers);
}

TEST(Poly, takes_an_area_that_is_not_positive_as_none) {
  const auto pslg = parse_poly("1\n1 0 0\n0\n0\n3\n1 0 0 5 -1\n2 0 0 5 0\n3 0 0 -2\n", "f");
  ASSERT_TRUE(pslg.ok()) << pslg.error().message;
  for (const Region& region : pslg->regions) EXPECT_TRUE(std::isinf(region.max_area));
  EXPECT_EQ(pslg->regions[2].attribute, -2);
}

TEST(Poly, without_points_takes_them_from_the_node_file_of_its_name) {
  const TemporaryFolder folder;
  folder.write("key ring.node", "3 2 0 1\n0 0 0 1\n1 1 0 2\n2 0 1 3\n");
  const auto pslg = read_pslg(folder.write("key ring.poly", "0 2 0 0\n1 0\n0 0 2\n0\n"));
  ASSERT_TRUE(pslg.ok()) << pslg.error().message;
  EXPECT_EQ(pslg->points, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(pslg->point_markers, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(pslg->segments, (std::vector<Segment>{{0, 2, 0}}));
}

TEST(Poly, names_the_node_file_that_is_missing_or_wrong) {
  const TemporaryFolder folder;
  const auto poly = folder.write("a.poly", "0 2 0 0\n1 0\n1 1 2\n0\n");
  EXPECT_EQ(message_of(read_pslg(poly), folder), "a.node: cannot be opened: No such file or directory");
  folder.write("a.node", "2 2 0 0\n1 0 0\n2 x 0\n");
  EXPECT_EQ(message_of(read_pslg(poly), folder), "a.node:3: expected an x coordinate, found \"x\"");
}

TEST(Poly, as_text_must_have_its_own_points) {
  EXPECT_EQ(failure_of("0 2 0 0\n1 0\n1 1 2\n0\n"),
            "f:1: expected points here: only a file can have them in a .node of the same name");
}

TEST(Poly, that_is_empty_is_an_error) {
  for (const char* text : {"", "\n\n", "# nothing\n", "   "}) {
    EXPECT_NE(failure_of(text).find(": expected the number of points, found the end of the file"), std::string::npos);
  }
}

TEST(Poly, of_binary_garbage_is_refused_at_its_first_line) {
  EXPECT_EQ(failure_of(std::string_view("\x7f"
                                        "ELF\x02\x01\x00\x00 \xff\xfe",
                                        11)),
            "f:1: expected the number of points, a whole number, found \"\\x7fELF\\x02\\x01\\x00\\x00\"");
}

TEST(Poly, cut_off_anywhere_before_its_regions_is_refused_with_a_place) {
  const std::string text = everything;
  const std::size_t regions = text.find("2\n1 0.75");
  for (std::size_t length = 0; length < text.size(); ++length) {
    const auto pslg = parse_poly(std::string_view(text).substr(0, length), "f");
    // A file cut before its regions is a valid file without regions, and a shortened number may be another valid
    // number.
    const bool after_holes = length + 2 >= regions;
    if (!after_holes) {
      ASSERT_FALSE(pslg.ok()) << length;
      EXPECT_EQ(pslg.error().message.substr(0, 2), "f:") << length;
    }
  }
}

struct Wrong {
  int line;
  const char* instead;
  const char* message;
};

TEST(Poly, errors_name_the_line_and_the_fault) {
  for (const Wrong& wrong : std::vector<Wrong>{
           {2, "x 2 1 1", "expected the number of points, a whole number, found \"x\""},
           {2, "-4 2 1 1", "expected the number of points, a whole number from 0 to 9223372036854775807, found \"-4\""},
           {2, "4 3 1 1", "expected the dimension, a whole number from 2 to 2, found \"3\""},
           {2, "4 2 1 2", "expected the number of markers per point, a whole number from 0 to 1, found \"2\""},
           {2, "4.0 2 1 1", "expected the number of points, a whole number, found \"4.0\""},
           {4, "2 0 0 10.5 3", "expected the first point's number, a whole number from 0 to 1, found \"2\""},
           {5, "3 1 0 11.5 0", "expected point 2 (numbers are consecutive), found 3"},
           {5, "2", "expected an x coordinate, found the end of the line"},
           {5, "2 1", "expected a y coordinate, found the end of the line"},
           {5, "2 nan 0 1 0", "expected an x coordinate, finite and within the range of a double, found \"nan\""},
           {5, "2 1 -inf 1 0", "expected a y coordinate, finite and within the range of a double, found \"-inf\""},
           {5, "2 1 0", "expected a point's attribute, found the end of the line"},
           {5, "2 1 0 11.5", "expected a point's marker, a whole number, found the end of the line"},
           {5, "2 1 0 11.5 1.5", "expected a point's marker, a whole number, found \"1.5\""},
           {9, "five 1", "expected the number of segments, a whole number, found \"five\""},
           {10, "1 1 5 7", "expected an end of a segment, a whole number from 1 to 4, found \"5\""},
           {10, "1 0 2 7", "expected an end of a segment, a whole number from 1 to 4, found \"0\""},
           {10, "1 1 2.5 7", "expected an end of a segment, a whole number, found \"2.5\""},
           {10, "1 1", "expected an end of a segment, a whole number, found the end of the line"},
           {10, "1 1 2", "expected a segment's marker, a whole number, found the end of the line"},
           {10, "1 1 2 99999999999",
            "expected a segment's marker, a whole number from -2147483648 to 2147483647, found \"99999999999\""},
           {16, "1 5 inf", "expected a y coordinate, finite and within the range of a double, found \"inf\""},
           {18, "1 0.75 0.25", "expected a region's attribute, found the end of the line"},
           {18, "1 0.75 0.25 1 nan",
            "expected a region's maximum area, finite and within the range of a double, found \"nan\""},
       }) {
    const std::string place = std::to_string(wrong.line);
    EXPECT_EQ(failure_of(with_line(wrong.line, wrong.instead)), std::string("f:") + place + ": " + wrong.message);
  }
}

TEST(Poly, with_too_large_a_count_misses_its_last_record) {
  EXPECT_EQ(failure_of(with_line(17, "3")), "f:20: expected region 3 of 3, found the end of the file");
  EXPECT_EQ(failure_of("5 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 9 9\n#       \n"),
            "f:7: expected point 5 of 5, found the end of the file");
}

TEST(Poly, with_an_absurd_count_is_an_error_before_memory_is_allocated) {
  EXPECT_EQ(failure_of("4000000000 2 0 0\n1 0 0\n"),
            "f:1: announces 4000000000 points, but the rest of the file is too short for that");
  EXPECT_EQ(failure_of("1 2 2000000000 0\n1 0 0\n"),
            "f:1: announces 1 points, but the rest of the file is too short for that");
  EXPECT_EQ(failure_of("9223372036854775807\n1 0 0\n"), "f:1: announces more than 4294967292 points");
  EXPECT_EQ(failure_of("1\n1 0 0\n1000000000000 1\n"),
            "f:3: announces 1000000000000 segments, but the rest of the file is too short for that");
  EXPECT_EQ(failure_of("1\n1 0 0\n0\n1000000000000\n"),
            "f:4: announces 1000000000000 holes, but the rest of the file is too short for that");
  EXPECT_EQ(failure_of("1\n1 0 0\n0\n0\n1000000000000\n"),
            "f:5: announces 1000000000000 regions, but the rest of the file is too short for that");
}

TEST(Poly, may_have_any_text_after_its_last_section) {
  EXPECT_TRUE(parse_poly("1\n1 0 0\n0\n0\n0\nand they lived happily ever after\n", "f").ok());
}

TEST(Poly, keeps_extreme_numbers) {
  const auto pslg = parse_poly("2\n1 1e300 -1e-300\n2 5e-324 0\n0\n0\n", "f");
  ASSERT_TRUE(pslg.ok());
  EXPECT_EQ(pslg->points, (std::vector<Point>{{1e300, -1e-300}, {std::numeric_limits<double>::denorm_min(), 0}}));
}

TEST(Node, alone_is_a_set_of_points) {
  const TemporaryFolder folder;
  const auto pslg = read_pslg(folder.write("p.node", "2 2 2 1\n0 0.25 1 -1 -2 5\n1 3 4 -3 -4 6\n"));
  ASSERT_TRUE(pslg.ok()) << pslg.error().message;
  EXPECT_EQ(pslg->points, (std::vector<Point>{{0.25, 1}, {3, 4}}));
  EXPECT_EQ(pslg->point_attributes, (std::vector<double>{-1, -2, -3, -4}));
  EXPECT_EQ(pslg->point_markers, (std::vector<int>{5, 6}));
  EXPECT_TRUE(pslg->segments.empty());
}

TEST(Node, without_points_is_an_empty_pslg) {
  const TemporaryFolder folder;
  const auto pslg = read_pslg(folder.write("p.node", "0 2 0 0\n"));
  ASSERT_TRUE(pslg.ok());
  EXPECT_TRUE(pslg->points.empty());
  const auto poly = read_pslg(folder.write("p.poly", "0\n1\n1 1 1\n0\n"));
  EXPECT_EQ(message_of(poly, folder),
            "p.poly:3: expected no point, as there are none, found one as an end of a segment");
}

TEST(Area, reads_one_cap_per_triangle_and_infinity_for_none) {
  const TemporaryFolder folder;
  const auto areas = read_area(folder.write("a.area", "4\n1 0.5\n2 -1\n3 1e-9\n4 0\n"));
  ASSERT_TRUE(areas.ok());
  const double no_bound = std::numeric_limits<double>::infinity();
  EXPECT_EQ(*areas, (std::vector<double>{0.5, no_bound, 1e-9, no_bound}));
}

TEST(Area, reads_back_as_it_was_written) {
  const TemporaryFolder folder;
  const std::vector<double> caps{0.1, std::numeric_limits<double>::infinity(), 5e-324, 1.0 / 3, 1e300};
  for (const int base : {0, 1}) {
    ASSERT_TRUE(write_area(folder / "a.area", caps, base).ok());
    EXPECT_EQ(*read_area(folder / "a.area"), caps);
  }
  EXPECT_TRUE(folder.read("a.area").starts_with("5\n1 0.1\n2 -1\n"));
}

TEST(Area, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  const auto failure = [&](const char* text) { return message_of(read_area(folder.write("a.area", text)), folder); };
  EXPECT_EQ(failure(""), "a.area:1: expected the number of values, found the end of the file");
  EXPECT_EQ(failure("2\n1 0.5\n3 1\n"), "a.area:3: expected triangle 2 (numbers are consecutive), found 3");
  EXPECT_EQ(failure("2\n1 0.5\n2 nan\n"),
            "a.area:3: expected a value, finite and within the range of a double, found \"nan\"");
  EXPECT_EQ(failure("2\n1 0.5  # ...\n"), "a.area:3: expected triangle 2 of 2, found the end of the file");
}

TEST(Area, may_be_as_short_as_its_number_of_values_allows) {
  const TemporaryFolder folder;
  std::string lines;
  for (int n = 1; n <= 9; ++n) {
    lines += std::to_string(n) + " 5\n";
    for (const std::string& text : {lines, lines.substr(0, lines.size() - 1)}) {
      const auto areas = read_area(folder.write("a.area", std::to_string(n) + "\n" + text));
      ASSERT_TRUE(areas.ok()) << areas.error().message;
      EXPECT_EQ(*areas, std::vector<double>(static_cast<std::size_t>(n), 5));
    }
    EXPECT_EQ(
        message_of(read_area(folder.write("a.area", std::to_string(n + 1) + "\n" + lines)), folder),
        "a.area:1: announces " + std::to_string(n + 1) + " values, but the rest of the file is too short for that");
  }
}

TEST(Sizes, must_be_greater_than_zero) {
  const TemporaryFolder folder;
  EXPECT_EQ(*read_sizes(folder.write("a", "2\n0 0.5\n1 2\n")), (std::vector<double>{0.5, 2}));
  EXPECT_EQ(message_of(read_sizes(folder.write("a", "2\n0 0.5\n1 0\n")), folder),
            "a:3: expected a value greater than 0, found 0");
}

TEST(WritePoly, writes_all_parts_of_a_pslg) {
  const TemporaryFolder folder;
  const Pslg pslg = *parse_poly(everything, "f");
  for (const int base : {0, 1}) {
    ASSERT_TRUE(write_poly(pslg, folder / "out.poly", base).ok());
    EXPECT_EQ(*read_pslg(folder / "out.poly"), pslg);
  }
  EXPECT_EQ(folder.names(), "out.poly ");
}

}  // namespace
}  // namespace pardel
