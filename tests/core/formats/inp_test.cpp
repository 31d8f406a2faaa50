// What is written is parsed by the rules of Abaqus' manual, as far as they matter here.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

/// The fields of the lines after each keyword line, without comments.
using Sections = std::map<std::string, std::vector<std::vector<std::string>>>;

Sections parse(const std::string& text) {
  Sections sections;
  std::string keyword;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("**")) continue;
    if (line.starts_with("*")) {
      sections[keyword = line];
      continue;
    }
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field.substr(field.find_first_not_of(' ')));
    sections[keyword].push_back(std::move(fields));
  }
  return sections;
}

TEST(Inp, has_the_points_with_all_digits_and_the_triangles_by_region) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.points[4] = {1.0 / 3, 1e-17};
  ASSERT_TRUE(write_mesh(mesh, {}, folder / "m.inp").ok());
  Sections sections = parse(folder.read("m.inp"));
  const auto& nodes = sections["*NODE, NSET=ALL"];
  ASSERT_EQ(nodes.size(), mesh.points.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes[i][0], std::to_string(i + 1));
    EXPECT_EQ((Point{std::stod(nodes[i][1]), std::stod(nodes[i][2])}), mesh.points[i]);
  }
  using Lines = std::vector<std::vector<std::string>>;
  // The region 2.5 has the smallest free tag.
  EXPECT_EQ(sections["*ELEMENT, TYPE=CPS3, ELSET=REGION_1"], (Lines{{"1", "1", "2", "5"}, {"3", "3", "4", "5"}}));
  EXPECT_EQ(sections["*ELEMENT, TYPE=CPS3, ELSET=REGION_7"], (Lines{{"2", "2", "3", "5"}, {"4", "4", "1", "5"}}));
  EXPECT_NE(folder.read("m.inp").find("** region 2.5\n*ELEMENT, TYPE=CPS3, ELSET=REGION_1\n"), std::string::npos);
}

TEST(Inp, has_per_marker_the_nodes_and_the_sides_at_the_boundary) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_inp(sample_mesh(), folder / "m.inp").ok());
  Sections sections = parse(folder.read("m.inp"));
  using Lines = std::vector<std::vector<std::string>>;
  EXPECT_EQ(sections["*NSET, NSET=MARKER_1"], (Lines{{"1", "2", "3", "4"}}));
  EXPECT_EQ(sections["*SURFACE, TYPE=ELEMENT, NAME=SIDES_1"], (Lines{{"1", "S1"}, {"3", "S1"}}));
  EXPECT_EQ(sections["*NSET, NSET=MARKER_5"], (Lines{{"2", "3"}}));
  EXPECT_EQ(sections["*SURFACE, TYPE=ELEMENT, NAME=SIDES_5"], (Lines{{"2", "S1"}}));
  EXPECT_EQ(sections["*NSET, NSET=MARKER_3"], (Lines{{"3", "5"}})) << "marker 0, an edge inside";
  EXPECT_FALSE(sections.contains("*SURFACE, TYPE=ELEMENT, NAME=SIDES_3"));
}

TEST(Inp, begins_a_new_line_after_sixteen_nodes_of_a_set) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (int i = 0; i < 17; ++i) mesh.points.push_back({static_cast<double>(i), 0});
  for (Index i = 0; i + 1 < 17; ++i) mesh.constrained_edges.push_back({i, i + 1, no_index, 1});
  ASSERT_TRUE(write_inp(mesh, folder / "m.inp").ok());
  const auto set = parse(folder.read("m.inp"))["*NSET, NSET=MARKER_1"];
  ASSERT_EQ(set.size(), 2U);
  EXPECT_EQ(set[0].size(), 16U);
  EXPECT_EQ(set[1], std::vector<std::string>{"17"});
}

TEST(Inp, is_not_read) {
  const TemporaryFolder folder;
  const auto read = read_mesh(folder.write("m.inp", "*NODE\n"));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace pardel
