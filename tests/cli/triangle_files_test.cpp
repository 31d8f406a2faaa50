// pardel triangle writes the same files as Triangle, with the same names and numbers.
#include <algorithm>
#include <string>
#include <vector>

#include "triangle_command.hpp"

namespace pardel::testing {
namespace {

TEST_F(TriangleCommand, p_writes_node_ele_and_poly_of_the_next_number) {
  ends_well("p", "a");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "a.1.node", "a.1.ele", "a.1.poly"}));
  const Rows node = table("a.1.node");
  EXPECT_EQ(node[0], (std::vector<double>{4, 2, 0, 1}));
  EXPECT_EQ(node[2], (std::vector<double>{2, 1, 0, 5}));  // the marker of the first segment at the point
  const Rows ele = table("a.1.ele");
  EXPECT_EQ(ele[0], (std::vector<double>{2, 3, 0}));
  const Rows poly = table("a.1.poly");
  EXPECT_EQ(poly[0][0], 0);
  EXPECT_EQ(poly[1], (std::vector<double>{4, 1}));
}

TEST_F(TriangleCommand, the_suffix_poly_stands_for_p) {
  ends_well("", "a.poly");
  EXPECT_TRUE(exists("a.1.poly"));
}

TEST_F(TriangleCommand, a_file_name_may_contain_spaces) {
  write("my square.poly", square_poly);
  ends_well("pq", "my square.poly");
  EXPECT_TRUE(exists("my square.1.ele"));
}

TEST_F(TriangleCommand, input_vertices_come_first_and_in_order) {
  ends_well("pq30a0.01", "b");
  const Rows in = table("b.poly"), out = table("b.1.node");
  for (std::size_t i = 1; i <= 11; ++i) {
    EXPECT_EQ(out[i][1], in[i][1]);
    EXPECT_EQ(out[i][2], in[i][2]);
    EXPECT_EQ(out[i][3], in[i][3]);  // the attribute
  }
}

TEST_F(TriangleCommand, numbers_start_where_the_input_starts) {
  ends_well("pqen", "a");
  ends_well("pqen", "b");
  for (const std::string suffix : {".node", ".ele", ".edge", ".neigh"}) {
    EXPECT_EQ(table("a.1" + suffix)[1][0], 1) << suffix;
    EXPECT_EQ(table("b.1" + suffix)[1][0], 0) << suffix;
  }
}

TEST_F(TriangleCommand, c_writes_a_poly_of_the_hull_of_bare_points) {
  write("c.node", "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 2\n");
  ends_well("c", "c");
  const Rows poly = table("c.1.poly");
  EXPECT_EQ(poly[1], (std::vector<double>{4, 1}));
  for (int i = 2; i <= 5; ++i) EXPECT_EQ(poly[i][3], 1);
}

TEST_F(TriangleCommand, P_N_and_E_leave_files_out) {
  ends_well("pqPN", "a");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "a.1.ele"}));
  ends_well("pqE", "b");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "a.1.ele", "b.1.node", "b.1.poly"}));
}

TEST_F(TriangleCommand, I_writes_names_without_a_number_and_replaces_no_input_file) {
  ends_well("pqI", "a");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "a.node", "a.ele"}));
  EXPECT_EQ(read("a.poly"), square_poly);
  const std::string points = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  write("c.node", points);
  ends_well("I", "c");
  EXPECT_EQ(read("c.node"), points);
  EXPECT_TRUE(exists("c.ele"));
}

