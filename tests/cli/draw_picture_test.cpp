// The pictures of pardel draw: formats, windows, colours by quality, size and region, meshes of many triangles.
#include <algorithm>
#include <string>
#include <vector>

#include "picture.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

constexpr std::uint32_t white = 0xFFFFFF;

class DrawPicture : public Workshop {
 protected:
  /// Two triangles: the left one has angles of 45 and 90 degrees, the right one a small angle and a long edge.
  DrawPicture() {
    write("m.node", "4 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 4 1\n");
    write("m.ele", "2 3 1\n1 1 2 3 7\n2 2 4 3 9\n");
  }
  [[nodiscard]] Picture picture(const std::string& input, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"draw", input, "x.png", "--no-legend"});
    const Ran ran = pardel(options);
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.err, "");
    Picture drawn(folder_ / "work" / "x.png");
    EXPECT_TRUE(drawn.ok());
    return drawn;
  }
  /// The width in pixels of the dark line at the left border of the unit square, in the middle of the picture.
  [[nodiscard]] int border(const std::string& pixels) const {
    const Picture drawn = picture("square.poly", {"--pixels", pixels});
    int dark = 0;
    for (int x = 0; x < drawn.width() / 2; ++x) dark += (drawn.at(x, drawn.height() / 3) & 0xFF) < 128 ? 1 : 0;
    return dark;
  }
};

TEST_F(DrawPicture, the_longer_side_has_the_pixels_that_the_option_sets) {
  const Picture drawn = picture("m.ele", {"--pixels", "500"});
  EXPECT_EQ(drawn.width(), 520);   // with margins of 10 pixels
  EXPECT_EQ(drawn.height(), 145);  // the mesh is four times as wide as high
}

TEST_F(DrawPicture, the_output_may_be_an_option_as_before) {
  EXPECT_EQ(pardel({"draw", "m.ele", "-o", "a.svg"}).exit_code, 0);
  EXPECT_EQ(pardel({"draw", "m.ele", "b.svg"}).exit_code, 0);
  EXPECT_EQ(read("a.svg"), read("b.svg"));
}

TEST_F(DrawPicture, another_format_is_a_usage_error_that_lists_the_known_ones) {
  const Ran ran = pardel({"draw", "m.ele", "x.gif"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"x.gif: '.gif' is not a known format", ".svg and .png"}));
  EXPECT_FALSE(exists("x.gif"));
}

TEST_F(DrawPicture, triangles_of_different_quality_size_and_region_have_different_colours) {
  for (const std::string by : {"quality", "size", "region"}) {
    const Picture drawn = picture("m.ele", {"--by", by, "--pixels", "400"});
    const std::uint32_t left = drawn.at(8 + 25, 8 + 75), right = drawn.at(8 + 160, 8 + 50);
    EXPECT_NE(left, right) << by;
    EXPECT_NE(left, white) << by;
    EXPECT_NE(right, white) << by;
    EXPECT_EQ(drawn.at(8 + 380, 8 + 90), white) << by;  // outside the mesh
  }
}

TEST_F(DrawPicture, a_window_that_no_scale_fits_is_refused) {
  for (const char* window : {"0,0,5e-324,5e-324", "-1e308,-1e308,1e308,1e308"}) {
    const Ran ran = pardel({"draw", "m.ele", "tiny.svg", std::string("--window=") + window});
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"--window: its larger side has to be between 1e-300 and 1e+300"})) << ran;
  }
}

TEST_F(DrawPicture, a_window_shows_only_its_part_of_the_plane) {
  const Picture all = picture("m.ele", {"--pixels", "400"});
  const Picture part = picture("m.ele", {"--pixels", "400", "--window", "0.1,0.1,0.3,0.3"});
  EXPECT_EQ(part.width(), part.height());
  // The window lies within the left triangle.
  for (const int x : {50, 200, 350}) EXPECT_EQ(part.at(x, 200), all.at(8 + 20, 8 + 80)) << x;
  EXPECT_EQ(part.at(2, 200), white);  // the margin
  const Picture far = picture("m.ele", {"--window", "10,10,11,11", "--pixels", "100"});
  EXPECT_EQ(far.at(50, 50), white);
}

TEST_F(DrawPicture, a_window_much_smaller_than_the_triangles_is_filled) {
  const Picture drawn = picture("m.ele", {"--pixels", "400", "--window", "0.25,0.25,0.2500000001,0.2500000001"});
  EXPECT_EQ(drawn.at(200, 200), drawn.at(300, 100));
  EXPECT_NE(drawn.at(200, 200), white);
}

TEST_F(DrawPicture, a_window_without_area_is_a_usage_error) {
  for (const char* window : {"0,0,0,1", "1,0,0,1", "0,1,1,0", "0,0,nan,1"})
    EXPECT_EQ(pardel({"draw", "m.ele", "x.png", "--window", window}).exit_code, 2) << window;
  EXPECT_EQ(pardel({"draw", "m.ele", "x.png", "--window", "0,0,1"}).exit_code, 2);
}

TEST_F(DrawPicture, lines_scale_with_the_picture) {
  write("square.poly", square_poly);
  const int narrow = border("1000"), wide = border("4000");
  EXPECT_GE(narrow, 1);
  EXPECT_GE(wide, 3 * narrow);
  EXPECT_LE(wide, 5 * narrow);
}

