#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "../../../core/formats.hpp"
#include "../../../core/formats/raster_readers.hpp"
#include "../../temporary_folder.hpp"
#include "broken_text.hpp"

namespace pardel {
namespace {

const std::string grid = "ncols 3\nnrows 2\nxllcorner 9\nyllcorner 18\ncellsize 2\nNODATA_value -1\n5 6 -1\n1 2 4\n";

TEST(Asc, has_the_northernmost_row_first_and_its_corner_half_a_step_before_the_grid_points) {
  const TemporaryFolder folder;
  const auto raster = read_raster(folder.write("g.asc", grid));
  ASSERT_TRUE(raster.ok()) << raster.error().message;
  EXPECT_EQ(raster->columns, 3u);
  EXPECT_EQ(raster->rows, 2u);
  EXPECT_EQ(raster->first, (Point{10, 19}));
  EXPECT_EQ(raster->step_x, 2);
  EXPECT_EQ(raster->step_y, 2);
  EXPECT_EQ(std::vector<double>(raster->values.begin(), raster->values.begin() + 5),
            (std::vector<double>{1, 2, 4, 5, 6}));
  EXPECT_TRUE(std::isnan(raster->values[5]));
}

TEST(Asc, may_give_centres_two_steps_upper_case_and_any_line_breaks) {
  const TemporaryFolder folder;
  const auto raster = read_raster(folder.write(
      "g.asc", "NROWS 2\r\nNCOLS 3\r\nXLLCENTER 10\r\nYLLCENTER 20\r\nDX 2\r\nDY 4\r\n5 6\r\n7 1 2 4\r\n"));
  ASSERT_TRUE(raster.ok()) << raster.error().message;
  EXPECT_EQ(raster->first, (Point{10, 20}));
  EXPECT_EQ(raster->step_y, 4);
  EXPECT_EQ(raster->values, (std::vector<double>{1, 2, 4, 5, 6, 7}));
}

TEST(Asc, has_minus_9999_for_missing_values_by_default) {
  const TemporaryFolder folder;
  const auto raster =
      read_raster(folder.write("g.asc", replaced(replaced(grid, "NODATA_value -1\n", ""), "5 6 -1", "5 -9999 -1")));
  ASSERT_TRUE(raster.ok()) << raster.error().message;
  EXPECT_TRUE(std::isnan(raster->values[4]));
  EXPECT_EQ(raster->values[5], -1);
}

TEST(Asc, may_have_NaN_for_missing_values) {
  const TemporaryFolder folder;
  const auto raster =
      read_raster(folder.write("g.asc", replaced(replaced(grid, "value -1", "value NaN"), "5 6 -1", "nan 6 7")));
  ASSERT_TRUE(raster.ok()) << raster.error().message;
  EXPECT_TRUE(std::isnan(raster->values[3]));
  EXPECT_EQ(raster->values[5], 7);
}

TEST(Asc, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& from, const std::string& to) {
    return message_of_invalid(read_raster(folder.write("g.asc", replaced(grid, from, to))));
  };
  const std::vector<std::array<std::string, 3>> cases = {
      {"xllcorner 9\n", "", "g.asc:6: the header of the grid has neither xllcorner nor xllcenter"},
      {"ncols 3\n", "", "g.asc:6: the header of the grid has no ncols"},
      {"nrows 2", "nrows 2.5", "g.asc:2: expected the value of nrows"},
      {"nrows 2", "nrows 0", "g.asc:2: expected the value of nrows"},
      {"ncols 3", "ncols 18446744073709551617", "g.asc:1: expected the value of ncols"},
      {"cellsize 2", "cellsize 0", "g.asc:5: the size of a cell must be greater than 0"},
      {"nrows 2", "nrows 2\nncols 3", "g.asc:3: ncols is given twice"},
      {"xllcorner 9", "xllcorner 9\nxllcenter 9", "the header of the grid has both xllcorner and xllcenter"},
      {"1 2 4\n", "1 2 4\n7\n", "g.asc:9: expected the end of the file after 6 values, found \"7\""},
      {"cellsize 2", "cellsize 1e308", "g.asc: the raster extends beyond the range of a double"},
      {"cellsize 2", "cellsize two", "g.asc:5: expected the value of cellsize, found \"two\""},
      {"1 2 4\n", "1 2\n", "expected 6 values, found the end of the file"},
      {"1 2 4\n", "1 x 4\n", "g.asc:8: expected a value of the grid, found \"x\""},
      {"ncols 3", "ncols 300000", "values"},
  };
  for (const auto& [from, to, words] : cases)
    EXPECT_NE(failure(from, to).find(words), std::string::npos) << failure(from, to);
}

/// An array of NumPy with this dictionary, and the bytes of the numbers.
template <class Number>
std::string npy(const std::string& dictionary, const std::vector<Number>& numbers, bool swap = false) {
  std::string text = "\x93NUMPY";
  text += {'\1', '\0', static_cast<char>(dictionary.size()), '\0'};
  text += dictionary;
  for (const Number number : numbers) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (swap) std::ranges::reverse(bytes);
    text.append(bytes.data(), bytes.size());
  }
  return text;
}

