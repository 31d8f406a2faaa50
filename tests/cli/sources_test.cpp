// pardel mesh and check with --sources, and with --keep.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

class Sources : public Workshop {
 protected:
  Sources() {
    for (const std::string name : {"four_holes.poly", "four_holes.sources"})
      std::filesystem::copy_file(std::filesystem::path(PARDEL_EXAMPLES) / name, folder_ / "work" / name);
    // Two unit squares side by side, with the attributes 1 and 2.
    write(
        "two.poly",
        "6 2 0 0\n0 0 0\n1 1 0\n2 2 0\n3 2 1\n4 1 1\n5 0 1\n7 1\n0 0 1 3\n1 1 2 4\n2 2 3 4\n3 3 4 4\n4 4 5 3\n5 5 0 3\n"
        "6 1 4 0\n0\n2\n0 0.5 0.5 1 -1\n1 1.5 0.5 2 -1\n");
  }
};

TEST_F(Sources, of_four_small_holes_leave_the_rest_coarse) {
  const std::vector<std::string> goal = {"--grading", "0.2", "--max-edge", "10", "--sources", "four_holes.sources"};
  std::vector<std::string> mesh = {"four_holes.poly", "-o", "m.ele", "--check"};
  mesh.insert(mesh.end(), goal.begin(), goal.end());
  const json made = report(mesh);
  EXPECT_LE(made["mesh"]["triangles"], 5'500);
  EXPECT_GE(made["mesh"]["triangles"], 4'000);
  EXPECT_EQ(made["goal"]["sources"], "four_holes.sources");
  mesh.insert(mesh.end(), {"--threads", "1"});
  EXPECT_EQ(report(mesh)["digest"], made["digest"]);
}

TEST_F(Sources, are_judged_by_the_check) {
  ASSERT_EQ(pardel({"mesh", "four_holes.poly", "-o", "m.ele", "--grading", "0.2", "--max-edge", "10"}).exit_code, 0);
  const Ran without = pardel({"check", "four_holes.poly", "m.ele", "--grading", "0.2", "--max-edge", "10"});
  EXPECT_EQ(without.exit_code, 0) << without;
  const Ran with = pardel(
      {"check", "four_holes.poly", "m.ele", "--grading", "0.2", "--max-edge", "10", "--sources", "four_holes.sources"});
  EXPECT_EQ(with.exit_code, 1) << with;
  EXPECT_TRUE(holds(with.out + with.err, {"size exceeded"}));
}

TEST_F(Sources, at_points_apply_there_only) {
  write("p.sources", "point 0.5 0.5 0.02\n");
  const json made = report({"two.poly", "-o", "m.ele", "--grading", "0.5", "--sources", "p.sources", "--check"});
  const json coarse = report({"two.poly", "-o", "n.ele", "--grading", "0.5", "--check"});
  EXPECT_GT(made["mesh"]["triangles"], 5 * coarse["mesh"]["triangles"].get<int>());
  EXPECT_LT(made["mesh"]["triangles"], 1'000) << "0.02 everywhere needs about 10,000";
}

TEST_F(Sources, in_a_region_hold_in_all_of_it_and_grow_outside) {
  write("r.sources", "region 2 0.05\n");
  const json made = report({"two.poly", "-o", "m.ele", "--grading", "1", "--sources", "r.sources", "--check"});
  const json regions = made["mesh"];
  EXPECT_GT(regions["triangles"], 1'000) << "a unit square with edges of 0.05 at most";
  const Ran check = pardel({"check", "two.poly", "m.ele", "--grading", "1", "--sources", "r.sources"});
  EXPECT_EQ(check.exit_code, 0) << check;
  write("other.sources", "region 1 0.05\n");
  const Ran other = pardel({"check", "two.poly", "m.ele", "--grading", "1", "--sources", "other.sources"});
  EXPECT_EQ(other.exit_code, 1) << other;
  write("both.sources", "region 2 0.05\nregion 2 0.1\n");
  EXPECT_EQ(report({"two.poly", "-o", "m.ele", "--grading", "1", "--sources", "both.sources"})["digest"],
            made["digest"])
      << "of two lengths the least counts";
}

TEST_F(Sources, in_a_region_and_a_field_hold_together) {
  write("r.sources", "region 2 0.05\n");
  write("two.sizes", "6\n0 0.05\n1 2\n2 2\n3 2\n4 2\n5 2\n");
  const auto triangles = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"two.poly", "-o", "m.ele", "--grading", "1", "--check"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments)["mesh"]["triangles"].get<int>();
  };
  const int region = triangles({"--sources", "r.sources"}), field = triangles({"--sizes", "two.sizes"});
  EXPECT_GT(triangles({"--sources", "r.sources", "--sizes", "two.sizes"}), std::max(region, field));
}

TEST_F(Sources, in_a_region_leave_a_field_to_the_other_regions) {
  write("r.sources", "region 2 0.05\n");
  write("two.sizes", "6\n0 0.2\n1 0.2\n2 0.2\n3 0.2\n4 0.2\n5 0.2\n");
  EXPECT_GT(report({"two.poly", "-o", "m.ele", "--grading", "1", "--sources", "r.sources", "--sizes",
                    "two.sizes"})["mesh"]["triangles"],
            1'000);
  for (const std::vector<std::string>& rule :
       std::vector<std::vector<std::string>>{{"--sources", "r.sources"}, {"--sizes", "two.sizes"}}) {
    const Ran check = pardel({"check", "two.poly", "m.ele", "--grading", "1", rule[0], rule[1]});
    EXPECT_EQ(check.exit_code, 0) << check;
  }
}

TEST_F(Sources, with_a_marker_are_its_segments_and_its_points) {
  const auto triangles = [&](const std::string& marker_of_point) {
    write("marked.poly", "5 2 0 1\n0 0 0 0\n1 2 0 0\n2 2 2 0\n3 0 2 0\n4 0.5 1 " + marker_of_point +
                             "\n4 1\n0 0 1 0\n1 1 2 3\n2 2 3 0\n3 3 0 0\n0\n");
    return report({"marked.poly", "-o", "m.ele", "--grading", "1", "--sources", "m.sources",
                   "--check"})["mesh"]["triangles"]
        .get<int>();
  };
  write("m.sources", "marker 3 0.02\n");
  const int of_segment = triangles("0"), of_both = triangles("3");
  EXPECT_GT(of_both, of_segment + 50);
}

TEST_F(Sources, that_the_domain_does_not_have_are_named_with_their_line) {
  write("m.sources", "# shore\nmarker 9 1\n");
  Ran ran = pardel({"mesh", "two.poly", "-o", "m.ele", "--grading", "1", "--sources", "m.sources"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.sources:2: no segment and no point of the domain has the marker 9"}));
  write("r.sources", "region 2 1\nregion 2.5 1\n");
  ran = pardel({"mesh", "two.poly", "-o", "m.ele", "--grading", "1", "--sources", "r.sources"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"r.sources:2: no region of the domain has the attribute 2.5"}));
}

TEST_F(Sources, need_a_limit_on_growth) {
  const Ran ran = pardel({"mesh", "two.poly", "-o", "m.ele", "--sources", "m.sources"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"--sources", "--grading"}));
}

TEST_F(Sources, are_no_file_that_an_output_may_replace) {
  const Ran ran =
      pardel({"mesh", "two.poly", "-o", "four_holes.node", "--grading", "1", "--sources", "four_holes.node"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
}

TEST_F(Sources, go_together_with_a_repair) {
  write("twice.poly", "5 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0 0\n4 1\n0 0 1 5\n1 1 2 6\n2 2 3 6\n3 3 4 6\n0\n");
  write("m.sources", "marker 5 0.05\n");
  EXPECT_EQ(
      pardel({"mesh", "twice.poly", "-o", "m.ele", "--repair", "--grading", "1", "--sources", "m.sources", "--check"})
          .exit_code,
      0);
}

using Keep = Sources;

TEST_F(Keep, splits_no_segment_with_the_marker) {
  const json made = report({"two.poly", "-o", "m.node", "--keep", "3", "--max-area", "0.05", "--check"}, 4);
  EXPECT_EQ(made["goal"]["kept_markers"], json({3}));
  EXPECT_GT(made["refine"]["exemptions"].size(), 0U);
  for (const json& each : made["refine"]["exemptions"]) EXPECT_EQ(each["reason"], "kept_segment");
  int kept = 0;
  std::istringstream lines(read("m.poly"));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    int number = 0, a = 0, b = 0, marker = 0;
    std::istringstream fields(line);
    if (fields >> number >> a >> b >> marker && marker == 3) ++kept;
  }
  EXPECT_EQ(kept, 3);
}

TEST_F(Keep, of_the_boundary_marker_keeps_segments_without_a_marker_on_the_boundary) {
  write("plain.poly", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  EXPECT_EQ(report({"plain.poly", "-o", "m.ele", "--keep", "1", "--max-area", "0.05"}, 4)["mesh"]["vertices"], 5)
      << "the corners and a point inside";
}

TEST_F(Keep, of_a_marker_that_no_segment_has_is_refused) {
  const Ran ran = pardel({"mesh", "two.poly", "-o", "m.ele", "--keep", "3,77"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"two.poly: --keep: no segment of the domain has the marker 77"})) << ran.err;
}

TEST_F(Keep, of_a_marker_that_no_segment_of_a_mesh_has_is_refused) {
  ASSERT_EQ(pardel({"mesh", "two.poly", "-o", "m.node", "-o", "m.msh", "-o", "m.vtu"}).exit_code, 0);
  for (const std::string mesh : {"m.node", "m.msh", "m.vtu"}) {
    const Ran ran = pardel({"mesh", mesh, "--refine", "-o", "none.ele", "--keep", "3,77"});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_EQ(ran.err, "pardel: " + mesh + ": --keep: no segment of the domain has the marker 77\n");
    EXPECT_FALSE(exists("none.ele"));
    const json made = report({mesh, "--refine", "-o", "r.ele", "--keep", "3,4", "--max-area", "0.05"}, 4);
    EXPECT_GT(made["refine"]["exemptions"].size(), 0U) << mesh;
  }
}

TEST_F(Keep, of_the_boundary_marker_keeps_the_boundary_of_a_mesh_that_has_no_segments_there) {
  write("m.node", "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n");
  write("m.ele", "2 3 0\n0 0 1 2\n1 0 2 3\n");
  write("m.poly", "0 2 0 0\n3 1\n0 0 1 5\n1 1 2 5\n2 2 3 5\n0\n");
  const json made = report({"m.ele", "--refine", "-o", "r.ele", "--keep", "1,5", "--max-area", "0.05"}, 4);
  EXPECT_EQ(made["refine"]["segment_splits"], 0);
  write("m.poly", "0 2 0 0\n4 1\n0 0 1 5\n1 1 2 5\n2 2 3 5\n3 3 0 5\n0\n");
  const Ran ran = pardel({"mesh", "m.ele", "--refine", "-o", "r.ele", "--keep", "1,5"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.ele: --keep: no segment of the domain has the marker 1"})) << ran.err;
}

TEST_F(Keep, refuses_a_repair_that_moves_kept_points) {
  write("near.poly",
        "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.99 0\n5 1\n1 1 5 3\n2 5 2 3\n3 2 3 3\n4 3 4 3\n5 4 1 3\n0\n");
  const Ran refused = pardel({"mesh", "near.poly", "-o", "m.ele", "--keep", "3", "--repair", "--snap", "0.02"});
  EXPECT_EQ(refused.exit_code, 3) << refused;
  EXPECT_TRUE(holds(refused.err, {"near.poly: --repair would move point ", "--keep 3 keeps"})) << refused.err;
}

TEST_F(Keep, needs_whole_numbers_at_least_one) {
  for (const std::string markers : {"1,x", "", ","}) {
    const Ran ran = pardel({"mesh", "two.poly", "-o", "m.ele", "--keep", markers});
    EXPECT_EQ(ran.exit_code, 2) << markers << ran;
    EXPECT_TRUE(holds(ran.err, {"--keep"})) << ran;
  }
}

}  // namespace
}  // namespace pardel::testing
