// pardel triangle takes the domain that Triangle takes: regions, holes, the convex hull, and input to be repaired.
#include <algorithm>
#include <string>
#include <vector>

#include "triangle_command.hpp"

namespace pardel::testing {
namespace {

TEST_F(TriangleCommand, without_p_the_convex_hull_of_the_points_is_triangulated) {
  write("c.node", "5 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 2\n");
  ends_well("", "c");
  EXPECT_EQ(files(), (Files{"a.poly", "b.poly", "c.node", "c.1.node", "c.1.ele"}));
  EXPECT_EQ(table("c.1.ele")[0][0], 4);
  EXPECT_EQ(table("c.1.node")[0][0], 5);
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

TEST_F(TriangleCommand, an_open_outline_is_refused_with_advice_that_names_the_switch_c) {
  write("f.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n");
  const Ran ran = pardel({"triangle", "-pq", "f"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"f.poly: No outline is closed", "the switch c meshes the convex hull"}));
  EXPECT_EQ(ran.err.find("--"), std::string::npos) << "no option of another command";
  EXPECT_EQ(pardel({"triangle", "-pqc", "f"}).exit_code, 0);
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

TEST_F(TriangleCommand, duplicate_points_keep_their_attributes_and_markers) {
  write("d.poly",
        "5 2 2 1\n1 0 0 7 70 3\n2 1 0 8 80 0\n3 0 0 9 90 -4\n4 1 1 1 10 5\n5 0 1 2 20 0\n"
        "4 0\n1 1 2\n2 2 4\n3 4 5\n4 5 3\n0\n");
  ASSERT_EQ(pardel({"triangle", "-Qp", "d"}).exit_code, 0);
  const Rows out = table("d.1.node");
  ASSERT_EQ(out[0], (std::vector<double>{5, 2, 2, 1}));
  EXPECT_EQ(out[1], (std::vector<double>{1, 0, 0, 7, 70, 3}));
  EXPECT_EQ(out[3], (std::vector<double>{3, 0, 0, 9, 90, -4}));
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
