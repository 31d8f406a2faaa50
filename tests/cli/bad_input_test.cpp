// Invalid input gives one message that names the place, the right exit code, and no output file.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

class BadInput : public Workshop {
 protected:
  /// Expects that `pardel mesh` fails on this text with `code` and a message that contains `words`, writes no file and
  /// prints nothing on standard output.
  void is_refused(std::string_view text, int code, const std::vector<std::string>& words,
                  const std::vector<std::string>& more = {}) const {
    write("bad.poly", text);
    std::vector<std::string> arguments = {"mesh", "bad.poly", "-o", "out.vtu", "-o", "out.node"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, code) << ran;
    EXPECT_TRUE(holds(ran.err, words));
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(files(), Files{"bad.poly"});
  }
  void is_refused(std::string_view text, const std::vector<std::string>& words) const { is_refused(text, 3, words); }
};

std::string with_point(const std::string& x) {
  return "4 2 0 0\n1 0 0\n2 " + x + " 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
}

/// The outline of the square, with additional points and segments.
std::string with_more(const std::string& points, const std::string& segments, int segment_count) {
  return "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n" + points + std::to_string(segment_count) +
         " 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n" + segments + "0\n";
}

TEST_F(BadInput, a_file_that_does_not_exist_is_an_io_error) {
  const Ran ran = pardel({"mesh", "nowhere.poly", "-o", "out.vtu"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"nowhere.poly", "No such file"}));
  EXPECT_EQ(files(), Files{});
}

TEST_F(BadInput, an_unknown_suffix_is_a_usage_error_that_lists_the_known_ones) {
  write("model.stl", square_poly);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"mesh", "model.stl", "-o", "out.vtu"}, {"check", "model.stl", "model.vtu"}, {"doctor", "model.stl"}}) {
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(
        ran.err,
        {"model.stl: '.stl' is not a known format; the formats of a domain are .poly, .node, .geojson and .json"}));
  }
  const Ran mesh = pardel({"draw", "model.stl", "-o", "m.svg"});
  EXPECT_EQ(mesh.exit_code, 2) << mesh;
  EXPECT_TRUE(holds(
      mesh.err, {"'.stl' is not a known format", ".node, .ele, .msh, .vtu, .pvtu, .off, .vtk, .2dm, .gr3 and .14"}));
}

TEST_F(BadInput, the_message_names_the_command_or_the_option_that_helps) {
  is_refused(with_more("5 0.25 0.5\n6 0.75 0.5\n", "5 5 6\n6 1 3\n", 6),
             {"'pardel mesh --repair'", "'pardel doctor bad.poly --repair FIXED.poly'"});
  is_refused("4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n", {"--convex-hull"});
  write("out_of_range.poly", with_point("1e300"));
  EXPECT_EQ(pardel({"mesh", "out_of_range.poly", "-o", "out.vtu"}).err.find("--repair"), std::string::npos);
}

