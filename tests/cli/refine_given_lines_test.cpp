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
  /// The message for a mesh that is refused.
  [[nodiscard]] std::string refusal(const std::vector<Line>& lines, const Triangles& of = triangles()) const {
    const Ran ran = refine(lines, of);
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_FALSE(exists("r.node"));
    return ran.err;
  }
  /// The length of the edges with the marker in the refined mesh.
  [[nodiscard]] double length_with(int marker) const {
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
    const auto nodes = rows(read("r.node")), segments = rows(read("r.poly"));
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

}  // namespace
}  // namespace pardel::testing