const std::string doubles = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }\n";
const std::string world = "2\n0\n0\n-4\n10\n24\n";
const std::vector<double> south_to_north = {1, 2, 4, 5, 6, 7};

class Npy : public ::testing::Test {
 protected:
  [[nodiscard]] Result<Raster> read(const std::string& text, const std::string& place = world) const {
    (void)folder_.write("a.wld", place);
    return read_raster(folder_.write("a.npy", text));
  }
  [[nodiscard]] std::string failure(const std::string& text, const std::string& place = world) const {
    return message_of_invalid(read(text, place));
  }
  TemporaryFolder folder_;
};

TEST_F(Npy, has_the_northernmost_row_first_and_lies_where_the_world_file_says) {
  const auto raster = read(npy<double>(doubles, {5, 6, 7, 1, 2, 4}));
  ASSERT_TRUE(raster.ok()) << raster.error().message;
  EXPECT_EQ(raster->columns, 3u);
  EXPECT_EQ(raster->rows, 2u);
  EXPECT_EQ(raster->first, (Point{10, 20}));
  EXPECT_EQ(raster->step_x, 2);
  EXPECT_EQ(raster->step_y, 4);
  EXPECT_EQ(raster->values, south_to_north);
}

TEST_F(Npy, may_have_columns_first_and_the_other_byte_order) {
  const auto raster =
      read(npy<float>("{'descr': '>f4', 'fortran_order': True, 'shape': (2, 3)}", {5, 1, 6, 2, 7, 4}, true));
  ASSERT_TRUE(raster.ok()) << raster.error().message;
  EXPECT_EQ(raster->values, south_to_north);
}

TEST_F(Npy, may_have_integers) {
  const std::string dictionary = "{'descr': '<i2', 'fortran_order': False, 'shape': (2, 3), }";
  const auto signed_numbers = read(npy<std::int16_t>(dictionary, {5, 6, -7, 1, 2, 4}));
  ASSERT_TRUE(signed_numbers.ok()) << signed_numbers.error().message;
  EXPECT_EQ(signed_numbers->values[5], -7);
  const auto bytes = read(npy<std::uint8_t>(replaced(dictionary, "<i2", "|u1"), {5, 6, 250, 1, 2, 4}));
  ASSERT_TRUE(bytes.ok()) << bytes.error().message;
  EXPECT_EQ(bytes->values[5], 250);
  const auto longer = read(npy<std::int32_t>(replaced(dictionary, "<i2", "<i4"), {5, 6, -70000, 1, 2, 4}));
  ASSERT_TRUE(longer.ok()) << longer.error().message;
  EXPECT_EQ(longer->values[5], -70000);
  constexpr std::int64_t large = -(std::int64_t{1} << 40);
  const auto longest = read(npy<std::int64_t>(replaced(dictionary, "<i2", "<i8"), {5, 6, large, 1, 2, 4}));
  ASSERT_TRUE(longest.ok()) << longest.error().message;
  EXPECT_EQ(longest->values[5], static_cast<double>(large));
}