TEST_F(BadInput, a_repair_that_failed_is_not_advised_again) {
  write("open.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n2 0\n1 1 3\n2 2 4\n0\n");
  EXPECT_NE(pardel({"doctor", "open.poly"}).out.find("--repair"), std::string::npos);
  const Ran ran = pardel({"doctor", "open.poly", "--repair", "fixed.poly"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_EQ(ran.out.find("--repair"), std::string::npos) << ran;
  EXPECT_TRUE(holds(ran.err, {"the repair ends here: No outline is closed"}));
}

TEST_F(BadInput, the_advice_is_right) {
  write("bad.poly", with_more("5 0.25 0.5\n6 0.75 0.5\n", "5 5 6\n6 1 3\n", 6));
  EXPECT_EQ(pardel({"mesh", "--repair", "bad.poly", "-o", "out.vtu"}).exit_code, 0);
  EXPECT_EQ(pardel({"doctor", "bad.poly", "--repair", "fixed.poly"}).exit_code, 0);
  EXPECT_EQ(pardel({"mesh", "fixed.poly", "-o", "out.vtu"}).exit_code, 0);
  write("open.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n");
  EXPECT_EQ(pardel({"mesh", "--convex-hull", "open.poly", "-o", "out.vtu"}).exit_code, 0);
}

TEST_F(BadInput, at_most_ten_problems_of_a_kind_are_printed_and_all_are_in_the_json) {
  std::string points;
  for (int i = 0; i < 12; ++i) points += std::to_string(5 + i) + " 0." + std::to_string(10 + 5 * i) + " 0\n";
  write("many.poly", "16 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n" + points + "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Ran ran = pardel({"mesh", "many.poly", "-o", "out.vtu", "--json", "many.json"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"12 problems", "Point 5 ", "Point 14 ", "... and 2 more (point_on_segment)"}));
  EXPECT_EQ(ran.err.find("Point 15 "), std::string::npos);
  const auto json = nlohmann::json::parse(read("many.json"));
  ASSERT_EQ(json["problems"].size(), 12U);
  EXPECT_EQ(json["problems"][11]["kind"], "point_on_segment");
  EXPECT_EQ(json["problems"][11]["ids"][0], 16);
}

TEST_F(BadInput, an_empty_file_is_refused) { is_refused("", {"bad.poly:1:", "end of the file"}); }

TEST_F(BadInput, a_file_of_comments_alone_is_refused) { is_refused("# nothing\n\n# here\n", {"bad.poly:"}); }

TEST_F(BadInput, a_truncated_file_is_refused_with_the_line_where_it_ends) {
  const std::string whole = square_poly;
  is_refused(whole.substr(0, whole.find("0\n", whole.find("4 4 1 8"))), {"bad.poly:12:", "the end of the file"});
  is_refused(whole.substr(0, whole.find("1 1 2 5")), {"bad.poly:7:", "4 segments"});
}

TEST_F(BadInput, a_truncation_at_any_byte_ends_with_a_message_or_a_mesh) {
  const std::string whole = square_poly;
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    write("cut.poly", whole.substr(0, length));
    const Ran ran = pardel({"mesh", "cut.poly", "-o", "cut.vtu", "-q"});
    EXPECT_TRUE(ran.exit_code == 0 || (ran.exit_code == 3 && holds(ran.err, {"cut.poly"}))) << length << ": " << ran;
  }
}

TEST_F(BadInput, binary_garbage_is_refused_without_being_printed) {
  std::string garbage = "\x7f\x45\x4c\x46";
  for (int i = 0; i < 4000; ++i) garbage += static_cast<char>(i * 7919 % 251);
  is_refused(garbage, {"bad.poly:1:"});
  const std::string err = pardel({"mesh", "bad.poly", "-o", "out.vtu"}).err;
  EXPECT_EQ(err.find('\x7f'), std::string::npos);
}

TEST_F(BadInput, a_count_of_points_larger_than_the_file_is_refused) {
  is_refused("4000000000 2 0 0\n1 0 0\n2 1 0\n", {"bad.poly:1:", "4000000000"});
}

TEST_F(BadInput, a_count_that_is_too_small_is_refused_where_the_next_section_fails) {
  is_refused("3 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n", {"bad.poly:"});
}

TEST_F(BadInput, a_negative_count_is_refused) { is_refused("-4 2 0 0\n", {"bad.poly:1:", "-4"}); }

TEST_F(BadInput, a_dimension_of_three_is_refused) { is_refused("4 3 0 0\n1 0 0 0\n", {"bad.poly:1:"}); }

TEST_F(BadInput, nan_is_refused_with_its_line) { is_refused(with_point("nan"), {"bad.poly:3:", "nan"}); }

TEST_F(BadInput, infinity_is_refused_with_its_line) { is_refused(with_point("inf"), {"bad.poly:3:", "inf"}); }

TEST_F(BadInput, a_number_beyond_double_is_refused_with_its_line) {
  is_refused(with_point("1e999"), {"bad.poly:3:", "1e999"});
}

TEST_F(BadInput, a_coordinate_of_1e300_is_refused_with_its_point) {
  is_refused(with_point("1e300"), {"bad.poly", "Point 2", "1e+300"});
}

TEST_F(BadInput, a_coordinate_of_1e_minus_300_is_refused_with_its_point) {
  is_refused(with_point("1e-300"), {"bad.poly", "Point 2", "1e-300"});
}

TEST_F(BadInput, a_segment_end_out_of_range_is_refused_with_its_line) {
  is_refused("4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 9\n3 3 4\n4 4 1\n0\n", {"bad.poly:8:", "9"});
  is_refused("4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 0\n3 3 4\n4 4 1\n0\n", {"bad.poly:8:", "0"});
}

TEST_F(BadInput, duplicate_points_are_refused_with_both_numbers) {
  is_refused(with_more("5 0.5 0.5\n6 0.5 0.5\n", "", 4), {"bad.poly", "5", "6", "0.5, 0.5"});
}

TEST_F(BadInput, crossing_segments_are_refused_with_the_crossing) {
  is_refused(with_more("5 0.25 0.5\n6 0.75 0.5\n", "5 5 6\n6 1 3\n", 6), {"bad.poly", "cross", "0.5, 0.5"});
}

TEST_F(BadInput, overlapping_collinear_segments_are_refused) {
  is_refused(
      "8 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.2 0.5\n6 0.6 0.5\n7 0.4 0.5\n8 0.8 0.5\n"
      "6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 7 8\n0\n",
      {"bad.poly", "overlap"});
}

TEST_F(BadInput, a_point_on_a_segment_is_refused_with_its_number) {
  is_refused(with_more("5 0.5 0\n6 0.5 0.5\n", "", 4), {"bad.poly", "Point 5", "0.5, 0"});
}

TEST_F(BadInput, points_that_are_all_collinear_are_refused) {
  is_refused("4 2 0 0\n1 0 0\n2 1 1\n3 2 2\n4 3 3\n0 0\n0\n", {"bad.poly", "on one line"});
}

TEST_F(BadInput, two_points_are_refused) { is_refused("2 2 0 0\n1 0 0\n2 1 1\n0 0\n0\n", {"bad.poly"}); }

TEST_F(BadInput, a_hole_outside_is_refused_with_its_place) {
  is_refused("4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n1\n1 7 8\n",
             {"bad.poly", "Hole 1", "7, 8"});
}

TEST_F(BadInput, an_outline_that_is_not_closed_is_refused) {
  is_refused("4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n", {"bad.poly", "outline"});
}

TEST_F(BadInput, every_problem_is_listed_not_only_the_first) {
  is_refused(with_more("5 0.5 0.5\n6 0.5 0.5\n", "5 1 3\n6 2 4\n", 6),
             {"4 problems", "Points 5 and 6", "cross", "interior of segment 5", "interior of segment 6"});
}

TEST_F(BadInput, an_angle_of_60_is_a_usage_error) {
  is_refused(square_poly, 2, {"--min-angle", "60", "33"}, {"--min-angle", "60"});
}

TEST_F(BadInput, a_negative_angle_and_nan_are_usage_errors) {
  is_refused(square_poly, 2, {"--min-angle", "-1"}, {"--min-angle", "-1"});
  is_refused(square_poly, 2, {"--min-angle", "nan"}, {"--min-angle", "nan"});
  is_refused(square_poly, 2, {"--min-angle", "20x"}, {"--min-angle", "20x"});
}

TEST_F(BadInput, a_negative_zero_or_undefined_area_is_a_usage_error) {
  is_refused(square_poly, 2, {"--max-area", "-0.5"}, {"--max-area", "-0.5"});
  is_refused(square_poly, 2, {"--max-area"}, {"--max-area", "0"});
  is_refused(square_poly, 2, {"--max-area", "nan"}, {"--max-area", "nan"});
}

TEST_F(BadInput, a_ratio_that_no_mesh_can_have_is_a_usage_error) {
  is_refused(square_poly, 2, {"--rho", "0.5"}, {"--rho", "0.5"});
}

TEST_F(BadInput, an_angle_together_with_a_ratio_is_a_usage_error) {
  is_refused(square_poly, 2, {"--rho", "--min-angle"}, {"--rho", "1.5", "--min-angle", "20"});
}

TEST_F(BadInput, sizes_that_cannot_be_read_are_reported_before_an_invalid_domain) {
  write("crossing.poly", "4 2 0 0\n1 0 0\n2 1 1\n3 1 0\n4 0 1\n2 0\n1 1 2\n2 3 4\n0\n");
  const Ran ran = pardel({"mesh", "crossing.poly", "-o", "o.vtu", "--sizes", "none.sizes"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"none.sizes", "cannot be opened"}));
}

TEST_F(BadInput, useless_limits_on_gradation_and_numbers_of_edges_are_refused) {
  write("square.poly", square_poly);
  for (const char* option : {"--grading", "--feature-size"}) {
    for (const char* wrong : {"0", "-1", "nan", "inf", "fast"}) {
      const Ran ran = pardel({"mesh", "square.poly", "-o", "o.vtu", option, wrong});
      EXPECT_EQ(ran.exit_code, 2);
      EXPECT_TRUE(holds(ran.err, {option, wrong, "greater than 0"})) << ran.err;
    }
    const Ran ran = pardel({"mesh", "square.poly", "-o", "o.vtu", option, "1", "--refine"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(holds(ran.err, {option, "--refine"})) << ran.err;
  }
}

TEST_F(BadInput, the_checker_has_the_limits_of_the_mesher_for_gradation_and_numbers_of_edges) {
  for (const std::string command : {"mesh", "check"})
    for (const auto& [option, wrong, message] : {std::tuple("--grading", "1e-13", "'1e-13' is less than 1e-12"),
                                                 std::tuple("--feature-size", "1e7", "'1e7' is more than 1000000")}) {
      const Ran ran = command == "mesh" ? pardel({"mesh", "square.poly", "-o", "m.vtu", option, wrong})
                                        : pardel({"check", "square.poly", "m.vtu", option, wrong});
      EXPECT_EQ(ran.exit_code, 2) << ran;
      EXPECT_TRUE(holds(ran.err, {option, message}));
    }
}

TEST_F(BadInput, sizes_that_do_not_fit_the_points_are_refused) {
  write("few.sizes", "2\n1 0.1\n2 0.1\n");
  const Ran ran =
      (write("square.poly", square_poly), pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "few.sizes"}));
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"few.sizes", "2 sizes", "4 input points"}));
}

