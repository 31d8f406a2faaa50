// pardel mesh --refine of meshes whose lines are no edges of triangles, or whose triangles overlap.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

/// The square from (0, 0) to (2, 2) with nine nodes. Their numbers are 10, 20, 30 in the lowest row, and so on; each
/// unit square has a diagonal from its lower left corner.
class GivenLines : public Workshop {
 protected:
  struct Line {
    int a = 0, b = 0, marker = 0;
  };
  using Triangles = std::vector<std::array<int, 3>>;

  static Triangles triangles() {
    return {{10, 20, 50}, {10, 50, 40}, {20, 30, 60}, {20, 60, 50},
            {40, 50, 80}, {40, 80, 70}, {50, 60, 90}, {50, 90, 80}};
  }
  void write_msh(const std::string& name, const std::vector<Line>& lines, const Triangles& triangles) const {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n";
    for (int i = 0; i < 9; ++i) text += fmt::format("{} {} {} 0\n", 10 * (i + 1), i % 3, i / 3);
    text += fmt::format("$EndNodes\n$Elements\n{}\n", lines.size() + triangles.size());
    int tag = 0;
    for (const Line& line : lines)
      text += fmt::format("{} 1 2 {} {} {} {}\n", ++tag, line.marker, line.marker, line.a, line.b);
    for (const auto& v : triangles) text += fmt::format("{} 2 2 0 0 {} {} {}\n", ++tag, v[0], v[1], v[2]);
    write(name, text + "$EndElements\n");
  }
  [[nodiscard]] Ran refine(const std::vector<Line>& lines, const Triangles& of = triangles()) const {
    write_msh("m.msh", lines, of);
    return pardel({"mesh", "m.msh", "--refine", "-o", "r.node", "--max-area", "0.1", "--check"});
  }
  /// The same mesh in Triangle's files, which number its nodes from 1 to 9, with the lines in the .poly.
  void write_files(const std::vector<Line>& lines, const Triangles& triangles,
                   const std::string& after_segments = "0\n") const {
    std::string nodes = "9 2 0 0\n", elements = fmt::format("{} 3 0\n", triangles.size()),
                poly = fmt::format("0 2 0 0\n{} 1\n", lines.size());
    for (int i = 0; i < 9; ++i) nodes += fmt::format("{} {} {}\n", i + 1, i % 3, i / 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      elements += fmt::format("{} {} {} {}\n", t + 1, triangles[t][0] / 10, triangles[t][1] / 10, triangles[t][2] / 10);
    for (std::size_t s = 0; s < lines.size(); ++s)
      poly += fmt::format("{} {} {} {}\n", s + 1, lines[s].a / 10, lines[s].b / 10, lines[s].marker);
    write("m.node", nodes);
    write("m.ele", elements);
    write("m.poly", poly + after_segments);
  }
  [[nodiscard]] Ran refine_files(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"mesh", "m.node", "--refine", "-o", "r.node", "--max-area", "0.1", "--check"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return pardel(arguments);
  }
  /// The message for files that `mesh --refine` and `triangle -rp` refuse, without the name of the file.
  [[nodiscard]] std::string refusal_of_files() const {
    const Ran ran = refine_files();
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_FALSE(exists("r.node"));
    const std::string name = "pardel: m.node: ";
    EXPECT_TRUE(ran.err.starts_with(name)) << ran;
    const Ran other = pardel({"triangle", "-rpQ", "m"});
    EXPECT_EQ(other.exit_code, 3) << other;
    EXPECT_FALSE(exists("m.1.ele"));
    EXPECT_EQ(other.err, "pardel: m.ele: " + ran.err.substr(name.size()));
    return ran.err.substr(name.size());
  }
  /// The message for a mesh that is refused.
  [[nodiscard]] std::string refusal(const std::vector<Line>& lines, const Triangles& of = triangles()) const {
    const Ran ran = refine(lines, of);
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_FALSE(exists("r.node"));
    return ran.err;
  }
  /// The length of the edges with the marker in the refined mesh, NAME.node with NAME.poly.
  [[nodiscard]] double length_with(int marker, const std::string& name = "r") const {
    const auto rows = [](const std::string& text) {
      std::istringstream in(text);
      std::vector<std::vector<double>> all;
      for (std::string line; std::getline(in, line);) {
        std::istringstream fields(line);
        all.emplace_back();
        for (double value = 0; fields >> value;) all.back().push_back(value);
      }
      return all;
    };
    const auto nodes = rows(read(name + ".node")), segments = rows(read(name + ".poly"));
    double length = 0;
    for (const auto& segment : segments) {
      if (segment.size() != 4 || segment[3] != marker || segment[2] < 1) continue;
      const auto first = static_cast<std::size_t>(nodes[1][0]);
      const auto &a = nodes[1 + static_cast<std::size_t>(segment[1]) - first],
                 &b = nodes[1 + static_cast<std::size_t>(segment[2]) - first];
      length += std::hypot(a[1] - b[1], a[2] - b[2]);
    }
    return length;
  }
};

TEST_F(GivenLines, through_further_nodes_are_the_edges_between_them) {
  const Ran ran = refine({{40, 60, 5}, {30, 10, 6}, {90, 10, 7}});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.msh: note: 3 constrained edges through further nodes are taken as 6 edges"})) << ran;
  EXPECT_NEAR(length_with(5), 2, 1e-12);
  EXPECT_NEAR(length_with(6), 2, 1e-12);
  EXPECT_NEAR(length_with(7), std::sqrt(8.0), 1e-12);
}

TEST_F(GivenLines, that_are_edges_make_the_same_mesh_without_a_note) {
  ASSERT_EQ(refine({{40, 60, 5}}).exit_code, 0);
  const std::string through = read("r.poly"), nodes = read("r.node");
  const Ran ran = refine({{40, 50, 5}, {50, 60, 5}});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(read("r.poly"), through);
  EXPECT_EQ(read("r.node"), nodes);
}

TEST_F(GivenLines, that_leave_the_edges_are_refused_with_their_nodes) {
  const std::string what =
      "m.msh: constrained edge between nodes that no edges of triangles join along a straight line: ";
  EXPECT_TRUE(holds(refusal({{20, 40, 1}}), {what + "20-40\n"})) << "across a diagonal";
  EXPECT_TRUE(holds(refusal({{10, 60, 1}}), {what + "10-60\n"})) << "across triangles";
  EXPECT_TRUE(holds(refusal({{30, 70, 1}}), {what + "30-70\n"})) << "through a node, across triangles";
  EXPECT_TRUE(holds(refusal({{50, 50, 1}}), {what + "50-50\n"})) << "without length";
  EXPECT_TRUE(holds(refusal({{10, 60, 1}, {10, 20, 1}, {40, 60, 1}, {20, 40, 1}}), {"straight line: 10-60, 20-40\n"}));
}

TEST_F(GivenLines, do_not_hide_a_triangle_that_is_turned_or_overlaps_another_one) {
  Triangles turned = triangles();
  std::swap(turned[7][0], turned[7][1]);
  EXPECT_TRUE(
      holds(refusal({}, turned), {"m.msh: triangle 8 of the mesh (vertices 90, 50, 80) is not positively oriented\n"}));
  Triangles twice = triangles();
  twice.push_back(twice[3]);
  EXPECT_TRUE(holds(refusal({}, twice), {"m.msh: triangle 4 of the mesh (vertices 20, 60, 50) overlaps triangle 9 "
                                         "(vertices 20, 60, 50): both lie on the same side of the edge "}));
  Triangles more = triangles();
  more.push_back({10, 30, 50});
  EXPECT_TRUE(holds(refusal({}, more), {"Segments 10-20 and 10-30 overlap from (0, 0) on.",
                                        "Edge 10-20 is a side of triangle 1 (vertices 10, 20, 50).",
                                        "Edge 10-30 is a side of triangle 9 (vertices 10, 30, 50)."}));
}

using Triangle = std::array<int, 3>;

TEST_F(GivenLines, of_a_poly_through_further_nodes_are_the_edges_between_them) {
  const std::vector<Line> lines{{10, 30, 6}, {30, 90, 1}, {90, 70, 1}, {70, 10, 1}, {40, 60, 5}, {90, 10, 7}};
  write_files(lines, triangles());
  const std::string followed = "m.{}: note: 6 constrained edges through further nodes are taken as 12 edges\n";
  const Ran ran = refine_files();
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.err, "pardel: " + fmt::format(fmt::runtime(followed), "node"));
  const Ran other = pardel({"triangle", "-rpa0.1", "m"});
  EXPECT_EQ(other.exit_code, 0) << other;
  EXPECT_EQ(other.err, "pardel: " + fmt::format(fmt::runtime(followed), "ele"));
  for (const char* name : {"r", "m.1"}) {
    EXPECT_NEAR(length_with(6, name), 2, 1e-12) << name;
    EXPECT_NEAR(length_with(5, name), 2, 1e-12) << name;
    EXPECT_NEAR(length_with(7, name), std::sqrt(8.0), 1e-12) << name;
  }
  EXPECT_EQ(pardel({"triangle", "-rpQ", "m"}).err, "");
  ASSERT_EQ(refine(lines).exit_code, 0);
  EXPECT_NEAR(length_with(1), 6, 1e-12) << "the same from a .msh";
}

