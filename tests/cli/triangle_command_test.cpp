// pardel triangle writes the same files as Triangle, with the same names and numbers.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

class TriangleCommand : public Workshop {
 protected:
  TriangleCommand() {
    write("a.poly", square_poly);
    // A square with a square hole; regions left and right of a wall, the right one with an area cap. Counted from 0.
    write("b.poly", R"(11 2 1 1
0 0 0 10 3
1 2 0 20 0
2 4 0 30 0
3 4 2 40 0
4 2 2 50 0
5 0 2 60 0
6 0.5 0.5 1 0
7 1.5 0.5 2 0
8 1.5 1.5 3 0
9 0.5 1.5 4 0
10 9 9 5 0
11 1
0 0 1 7
1 1 2 0
2 2 3 0
3 3 4 0
4 4 5 0
5 5 0 0
6 1 4 9
7 6 7 0
8 7 8 0
9 8 9 0
10 9 6 0
1
0 1 1
2
0 0.2 1 5 -1
1 3 1 8 0.05
)");
  }

  void ends_well(const std::string& switches, const std::string& file) const {
    const Ran ran = pardel({"triangle", "-Q" + switches, file});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.out, "");
  }
};

using Rows = std::vector<std::vector<double>>;

/// No mesh with angles of 44 degrees is found for it.
constexpr const char* quadrilateral =
    "4 2 0 0\n1 0 0\n2 5 0.3\n3 4 4.1\n4 1 3\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";

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

TEST_F(TriangleCommand, without_p_the_convex_hull_of_the_points_is_triangulated) {
  write("c.node", "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 2\n");
  ends_well("", "c");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "c.node", "c.1.node", "c.1.ele"}));
  EXPECT_EQ(table("c.1.ele")[0][0], 4);
  EXPECT_EQ(table("c.1.node")[0][0], 5);
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

TEST_F(TriangleCommand, all_switches_work_together) {
  ends_well("pq30a0.1ADjenz", "b");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "b.1.node", "b.1.ele", "b.1.poly", "b.1.edge", "b.1.neigh"}));
  EXPECT_EQ(pardel({"check", "b.poly", "b.1.ele", "--min-angle", "30", "--max-area", "0.1", "--conforming"}).exit_code,
            0);
}

TEST_F(TriangleCommand, a_second_run_refines_the_first) {
  ends_well("pq", "a");
  ends_well("rpq30a0.01", "a.1");
  EXPECT_TRUE(exists("a.2.node") && exists("a.2.ele") && exists("a.2.poly"));
  EXPECT_EQ(pardel({"check", "a.poly", "a.2.ele", "--min-angle", "30", "--max-area", "0.01"}).exit_code, 0);
  ends_well("rq", "a.2");
  EXPECT_FALSE(exists("a.3.poly"));
  EXPECT_TRUE(exists("a.3.ele"));
}

TEST_F(TriangleCommand, an_area_file_caps_the_triangles_of_the_mesh_it_refines) {
  ends_well("p", "a");
  write("a.1.area", "2\n1 0.001\n2 -1\n");
  ends_well("rpqa", "a.1");
  const Rows node = table("a.2.node");
  EXPECT_GT(node.size(), 200U);
}

TEST_F(TriangleCommand, a_without_a_number_applies_the_caps_of_regions) {
  ends_well("pq", "b");
  const std::size_t coarse = table("b.1.ele").size();
  ends_well("pqa", "b");
  EXPECT_GT(table("b.1.ele").size(), coarse + 50);
  EXPECT_EQ(pardel({"check", "b.poly", "b.1.ele", "--min-angle", "20", "--regions"}).exit_code, 0);
}

TEST_F(TriangleCommand, a_may_be_given_twice) {
  ends_well("pqaa0.2", "b");
  EXPECT_EQ(pardel({"check", "b.poly", "b.1.ele", "--min-angle", "20", "--regions", "--max-area", "0.2"}).exit_code, 0);
}