TEST_F(BadInput, a_size_that_is_not_positive_is_refused_with_its_line) {
  write("square.poly", square_poly);
  write("zero.sizes", "4\n1 0.1\n2 0\n3 0.1\n4 0.1\n");
  const Ran ran = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "zero.sizes"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"zero.sizes:3: expected a value greater than 0, found 0"}));
}

TEST_F(BadInput, a_raster_that_does_not_cover_the_domain_is_refused_with_the_point) {
  write("square.poly", square_poly);
  const std::string header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize ";
  write("small.asc", header + "0.4\n1 1\n1 1\n");
  const Ran small = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "small.asc"});
  EXPECT_EQ(small.exit_code, 3) << small;
  EXPECT_TRUE(holds(small.err, {"small.asc: the raster from (0, 0) to (0.8, 0.8) does not cover point 2 at (1, 0)"}));
  write("hole.asc", header + "0.5\n0.1 -9999\n0.1 0.1\n");
  const Ran hole = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "hole.asc"});
  EXPECT_EQ(hole.exit_code, 3) << hole;
  EXPECT_TRUE(holds(hole.err, {"hole.asc has no size at ("}));
  write("zero.asc", header + "0.5\n0.1 0\n0.1 0.1\n");
  const Ran zero = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "zero.asc"});
  EXPECT_EQ(zero.exit_code, 3) << zero;
  EXPECT_TRUE(holds(zero.err, {"zero.asc: the size in row 1, column 2", "at (0.75, 0.75), is 0"}));
}