TEST_F(GivenLines, of_a_poly_that_are_kept_are_not_split_between_nodes) {
  write_files({{10, 30, 1}, {30, 90, 1}, {90, 70, 1}, {70, 10, 1}, {40, 60, 5}}, triangles());
  const Ran ran = refine_files({"--keep", "5"});
  EXPECT_EQ(ran.exit_code, 4) << ran;
  int kept = 0;
  for (const auto& row : table("r.poly")) kept += row.size() == 4 && row[3] == 5 ? 1 : 0;
  EXPECT_EQ(kept, 2);
}

TEST_F(GivenLines, of_a_poly_that_leave_the_edges_are_refused_with_their_nodes) {
  const std::string what = "constrained edge between nodes that no edges of triangles join along a straight line: ";
  for (const auto& [line, names] :
       std::vector<std::pair<Line, std::string>>{{{20, 40, 1}, "2-4"}, {{10, 60, 1}, "1-6"}, {{30, 70, 1}, "3-7"}}) {
    for (const bool is_closed : {false, true}) {
      std::vector<Line> lines{line};
      if (is_closed) lines.insert(lines.end(), {{10, 30, 1}, {30, 90, 1}, {90, 70, 1}, {70, 10, 1}});
      write_files(lines, triangles());
      EXPECT_EQ(refusal_of_files(), what + names + "\n");
    }
  }
}

