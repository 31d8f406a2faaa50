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

TEST(Svg, of_nothing_is_still_a_drawing) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_svg(Mesh{}, folder / "m.svg").ok());
  EXPECT_TRUE(write_svg(Pslg{}, folder / "p.svg").ok());
  EXPECT_EQ(count(folder.read("m.svg"), "<svg "), 1u);
  EXPECT_EQ(count(folder.read("p.svg"), "</svg>\n$"), 1u);
}

}  // namespace
}  // namespace pardel
