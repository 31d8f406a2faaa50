#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

std::size_t count(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()));
}

TEST(Svg, of_a_mesh_fills_each_region_and_draws_each_constrained_edge) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  ASSERT_TRUE(write_svg(mesh, folder / "m.svg").ok());
  const std::string svg = folder.read("m.svg");
  EXPECT_EQ(count(svg, "fill=\"hsl"), 2u);
  EXPECT_EQ(count(svg, "Z\n"), 4u);
  EXPECT_EQ(count(svg, "M[0-9.]+ [0-9.]+L[0-9.]+ [0-9.]+\n"), 5u);
  EXPECT_EQ(count(svg, "</svg>\n$"), 1u);
}

TEST(Svg, of_a_small_mesh_is_that_of_a_large_one) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  ASSERT_TRUE(write_svg(mesh, folder / "large.svg").ok());
  for (Point& p : mesh.points) p = {0x1p-10 * p.x, 0x1p-10 * p.y};
  ASSERT_TRUE(write_svg(mesh, folder / "small.svg").ok());
  EXPECT_EQ(folder.read("small.svg"), folder.read("large.svg"));
}

TEST(Svg, of_a_mesh_without_regions_draws_its_triangles) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.region.clear();
  ASSERT_TRUE(write_svg(mesh, folder / "m.svg").ok());
  EXPECT_EQ(count(folder.read("m.svg"), "Z\n"), 4u);
  EXPECT_EQ(count(folder.read("m.svg"), "fill=\"hsl"), 1u);
}

TEST(Svg, of_many_triangles_has_no_attribute_above_one_megabyte) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (int i = 0; i < 200'002; ++i) mesh.points.push_back({double(i), i % 2 == 0 ? 0.0 : 150'000.25});
  for (Index i = 0; i < 200'000; ++i) {
    mesh.triangles.push_back({{i, i + 1, i + 2}, {}});
    mesh.constrained_edges.push_back({i, i + 2, no_index, 1});
  }
  ASSERT_TRUE(write_svg(mesh, folder / "m.svg").ok());
  const std::string svg = folder.read("m.svg");
  std::size_t longest = 0;
  for (std::size_t at = svg.find('"'); at != std::string::npos; at = svg.find('"', at + 1)) {
    const std::size_t end = svg.find('"', at + 1);
    longest = std::max(longest, end - at);
    at = end;
  }
  EXPECT_LT(longest, 1'000'000u);
  EXPECT_EQ(std::count(svg.begin(), svg.end(), 'Z'), 200'000);
  EXPECT_EQ(std::count(svg.begin(), svg.end(), 'M'), 400'000);
}

TEST(Svg, has_y_upwards_and_fits_its_canvas_even_far_from_the_origin) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.points.pop_back();
  mesh.region.clear();
  mesh.constrained_edges = {{0, 1, no_index, 0}};  // the lower side of the square
  for (Point& p : mesh.points) p = {p.x + 654321, p.y + 4987654};
  ASSERT_TRUE(write_svg(mesh, folder / "m.svg").ok());
  const std::string svg = folder.read("m.svg");
  EXPECT_NE(svg.find("viewBox=\"0 0 1040.000 1040.000\""), std::string::npos);
  EXPECT_NE(svg.find("M20.000 1020.000L1020.000 1020.000\n"), std::string::npos);
}

TEST(Svg, of_a_pslg_shows_points_segments_holes_and_regions) {
  const TemporaryFolder folder;
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {0, 1}, {0.25, 0.25}};
  pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  pslg.holes = {{0.1, 0.1}, {0.2, 0.2}};
  pslg.regions = {{{0.3, 0.3}, 12.5, 1}};
  ASSERT_TRUE(write_svg(pslg, folder / "p.svg").ok());
  const std::string svg = folder.read("p.svg");
  EXPECT_EQ(count(svg, "M[0-9.]+ [0-9.]+L[0-9.]+ [0-9.]+\n"), 3u);
  EXPECT_EQ(count(svg, "M[0-9.]+ [0-9.]+h0\n"), 4u);
  EXPECT_EQ(count(svg, "l12 12M"), 2u);
  EXPECT_EQ(count(svg, ">12.5</text>"), 1u);
}

TEST(Svg, of_a_pslg_is_this_text) {
  const TemporaryFolder folder;
  Pslg pslg;
  pslg.points = {{1, 2}, {3, 2}, {1, 3}};
  pslg.segments = {{0, 1, 0}, {2, 0, 0}};
  pslg.holes = {{1.25, 2.25}};
  pslg.regions = {{{1.5, 2.5}, 12.5, 1}};
  ASSERT_TRUE(write_svg(pslg, folder / "p.svg").ok());
  EXPECT_EQ(folder.read("p.svg"), R"svg(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1040.000 540.000">
<rect width="100%" height="100%" fill="white"/>
<path fill="none" stroke="#202020" stroke-width="1.5" stroke-linecap="round" d="
M20.000 520.000L1020.000 520.000
M20.000 20.000L20.000 520.000
"/>
<path stroke="#205090" stroke-width="4" stroke-linecap="round" d="
M20.000 520.000h0
M1020.000 520.000h0
M20.000 20.000h0
"/>
<path stroke="#c02020" stroke-width="2" d="
M139.000 389.000l12 12M139.000 401.000l12 -12
"/>
<path fill="#208040" d="M270.000 264.000l6 6l-6 6l-6 -6Z"/>
<text font-size="14" transform="translate(279.000 275.000)">12.5</text>
</svg>
)svg");
}

TEST(Svg, of_a_mesh_has_a_hue_for_each_region) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.points.pop_back();
  mesh.region[3] = no_index;
  mesh.region.pop_back();  // a region that is not listed is no region
  mesh.constrained_edges.clear();
  ASSERT_TRUE(write_svg(mesh, folder / "m.svg").ok());
  const std::string style = "stroke=\"#7088a0\" stroke-width=\"0.3\" stroke-linejoin=\"round\" fill=\"hsl(";
  EXPECT_EQ(folder.read("m.svg"),
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1040.000 1040.000\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
            "<path " +
                style +
                "124,60%,88%)\" d=\"\n"
                "M1020.000 1020.000L1020.000 20.000L520.000 520.000Z\n\"/>\n"
                "<path " +
                style +
                "210,60%,88%)\" d=\"\n"
                "M20.000 20.000L20.000 1020.000L520.000 520.000Z\n\"/>\n"
                "<path " +
                style +
                "347,60%,88%)\" d=\"\n"
                "M20.000 1020.000L1020.000 1020.000L520.000 520.000Z\n"
                "M1020.000 20.000L20.000 20.000L520.000 520.000Z\n\"/>\n"
                "</svg>\n");
}

TEST(Svg, of_one_point_has_this_point_in_its_middle) {
  const TemporaryFolder folder;
  Pslg pslg;
  pslg.points = {{7, -3}};
  EXPECT_TRUE(write_svg(pslg, folder / "p.svg").ok());
  EXPECT_NE(folder.read("p.svg").find("viewBox=\"0 0 40.000 40.000\""), std::string::npos) << folder.read("p.svg");
}

TEST(Svg, of_nothing_is_still_a_drawing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_svg(Mesh{}, folder / "m.svg").ok());
  EXPECT_TRUE(write_svg(Pslg{}, folder / "p.svg").ok());
  EXPECT_EQ(count(folder.read("m.svg"), "<svg "), 1u);
  EXPECT_EQ(count(folder.read("p.svg"), "</svg>\n$"), 1u);
}

}  // namespace
}  // namespace pardel