TEST_F(GivenLines, of_a_poly_may_lie_in_its_holes) {
  const Triangles ring{{10, 20, 50}, {10, 50, 40}, {20, 30, 60}, {20, 60, 50}, {40, 50, 70}};
  const std::vector<Line> outline{{10, 30, 1}, {30, 60, 1}, {60, 50, 1}, {50, 70, 1}, {70, 10, 1}};
  // Outside: 70-90, 60-90, 60-80. In the square of the lines 60-90, 90-80, 80-50, 50-60, a hole: 50-90.
  std::vector<Line> lines = outline;
  lines.insert(lines.end(), {{60, 90, 3}, {90, 80, 3}, {80, 50, 3}, {50, 90, 4}});
  write_files(lines, ring, "2\n1 1.2 1.8\n2 1.8 1.2\n");
  const Ran ran = pardel({"mesh", "m.node", "--refine", "-o", "r.node", "--max-area", "0.1", "--drop-unused"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"note: 2 constrained edges through further nodes are taken as 4 edges\n"})) << ran;
  EXPECT_EQ(length_with(4), 0);
  EXPECT_EQ(pardel({"triangle", "-rpQ", "m"}).exit_code, 0);
  write_files(lines, ring, "1\n1 1.2 1.8\n");
  EXPECT_EQ(refine_files().exit_code, 3) << "one side of the line is in the domain";
}

TEST_F(GivenLines, in_holes_of_a_poly_are_refused_where_the_mesh_has_triangles) {
  std::vector<Line> lines{{10, 30, 1}, {30, 90, 1}, {90, 70, 1}, {70, 10, 1}};
  lines.insert(lines.end(), {{10, 20, 2}, {20, 50, 2}, {50, 40, 2}, {40, 10, 2}, {20, 40, 3}});
  write_files(lines, triangles(), "2\n1 0.2 0.2\n2 0.8 0.8\n");
  EXPECT_TRUE(holds(refusal_of_files(), {"along a straight line: 2-4\n"}));
}

TEST_F(GivenLines, of_a_poly_do_not_hide_that_triangles_do_not_fit) {
  const std::vector<Line> outline{{10, 20, 1}, {20, 30, 1}, {30, 60, 1}, {60, 90, 1},
                                  {90, 80, 1}, {80, 70, 1}, {70, 40, 1}, {40, 10, 1}};
  Triangles more = triangles();
  more.push_back(Triangle{10, 30, 50});
  write_files(outline, more);
  EXPECT_TRUE(holds(refusal_of_files(), {"Segments 1-2 and 1-3 overlap from (0, 0) on.",
                                         "Edge 1-3 is a side of triangle 9 (vertices 1, 3, 5)."}));
  Triangles touching = triangles();
  touching.erase(touching.begin(), touching.begin() + 2);
  touching.insert(touching.end(), {{10, 20, 40}, {20, 60, 40}});
  touching.erase(touching.begin() + 1);  // the edge 40-60 passes through the node 50
  write_files(outline, touching);
  EXPECT_TRUE(holds(refusal_of_files(), {"Point 5 at (1, 1) lies in the interior of segment 6-4."}));
  Triangles fewer = triangles();
  fewer.erase(fewer.begin());
  write_files(outline, fewer);
  EXPECT_TRUE(holds(refusal_of_files(), {"no edges of triangles join along a straight line: 1-2\n"}));
}

TEST_F(GivenLines, of_a_poly_that_has_other_points_than_the_mesh_are_not_used_and_a_note_says_so) {
  write_files({}, triangles());
  write("m.poly", "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n5 1\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 5\n5 1 3 7\n0\n");
  const Ran ran = refine_files({"-q"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.err, "pardel: m.poly: note: not used, because it has 4 points for a mesh with 9 vertices\n");
}

TEST_F(GivenLines, with_area_caps_of_regions_make_a_note_without_an_option_that_is_refused) {
  write_files({}, triangles(), "0\n1\n1 0.5 0.5 3 0.01\n");
  const Ran ran = pardel({"mesh", "m.node", "--refine", "-o", "r.node"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"note    the area caps of the regions are ignored when a mesh is refined\n"})) << ran;
  EXPECT_FALSE(holds(ran.out, {"--regions"})) << ran;
}

}  // namespace
}  // namespace pardel::testing