TEST_F(TriangleCommand, area_without_q_bounds_no_angle) {
  ends_well("pa0.1", "a");
  EXPECT_EQ(pardel({"check", "a.poly", "a.1.ele", "--min-angle", "0", "--max-area", "0.1"}).exit_code, 0);
}

TEST_F(TriangleCommand, q_without_a_number_is_20_degrees) {
  write("thin.poly", "4 2 0 0\n1 0 0\n2 10 0\n3 10 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  ends_well("p", "thin");
  EXPECT_EQ(pardel({"check", "thin.poly", "thin.1.ele", "--min-angle", "20"}).exit_code, 1);
  ends_well("pq", "thin");
  EXPECT_EQ(pardel({"check", "thin.poly", "thin.1.ele", "--min-angle", "20"}).exit_code, 0);
}

TEST_F(TriangleCommand, A_gives_each_triangle_the_attribute_of_its_region) {
  ends_well("pqA", "b");
  const Rows node = table("b.1.node"), ele = table("b.1.ele");
  ASSERT_EQ(ele[0], (std::vector<double>{ele[0][0], 3, 1}));
  for (std::size_t t = 1; t < ele.size(); ++t) {
    double x = 0;
    for (int i = 1; i <= 3; ++i) x += node[static_cast<std::size_t>(ele[t][i]) + 1][1] / 3;
    EXPECT_EQ(ele[t][4], x < 2 ? 5 : 8) << "triangle " << t;
  }
  ends_well("pq", "b");
  EXPECT_EQ(table("b.1.ele")[0][2], 0);
}

TEST_F(TriangleCommand, A_without_regions_gives_the_attribute_0) {
  ends_well("pA", "a");
  EXPECT_EQ(table("a.1.ele")[0][2], 1);
  EXPECT_EQ(table("a.1.ele")[1][4], 0);
}

TEST_F(TriangleCommand, j_drops_the_vertices_that_no_triangle_has) {
  ends_well("p", "b");
  EXPECT_EQ(table("b.1.node")[0][0], 11);
  ends_well("pj", "b");
  EXPECT_EQ(table("b.1.node")[0][0], 10);
  EXPECT_EQ(pardel({"check", "b.poly", "b.1.ele", "--min-angle", "0"}).exit_code, 0);
}

TEST_F(TriangleCommand, O_ignores_holes) {
  ends_well("pO", "b");
  ends_well("p", "a");
  const Rows node = table("b.1.node"), ele = table("b.1.ele");
  double area = 0;
  for (std::size_t t = 1; t < ele.size(); ++t) {
    const auto& a = node[static_cast<std::size_t>(ele[t][1]) + 1];
    const auto& b = node[static_cast<std::size_t>(ele[t][2]) + 1];
    const auto& c = node[static_cast<std::size_t>(ele[t][3]) + 1];
    area += ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
  }
  EXPECT_DOUBLE_EQ(area, 8);
  EXPECT_EQ(table("b.1.poly").size() >= 2, true);
}

TEST_F(TriangleCommand, c_keeps_the_triangles_between_the_outline_and_the_hull) {
  write("corner.poly",
        "6 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 1 1\n5 1 2\n6 0 2\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 1\n0\n");
  ends_well("p", "corner");
  EXPECT_EQ(table("corner.1.ele")[0][0], 4);
  ends_well("pc", "corner");
  EXPECT_EQ(table("corner.1.ele")[0][0], 5);
}

TEST_F(TriangleCommand, c_keeps_the_hull_of_a_domain_that_had_to_be_repaired) {
  // The outline has a notch; points 1 and 7 are equal.
  write("notch.poly",
        "7 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 2 1\n5 0 4\n6 1 1\n7 0 0\n"
        "5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 7\n0\n");
  const auto area = [&](const std::string& switches) {
    const Ran ran = pardel({"triangle", "-Q" + switches, "notch"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    const Rows nodes = table("notch.1.node"), triangles = table("notch.1.ele");
    double sum = 0;
    for (std::size_t t = 1; t < triangles.size(); ++t) {
      const auto corner = [&](std::size_t i) { return nodes[static_cast<std::size_t>(triangles[t][i])]; };
      const auto a = corner(1), b = corner(2), c = corner(3);
      sum += ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
    }
    return sum;
  };
  EXPECT_DOUBLE_EQ(area("p"), 10);
  EXPECT_DOUBLE_EQ(area("pc"), 16);
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

TEST_F(TriangleCommand, S_limits_the_new_points_and_is_no_failure) {
  const Ran ran = pardel({"triangle", "-pqa0.001S10", "a"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"budget"}));
  EXPECT_LE(table("a.1.node")[0][0], 14);
  EXPECT_EQ(pardel({"triangle", "-Qpqa0.001S", "b"}).exit_code, 0);
  EXPECT_EQ(table("b.1.node")[0][0], 11);
}

TEST_F(TriangleCommand, Y_splits_no_segment_of_the_boundary_and_YY_none) {
  ends_well("pqa0.1YY", "b");
  EXPECT_EQ(table("b.1.poly")[1][0], 11);
  ends_well("pqa0.1Y", "b");
  for (const auto& row : table("b.1.node")) {
    const bool inserted = row.size() == 5 && row[0] > 10;
    EXPECT_TRUE(!inserted || (row[2] > 0 && row[2] < 2)) << row[0];
  }
}

TEST_F(TriangleCommand, Q_prints_errors_only) {
  write("d.poly", "6 2 0 0\n1 0 0\n2 1 0\n3 0 0\n4 1 1\n5 0 1\n6 0.5 0.25\n4 0\n1 1 2\n2 2 4\n3 4 5\n4 5 3\n0\n");
  for (const std::string switches : {"-Qp", "-Qpqa0.001S10", "-Qpqa0.001YYC"}) {
    const Ran ran = pardel({"triangle", switches, "d"});
    EXPECT_EQ(ran.exit_code, 0) << switches << ran;
    EXPECT_EQ(ran.out + ran.err, "") << switches;
  }
  const Ran ran = pardel({"triangle", "-Qp", "none"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(holds(ran.err, {"none.poly"}));
}

TEST_F(TriangleCommand, an_outline_that_is_not_closed_is_warned_about_without_Q) {
  write("f.poly",
        "7 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 2 0\n6 3 0\n7 3 1\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n0\n");
  const Ran ran = pardel({"triangle", "-p", "f"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"f.poly: warning: 2 segments, the first of them segment 5, are joined"}));
  EXPECT_EQ(pardel({"triangle", "-Qp", "f"}).err, "");
}

TEST_F(TriangleCommand, C_finds_nothing_wrong_in_a_refined_mesh_with_two_regions_in_one_face) {
  write("e.poly",
        "4 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n2\n1 1 1 5 0.5\n2 3 3 8 0.5\n");
  ends_well("pqAaC", "e");
  for (const auto& row : table("e.1.ele")) EXPECT_TRUE(row.size() == 3 || row[4] == 8) << "the last region counts";
  ends_well("rqa0.1C", "e.1");
  ends_well("rpqa0.05AC", "e.1");
}

TEST_F(TriangleCommand, r_without_p_keeps_the_attributes_of_both_sides_of_a_wall) {
  ends_well("pqA", "b");
  ends_well("rqa0.01C", "b.1");  // without p, no edge separates the regions any more
  const Rows node = table("b.2.node"), ele = table("b.2.ele");
  std::map<double, double> area;
  for (std::size_t t = 1; t < ele.size(); ++t) {
    const auto corner = [&](std::size_t i) { return node[static_cast<std::size_t>(ele[t][i]) + 1]; };
    const auto a = corner(1), b = corner(2), c = corner(3);
    area[ele[t][4]] += ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
  }
  ASSERT_EQ(area.size(), 2U);
  EXPECT_NEAR(area[5], 3, 0.2);
  EXPECT_NEAR(area[8], 4, 0.2);
}

TEST_F(TriangleCommand, r_reads_a_mesh_with_six_nodes_per_triangle) {
  ends_well("po2A", "b");
  ends_well("rpC", "b.1");
  EXPECT_EQ(table("b.2.node")[0][0], 11);
  ends_well("rpqa0.1C", "b.1");
  EXPECT_EQ(pardel({"check", "b.poly", "b.2.ele", "--min-angle", "20", "--max-area", "0.1"}).exit_code, 0);
}

TEST_F(TriangleCommand, regions_are_used_and_written_only_with_A_or_a) {
  const auto sections = [&](const std::string& switches) {
    ends_well(switches, "b");
    const Rows poly = table("b.1.poly");
    return poly.size() - 2 - static_cast<std::size_t>(poly[1][0]);
  };
  EXPECT_EQ(sections("pq"), 2U) << "the number of holes and a hole";
  EXPECT_EQ(sections("pqA"), 5U);
  EXPECT_EQ(sections("pqa"), 5U);
  EXPECT_EQ(sections("pqO"), 2U) << "the hole is written for the next run, although this one ignores it";
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

TEST_F(TriangleCommand, angles_above_33_degrees_are_met_where_refinement_ends) {
  ends_well("pq34C", "b");
  EXPECT_EQ(pardel({"check", "b.poly", "b.1.ele", "--min-angle", "34"}).exit_code, 0);
  ends_well("rpq35a0.1C", "b.1");
}

TEST_F(TriangleCommand, angles_that_refinement_cannot_reach_give_the_mesh_for_33_degrees_and_exit_status_4) {
  write("f.poly", quadrilateral);
  const Ran ran = pardel({"triangle", "-Qpq44C", "f"});
  EXPECT_EQ(ran.exit_code, 4) << ran;
  EXPECT_TRUE(holds(ran.err, {"f: the smallest angle of 44 degrees would need more than", "33 degrees"}));
  const std::string mesh = read("f.1.node");
  ends_well("pq33", "f");
  EXPECT_EQ(mesh.substr(0, mesh.find('#')), read("f.1.node").substr(0, mesh.find('#')));
}

TEST_F(TriangleCommand, S_limits_the_points_for_angles_above_33_degrees) {
  write("f.poly", quadrilateral);
  ends_well("pq44S30", "f");
  EXPECT_EQ(table("f.1.node")[0][0], 34);
}

TEST_F(TriangleCommand, C_checks_the_mesh) {
  const Ran ran = pardel({"triangle", "-pq30C", "b"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"Checked: the mesh is right."}));
  EXPECT_EQ(pardel({"triangle", "-pC", "b"}).exit_code, 0);
  EXPECT_EQ(pardel({"triangle", "-rpqa0.01C", "b.1"}).exit_code, 0);
}

TEST_F(TriangleCommand, duplicate_points_are_warned_about_and_keep_their_numbers) {
  write("d.poly", "6 2 0 0\n1 0 0\n2 1 0\n3 0 0\n4 1 1\n5 0 1\n6 0.5 0.25\n4 0\n1 1 2\n2 2 4\n3 4 5\n4 5 3\n0\n");
  const Ran ran = pardel({"triangle", "-p", "d"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"d.poly: repaired"}));
  const Rows in = table("d.poly"), out = table("d.1.node"), ele = table("d.1.ele");
  EXPECT_EQ(out[0][0], 6);
  for (std::size_t i = 1; i <= 6; ++i) EXPECT_EQ(out[i][1], in[i][1]);
  for (std::size_t t = 1; t < ele.size(); ++t) {
    EXPECT_EQ(std::count(ele[t].begin() + 1, ele[t].end(), 3), 0) << "the twin is no corner";
  }
}

TEST_F(TriangleCommand, crossing_segments_meet_in_a_new_vertex) {
  write("x.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 3\n6 2 4\n0\n");
  const Ran ran = pardel({"triangle", "-Qp", "x"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  const Rows node = table("x.1.node");
  ASSERT_EQ(node[0][0], 5);
  EXPECT_EQ(node[5][1], 0.5);
  EXPECT_EQ(node[5][2], 0.5);
  EXPECT_EQ(table("x.1.ele")[0][0], 4);
}

}  // namespace
}  // namespace pardel::testing