TEST_F(TriangleCommand, I_keeps_the_node_file_of_a_poly_without_points) {
  const std::string points = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
  write("d.node", points);
  write("d.poly", "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  ends_well("pI", "d");
  EXPECT_EQ(read("d.node"), points);
  EXPECT_TRUE(exists("d.ele"));
}

TEST_F(TriangleCommand, B_leaves_out_markers) {
  ends_well("pqeB", "a");
  EXPECT_EQ(table("a.1.node")[0][3], 0);
  EXPECT_EQ(table("a.1.poly")[1][1], 0);
  EXPECT_EQ(table("a.1.edge")[0][1], 0);
}

TEST_F(TriangleCommand, markers_follow_the_segments) {
  ends_well("pqea0.01", "a");
  int on_first = 0;
  const Rows node = table("a.1.node"), edge = table("a.1.edge");
  for (std::size_t e = 1; e < edge.size(); ++e) {
    const auto& a = node[static_cast<std::size_t>(edge[e][1])];
    const auto& b = node[static_cast<std::size_t>(edge[e][2])];
    const bool bottom = a[2] == 0 && b[2] == 0;
    EXPECT_EQ(edge[e][3] == 5, bottom);
    on_first += bottom;
  }
  EXPECT_GT(on_first, 1);
  for (std::size_t i = 5; i < node.size(); ++i) EXPECT_EQ(node[i][3] == 5, node[i][2] == 0) << i;
}

TEST_F(TriangleCommand, e_and_n_describe_the_mesh) {
  ends_well("pqena0.05", "b");
  const Rows node = table("b.1.node"), ele = table("b.1.ele"), edge = table("b.1.edge"), neigh = table("b.1.neigh");
  EXPECT_EQ(neigh[0], (std::vector<double>{ele[0][0], 3}));
  int outside = 0;
  for (std::size_t t = 1; t < neigh.size(); ++t) {
    for (int i = 1; i <= 3; ++i) {
      const double other = neigh[t][i];
      outside += other < 0;
      if (other < 0) continue;
      // The neighbour has the two other corners, and this triangle is its neighbour.
      const auto& theirs = ele[static_cast<std::size_t>(other) + 1];
      const auto& back = neigh[static_cast<std::size_t>(other) + 1];
      for (int k = 1; k <= 3; ++k) {
        const bool shared = std::find(theirs.begin() + 1, theirs.end(), ele[t][k]) != theirs.end();
        EXPECT_EQ(shared, k != i);
      }
      EXPECT_NE(std::find(back.begin() + 1, back.end(), ele[t][0]), back.end());
    }
  }
  EXPECT_EQ(2 * edge[0][0], 3 * ele[0][0] + outside);
}

TEST_F(TriangleCommand, g_writes_off) {
  ends_well("pqg", "a");
  EXPECT_EQ(read("a.1.off").substr(0, 3), "OFF");
}

TEST_F(TriangleCommand, o2_writes_six_nodes_in_the_order_of_triangle) {
  ends_well("po2", "a");
  const Rows node = table("a.1.node"), ele = table("a.1.ele");
  EXPECT_EQ(node[0][0], 4 + 5);  // a midpoint for each of the five edges
  ASSERT_EQ(ele[0][1], 6);
  for (std::size_t t = 1; t < ele.size(); ++t) {
    for (int i = 0; i < 3; ++i) {  // node 4 lies opposite corner 1
      const auto& middle = node[static_cast<std::size_t>(ele[t][4 + i])];
      const auto& from = node[static_cast<std::size_t>(ele[t][1 + (i + 1) % 3])];
      const auto& to = node[static_cast<std::size_t>(ele[t][1 + (i + 2) % 3])];
      EXPECT_EQ(middle[1], (from[1] + to[1]) / 2);
      EXPECT_EQ(middle[2], (from[2] + to[2]) / 2);
    }
  }
}

TEST_F(TriangleCommand, every_file_ends_with_the_command_line) {
  ends_well("pqen", "a");
  for (const std::string suffix : {".node", ".ele", ".poly", ".edge", ".neigh"}) {
    EXPECT_TRUE(read("a.1" + suffix).ends_with("\n# Generated by pardel triangle -Qpqen a\n")) << suffix;
  }
}

TEST_F(TriangleCommand, the_number_in_a_name_counts_up) {
  const auto writes = [&](const std::string& name, const std::string& next) {
    write(name + ".poly", square_poly);
    ends_well("p", name);
    EXPECT_TRUE(exists(next + ".ele")) << name;
  };
  writes("box.1", "box.2");
  writes("box.9", "box.10");
  writes("box.v2", "box.v2.1");
  writes("2", "2.1");
}

}  // namespace
}  // namespace pardel::testing