TEST_F(BadInput, a_mesh_of_sizes_without_values_or_too_small_is_refused) {
  write("square.poly", square_poly);
  write("small.node", "3 2 1 0\n1 0 0 0.1\n2 0.1 0 0.1\n3 0 0.1 0.1\n");
  write("small.ele", "1 3 0\n1 1 2 3\n");
  const Ran small = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "small.node"});
  EXPECT_EQ(small.exit_code, 3) << small;
  EXPECT_TRUE(holds(small.err, {"small.node does not cover ("}));
  write("plain.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Ran plain = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "plain.off"});
  EXPECT_EQ(plain.exit_code, 3) << plain;
  EXPECT_TRUE(holds(plain.err, {"plain.off: the mesh has no values at its points", "$NodeData"}));
}

TEST_F(BadInput, the_checker_refuses_a_field_of_sizes_that_ends_inside_the_mesh) {
  write("square.poly", square_poly);
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m.vtu", "--max-area", "0.01", "-q"}).exit_code, 0);
  write("hole.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\n1 -9999\n1 1\n");
  write("small.node", "3 2 1 0\n1 0 0 1\n2 0.1 0 1\n3 0 0.1 1\n");
  write("small.ele", "1 3 0\n1 1 2 3\n");
  for (const std::vector<std::string>& more : {std::vector<std::string>(), {"--grading", "0.5"}})
    for (const auto& [field, message] :
         {std::pair("hole.asc", "hole.asc has no size at ("), std::pair("small.node", "small.node does not cover (")}) {
      std::vector<std::string> arguments = {"check", "square.poly", "m.vtu", "--sizes", field, "--json", "c.json"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Ran ran = pardel(arguments);
      EXPECT_EQ(ran.exit_code, 3) << ran;
      EXPECT_TRUE(holds(ran.err, {message}));
      EXPECT_EQ(ran.out, "");
    }
}

TEST_F(BadInput, an_array_of_sizes_without_a_world_file_is_refused) {
  write("square.poly", square_poly);
  write("a.npy", "whatever");
  const Ran ran = pardel({"mesh", "square.poly", "-o", "o.vtu", "--sizes", "a.npy"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"a.npy: the array needs a world file", "a.wld"}));
}

TEST_F(BadInput, problems_are_numbered_as_the_file_numbers_its_points) {
  is_refused("6 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0.5 0.5\n5 0.5 0.5\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n",
             {"bad.poly", "4", "5"});
}

TEST_F(BadInput, the_checker_and_the_doctor_refuse_what_cannot_be_read) {
  write("bad.poly", "what is this?\n");
  write("square.poly", square_poly);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"doctor", "bad.poly"},
                                             {"draw", "bad.poly", "-o", "x.svg"},
                                             {"check", "bad.poly", "bad.poly"},
                                             {"triangle", "-p", "bad"},
                                             {"triangle", "-pq", "bad.poly"}}) {
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 3) << arguments[0] << ": " << ran;
    EXPECT_TRUE(holds(ran.err, {"bad.poly:1:"}));
  }
  EXPECT_EQ(files(), (Files{"bad.poly", "square.poly"}));
}

}  // namespace
}  // namespace pardel::testing
