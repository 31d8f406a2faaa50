// pardel triangle meets the bounds of Triangle's switches, in new meshes and in meshes that it refines.
#include <map>
#include <string>
#include <vector>

#include "triangle_command.hpp"

namespace pardel::testing {
namespace {

/// No mesh with angles of 44 degrees is found for it.
constexpr const char* quadrilateral = "4 2 0 0\n1 0 0\n2 5 0.3\n3 4 4.1\n4 1 3\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";

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

/// A wedge of 2.9 degrees in a square.
constexpr const char* wedge =
    "7 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 2 1\n7 2 1.05\n"
    "6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 5 7\n0\n";

TEST_F(TriangleCommand, a_second_run_with_the_same_goal_changes_nothing_at_small_angles) {
  for (const char* switches : {"pq30", "pq20D", "pq25a0.1"}) {
    write("w.poly", wedge);
    ends_well(switches, "w");
    ends_well(std::string("rC") + switches, "w.1");
    EXPECT_EQ(table("w.2.node"), table("w.1.node")) << switches;
    EXPECT_EQ(table("w.2.ele"), table("w.1.ele")) << switches;
  }
  ends_well("rpq33a0.05", "w.2");
  ends_well("rCpq33a0.05", "w.3");
  EXPECT_GT(table("w.3.ele").size(), table("w.2.ele").size());
  EXPECT_EQ(table("w.4.ele"), table("w.3.ele"));
}

TEST_F(TriangleCommand, mesh_refines_its_own_mesh_with_the_same_goal_to_the_same_mesh_in_every_format) {
  write("w.poly", wedge);
  for (const std::string file : {"1.vtu", "1.msh", "1.off", "1.node"}) {
    EXPECT_EQ(pardel({"mesh", "w.poly", "-o", file, "--min-angle", "30"}).exit_code, 0);
    EXPECT_EQ(pardel({"mesh", file, "--refine", "-o", "2.vtu", "--min-angle", "30", "--check"}).exit_code, 0) << file;
    EXPECT_EQ(read("2.vtu"), read("1.vtu")) << file;
  }
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

}  // namespace
}  // namespace pardel::testing