TEST_F(DrawPicture, triangles_below_a_pixel_have_their_colour_and_are_darker_where_they_are_smaller) {
  write("square.poly", square_poly);
  write("square.sizes", "4\n1 0.002\n2 0.02\n3 0.02\n4 0.002\n");
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "g.vtu", "--sizes", "square.sizes", "-q"}).exit_code, 0);
  const Picture drawn = picture("g.vtu", {"--pixels", "100"});
  const double fine_part = drawn.brightness(10, 40, 20, 60), coarse_part = drawn.brightness(85, 40, 95, 60);
  EXPECT_LT(fine_part, coarse_part - 10);
  for (int y = 10; y < 95; ++y)
    for (int x = 10; x < 95; ++x) ASSERT_NE(drawn.at(x, y), white) << x << ", " << y;
}

TEST_F(DrawPicture, no_pixel_is_lighter_than_its_triangles_where_small_and_large_ones_meet) {
  write("square.poly", square_poly);
  write("coarse.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
  write("coarse.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  write("square.sizes", "4\n1 0.003\n2 0.03\n3 0.03\n4 0.003\n");
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "g.vtu", "--sizes", "square.sizes", "-q"}).exit_code, 0);
  const std::uint32_t fill = picture("coarse.ele", {"--pixels", "200"}).at(140, 130);
  const Picture drawn = picture("g.vtu", {"--pixels", "200"});
  for (int y = 10; y < 190; ++y)
    for (int x = 10; x < 190; ++x)
      for (const int shift : {0, 8, 16})
        ASSERT_LE(drawn.at(x, y) >> shift & 0xFF, (fill >> shift & 0xFF) + 1) << x << ", " << y;
}

TEST_F(DrawPicture, small_triangles_have_the_colour_of_the_scale) {
  std::string node = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n", ele = "2 3 0\n1 1 2 3\n2 1 3 4\n";
  write("large.node", node);
  write("large.ele", ele);
  // The same triangles beside a third one that is a hundred times as large, so that they are below three pixels.
  write("small.node", "7 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 2 0\n6 100 0\n7 100 1\n");
  write("small.ele", "3 3 0\n1 1 2 3\n2 1 3 4\n3 5 6 7\n");
  const std::uint32_t large = picture("large.ele", {"--by", "quality", "--pixels", "100"}).at(22, 70);
  const Picture small = picture("small.ele", {"--by", "quality", "--pixels", "200", "--window", "0,0,100,100"});
  EXPECT_EQ(small.at(4, 4 + 198), large);
}

TEST_F(DrawPicture, an_svg_of_small_triangles_does_not_grow_with_their_number) {
  write("square.poly", square_poly);
  std::vector<std::size_t> meshes, pictures;
  for (const std::string area : {"2e-5", "4e-6"}) {
    ASSERT_EQ(
        pardel({"mesh", "square.poly", "-o", "b.vtu", "--max-area", area, "-q", "--interior", "refine"}).exit_code, 0);
    ASSERT_EQ(pardel({"draw", "b.vtu", "b.svg", "--pixels", "200"}).exit_code, 0);
    meshes.push_back(read("b.vtu").size());
    pictures.push_back(read("b.svg").size());
  }
  EXPECT_GT(meshes[1], 4 * meshes[0]);
  EXPECT_LT(pictures[1], pictures[0] + pictures[0] / 5);
}

TEST_F(DrawPicture, no_attribute_of_an_svg_exceeds_the_limit_of_xml_readers) {
  write("square.poly", square_poly);
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "b.vtu", "--max-area", "1e-5", "-q"}).exit_code, 0);
  ASSERT_EQ(pardel({"draw", "b.vtu", "b.svg", "--pixels", "10000"}).exit_code, 0);
  const std::string svg = read("b.svg");
  ASSERT_GT(svg.size(), 12'000'000U);
  std::size_t longest = 0;
  for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
    end = svg.find('"', at);
    longest = std::max(longest, std::min(end, svg.size()) - at);
  }
  EXPECT_LT(longest, 10'000'000U);
}

TEST_F(DrawPicture, a_legend_adds_a_column) {
  ASSERT_EQ(pardel({"draw", "m.ele", "with.png", "--by", "quality", "--pixels", "1000"}).exit_code, 0);
  const Picture with(folder_ / "work" / "with.png"), without = picture("m.ele", {"--pixels", "1000"});
  ASSERT_GT(with.width(), without.width());
  EXPECT_LT(with.brightness(without.width(), 0, with.width(), with.height()), 254.0);
}

TEST_F(DrawPicture, an_empty_mesh_gives_an_empty_picture) {
  write("e.off", "OFF\n0 0 0\n");
  EXPECT_EQ(picture("e.off", {"--pixels", "100"}).at(50, 50), white);
}

TEST_F(DrawPicture, a_full_disk_is_an_io_error) {
  for (const std::string suffix : {"png", "svg"}) {
    std::filesystem::create_symlink("/dev/full", folder_ / "work" / ("full." + suffix));
    const Ran ran = pardel({"draw", "m.ele", "full." + suffix});
    EXPECT_EQ(ran.exit_code, 5) << suffix << ": " << ran;
    EXPECT_TRUE(holds(ran.err, {"full." + suffix, "No space left"}));
  }
}

}  // namespace
}  // namespace pardel::testing