TEST_F(Npy, errors_name_the_file_and_the_fault) {
  const std::string good = npy<double>(doubles, {5, 6, 7, 1, 2, 4});
  EXPECT_NE(failure("NUMPY").find("a.npy: this is not an array of NumPy"), std::string::npos);
  EXPECT_NE(failure(good.substr(0, 30)).find("its header is not complete"), std::string::npos);
  EXPECT_NE(failure(replaced(good, "<f8", "<c8")).find("the type of numbers is \"<c8\""), std::string::npos);
  EXPECT_NE(failure(replaced(good, "'<f8',", "'<f80'")).find("the type of numbers is \"<f80\""), std::string::npos);
  EXPECT_NE(failure(replaced(good, "<f8", "<i3")).find("the type of numbers is \"<i3\""), std::string::npos);
  EXPECT_NE(failure(replaced(good, "descr", "typed")).find("the header has no type of numbers"), std::string::npos);
  EXPECT_NE(failure(replaced(good, "'<f8'", "(<f8)")).find("the header has no type of numbers"), std::string::npos);
  EXPECT_NE(failure(replaced(good, "\1", "\11")).find("this is not an array of NumPy"), std::string::npos);
  for (const char* shape : {"(23)  ", "[2, 3]", "()    ", "(2, 0)", "(2, x)", "2, 3)) ", "(-2,3)"})
    EXPECT_NE(failure(replaced(good, "(2, 3)", shape)).find("two dimensions"), std::string::npos) << shape;
}

TEST_F(Npy, has_as_many_numbers_as_its_header_says) {
  const std::string good = npy<double>(doubles, {5, 6, 7, 1, 2, 4}), message = "a.npy: expected 6 numbers, found ";
  const auto ending = [&](const std::string& text) {
    const std::string found = failure(text);
    const std::size_t at = found.find(message);
    return at == std::string::npos ? found : found.substr(at + message.size());
  };
  EXPECT_EQ(ending(good.substr(0, good.size() - 8)), "5");
  EXPECT_EQ(ending(good.substr(0, good.size() - 7)), "5 and a part of another one");
  EXPECT_EQ(ending(good.substr(0, good.size() - 1)), "5 and a part of another one");
  EXPECT_EQ(ending(good + "1"), "6 and a part of another one");
  EXPECT_EQ(ending(good + "1234567"), "6 and a part of another one");
  EXPECT_EQ(ending(good + "12345678"), "7");
}

TEST_F(Npy, of_versions_2_and_3_has_a_header_of_any_length) {
  for (const char version : {'\2', '\3'}) {
    std::string text = npy<double>(doubles, {5, 6, 7, 1, 2, 4});
    text[6] = version;
    text.insert(10, 2, '\0');  // the length has four bytes instead of two
    const auto raster = read(text);
    ASSERT_TRUE(raster.ok()) << raster.error().message;
    EXPECT_EQ(raster->values, south_to_north);
  }
}

TEST_F(Npy, may_end_anywhere_in_its_header_and_is_refused) {
  const auto of_header = [](const std::string& header) { return npy<char>(header, {}); };
  EXPECT_NE(failure(of_header("{}")).find("the header has no type of numbers"), std::string::npos);
  EXPECT_NE(failure(of_header("{")).find("this is not an array of NumPy"), std::string::npos);
  const auto of_shape = [&](const std::string& shape) {
    return failure(of_header("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }"));
  };
  const std::string limits = "the array must have two dimensions, each from 1 to 4294967294";
  for (const char* shape : {"(1, 4294967295)", "(4294967295, 1)", "(0, 1)", "(1, 0)", "(1)", "(1, 2, 3)", "(1x, 2)",
                            "()", "1, 2)", "(1, 2"})
    EXPECT_NE(of_shape(shape).find(limits), std::string::npos) << shape << of_shape(shape);
  EXPECT_EQ(of_shape("(1, 4294967294)").find(limits), std::string::npos);
  // The byte after the header belongs to the data, even if it is a quotation mark.
  EXPECT_NE(failure(of_header("{'descr': '<f8") + "'").find("the header has no type of numbers"), std::string::npos);
}

TEST_F(Npy, needs_a_world_file_without_rotation) {
  const std::string good = npy<double>(doubles, {5, 6, 7, 1, 2, 4});
  EXPECT_NE(failure(good, "2\n0.1\n0\n-4\n10\n24\n").find("a.wld:2: rotated rasters are not supported"),
            std::string::npos);
  EXPECT_NE(failure(good, "2\n0\n0.1\n-4\n10\n24\n").find("a.wld:3: rotated rasters are not supported"),
            std::string::npos);
  for (const char* beyond : {"1e308\n0\n0\n-4\n1.7e308\n24\n", "2\n0\n0\n-1e308\n10\n-1.7e308\n",
                             "1e308\n0\n0\n-4\n-1.7e308\n24\n", "2\n0\n0\n-1e308\n10\n1.7e308\n"})
    EXPECT_NE(failure(good, beyond).find("the raster extends beyond the range of a double"), std::string::npos)
        << beyond;
  EXPECT_NE(failure(good, "2\n0\n0\n4\n10\n24\n").find("a.wld:4: the fourth number must be less than 0"),
            std::string::npos);
  EXPECT_NE(failure(good, "2\n0\n0\n").find("one of six numbers"), std::string::npos);
  const auto alone = read_raster(folder_.write("alone.npy", good));
  ASSERT_FALSE(alone.ok());
  EXPECT_NE(alone.error().message.find("needs a world file"), std::string::npos) << alone.error().message;
}

TEST_F(Npy, is_refused_in_versions_that_do_not_exist_yet) {
  std::string text = npy<double>(doubles, {5, 6, 7, 1, 2, 4});
  for (const char version : {'\0', '\4', '\5'}) {
    text[6] = version;
    EXPECT_NE(failure(text).find("a.npy: this is not an array of NumPy"), std::string::npos);
  }
}

TEST_F(Npy, needs_steps_that_are_not_zero) {
  const std::string good = npy<double>(doubles, {5, 6, 7, 1, 2, 4});
  EXPECT_NE(failure(good, replaced(world, "-4", "0")).find("the fourth number must be less than 0"), std::string::npos);
  EXPECT_NE(failure(good, replaced(world, "2", "0")).find("the first number must be greater than 0"),
            std::string::npos);
}

TEST_F(Npy, may_have_its_type_last_and_few_blanks) {
  const auto raster = read(npy<double>("{'fortran_order':False,'shape':(2, 3),'descr':'<f8'", {5, 6, 7, 1, 2, 4}));
  for (const char* shape : {"(2,3)", "( 2, 3 )", "(2,3,)", "(2, 3 ,)"})
    EXPECT_TRUE(read(npy<double>(std::string("{'descr': '<f8', 'fortran_order': False, 'shape': ") + shape + " }",
                                 {5, 6, 7, 1, 2, 4})))
        << shape;
  ASSERT_TRUE(raster) << raster.error().message;
  EXPECT_EQ(raster->values, south_to_north);
}

/// From version 2 on, the length of the dictionary takes four bytes.
TEST_F(Npy, has_one_of_three_versions) {
  std::string text = npy<double>(doubles, {5, 6, 7, 1, 2, 4});
  text.insert(10, 2, '\0');
  for (const char version : {'\2', '\3', '\4'}) {
    text[6] = version;
    EXPECT_EQ(read(text).ok(), version < 4) << int(version);
  }
}

TEST(Asc, has_no_value_where_nan_is_written_in_any_way) {
  for (const char* nan : {"nan", "NaN", "nan(7)", "NANQ"}) {
    const auto raster =
        files::parse_asc("ncols 2\nnrows 1\nxllcenter 0\nyllcenter 0\ncellsize 1\n3 " + std::string(nan) + "\n", "g");
    ASSERT_TRUE(raster) << raster.error().message;
    EXPECT_EQ(raster->values[0], 3);
    EXPECT_TRUE(std::isnan(raster->values[1]));
  }
  EXPECT_FALSE(files::parse_asc("ncols 1\nnrows 1\nxllcenter 0\nyllcenter 0\ncellsize 1\nna\n", "g"));
}

}  // namespace
}  // namespace pardel
