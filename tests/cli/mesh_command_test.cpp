// pardel mesh: its files, its summary and its report, for goals that can be met and for goals that cannot.
#include <omp.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

class MeshCommand : public Workshop {
 protected:
  MeshCommand() {
    write("square.poly", square_poly);
    for (const std::string name : {"key.poly", "pipe.poly"}) {
      std::filesystem::copy_file(std::filesystem::path(PARDEL_EXAMPLES) / name, folder_ / "work" / name);
    }
  }

  bool certified(const std::string& domain, const std::string& mesh, std::vector<std::string> goal) const {
    goal.insert(goal.begin(), {"check", domain, mesh});
    const Ran ran = pardel(goal);
    EXPECT_EQ(ran.exit_code, 0) << ran;
    return ran.exit_code == 0;
  }
};

TEST_F(MeshCommand, every_format_is_written_in_one_run_and_certified) {
  const Ran ran = pardel({"mesh", "key.poly", "-o", "m.node", "-o", "m.vtu", "-o", "m.msh", "-o", "m.off", "-o",
                          "m.svg", "--min-angle", "30"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(files(), (Files{"square.poly", "key.poly", "pipe.poly", "m.node", "m.ele", "m.poly", "m.vtu", "m.msh",
                            "m.off", "m.svg"}));
  for (const std::string mesh : {"m.node", "m.ele", "m.vtu", "m.msh", "m.off"}) {
    EXPECT_TRUE(certified("key.poly", mesh, {"--min-angle", "30"})) << mesh;
  }
}

TEST_F(MeshCommand, a_note_names_the_formats_that_cannot_store_attributes_of_points) {
  write("heights.node", "4 2 1 0\n1 0 0 5\n2 1 0 6\n3 1 1 7\n4 0 1 8\n");
  const Ran ran = pardel({"mesh", "heights.node", "-o", "m.node", "-o", "m.msh", "-o", "m.vtu", "-o", "m.off"});
  EXPECT_EQ(ran.err,
            "pardel: m.msh: note: .msh cannot store: attributes of points\n"
            "pardel: m.off: note: .off cannot store: attributes of points\n");
  EXPECT_EQ(pardel({"mesh", "key.poly", "-o", "m.msh"}).err, "");
}

TEST_F(MeshCommand, the_summary_lists_vertices_triangles_the_smallest_angle_and_the_time) {
  const Ran ran = pardel({"mesh", "key.poly", "-o", "m.vtu"});
  EXPECT_TRUE(holds(ran.out, {"key.poly", " vertices", " triangles", "angles ", "time", "m.vtu"}));
  EXPECT_EQ(ran.err, "");
}

TEST_F(MeshCommand, an_angle_that_only_pardel_triangle_tries_is_refused_with_this_advice) {
  const std::string advice = "'pardel triangle' tries it";
  const auto refused = [&](const std::string& angle) {
    const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "--min-angle", angle});
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"'" + angle + "' is not an angle from 0 to 33 degrees"})) << ran;
    return ran.err;
  };
  EXPECT_TRUE(holds(refused("40"), {advice}));
  for (const char* angle : {"46", "-5", "nan", "wide"})
    EXPECT_EQ(refused(angle).find(advice), std::string::npos) << angle;
}

TEST_F(MeshCommand, quiet_prints_nothing) {
  const Ran ran = pardel({"mesh", "key.poly", "-o", "m.vtu", "-q"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out + ran.err, "");
}

TEST_F(MeshCommand, names_may_contain_spaces_and_letters_outside_ASCII) {
  write("my square é.poly", square_poly);
  const Ran ran = pardel({"mesh", "my square é.poly", "-o", "my mesh é.node", "-o", "my mesh.vtu"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(exists("my mesh é.ele"));
  EXPECT_TRUE(exists("my mesh.vtu"));
}

TEST_F(MeshCommand, points_without_segments_are_meshed_in_their_convex_hull) {
  write("cloud.node", "5 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0.3 0.4\n");
  const json r = report({"cloud.node", "-o", "m.vtu"});
  EXPECT_DOUBLE_EQ(r["mesh"]["area"], 1.0);
  EXPECT_GE(r["mesh"]["min_angle_deg"], 20.7);
}

TEST_F(MeshCommand, the_report_has_every_key_of_its_schema) {
  const json r = report({"key.poly", "-o", "m.vtu", "--min-angle", "25", "--max-area", "0.01"});
  ASSERT_TRUE(r.is_object());
  EXPECT_EQ(r["schema"], "pardel.report/1");
  const std::map<std::string, std::vector<std::string>> keys = {
      {"input", {"points", "segments", "holes", "regions"}},
      {"goal", {"min_angle_deg", "max_area", "max_edge"}},
      {"decomposition", {"kind"}},
      {"seconds", {"read", "validate", "triangulate", "refine", "check", "write", "statistics", "total"}},
      {"mesh", {"vertices", "triangles", "min_angle_deg", "max_angle_deg", "max_circumradius", "area"}},
      {"refine", {"inserted", "segment_splits", "refused", "exempt", "exemptions"}}};
  for (const auto& [object, members] : keys) {
    ASSERT_TRUE(r.contains(object)) << object;
    for (const std::string& member : members) EXPECT_TRUE(r[object].contains(member)) << object << '.' << member;
  }
  EXPECT_EQ(r["threads"], omp_get_max_threads());
  EXPECT_GT(r["peak_rss_bytes"], 1'000'000);
  EXPECT_EQ(r["digest"].get<std::string>().size(), 32U);
  EXPECT_EQ(r["goal"]["min_angle_deg"], 25.0);
  EXPECT_EQ(r["goal"]["max_area"], 0.01);
  EXPECT_TRUE(r["goal"]["max_edge"].is_null());
}

TEST_F(MeshCommand, the_times_of_the_stages_add_up_to_nearly_the_total) {
  json seconds = report({"square.poly", "-o", "m.vtu", "--max-area", "0.00001", "--check"})["seconds"];
  const double total = seconds["total"];
  seconds.erase("total");
  double sum = 0;
  for (const json& stage : seconds) sum += stage.get<double>();
  EXPECT_LE(sum, total);
  EXPECT_GT(sum, 0.8 * total);
}

TEST_F(MeshCommand, the_report_agrees_with_the_files) {
  const json r = report({"key.poly", "-o", "m.node", "--min-angle", "30"});
  const auto nodes = table("m.node");
  const auto elements = table("m.ele");
  EXPECT_EQ(r["mesh"]["vertices"], nodes.size() - 1);
  EXPECT_EQ(r["mesh"]["triangles"], elements.size() - 1);
  EXPECT_EQ(r["mesh"]["vertices"].get<int>(), r["input"]["points"].get<int>() + r["refine"]["inserted"].get<int>() +
                                                  r["refine"]["segment_splits"].get<int>());
}

TEST_F(MeshCommand, the_report_can_be_written_to_a_file) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "--json", "report.json"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(holds(ran.out, {"square.poly"}));
  EXPECT_EQ(json::parse(read("report.json"))["input"]["segments"], 4);
}

TEST_F(MeshCommand, the_same_input_gives_the_same_digest_and_another_goal_another) {
  const json first = report({"key.poly", "-o", "a.vtu", "--min-angle", "30"});
  const json second = report({"key.poly", "-o", "b.vtu", "--min-angle", "30"});
  const json other = report({"key.poly", "-o", "c.vtu", "--min-angle", "25"});
  EXPECT_EQ(first["digest"], second["digest"]);
  EXPECT_EQ(read("a.vtu"), read("b.vtu"));
  EXPECT_NE(first["digest"], other["digest"]);
}

TEST_F(MeshCommand, bounds_on_angle_area_and_edge_are_met_together) {
  const json r =
      report({"pipe.poly", "-o", "m.node", "--min-angle", "30", "--max-area", "0.002", "--max-edge", "0.06"});
  EXPECT_GE(r["mesh"]["min_angle_deg"], 30.0);
  EXPECT_TRUE(certified("pipe.poly", "m.node", {"--min-angle", "30", "--max-area", "0.002", "--max-edge", "0.06"}));
}

TEST_F(MeshCommand, a_ratio_is_another_way_to_give_the_angle) {
  EXPECT_NEAR(report({"square.poly", "-o", "m.vtu", "--rho", "1"})["goal"]["min_angle_deg"], 30.0, 1e-9);
}

TEST_F(MeshCommand, caps_of_regions_apply_only_with_the_option_regions) {
  ASSERT_EQ(pardel({"generate", "regions", "-o", "regions.poly"}).exit_code, 0);
  const json without = report({"regions.poly", "-o", "a.node"});
  const json with = report({"regions.poly", "-o", "b.node", "--regions"});
  EXPECT_FALSE(without["goal"]["region_caps"]);
  EXPECT_TRUE(with["goal"]["region_caps"]);
  EXPECT_GT(with["mesh"]["triangles"], without["mesh"]["triangles"]);
  EXPECT_TRUE(certified("regions.poly", "b.node", {"--regions"}));
  EXPECT_EQ(pardel({"check", "regions.poly", "a.node", "--regions"}).exit_code, 1);
}

TEST_F(MeshCommand, the_summary_mentions_area_caps_of_regions_that_are_ignored) {
  ASSERT_EQ(pardel({"generate", "regions", "-o", "regions.poly"}).exit_code, 0);
  EXPECT_TRUE(holds(pardel({"mesh", "regions.poly", "-o", "a.vtu"}).out, {"area caps", "--regions"}));
  EXPECT_FALSE(holds(pardel({"mesh", "regions.poly", "-o", "a.vtu", "--regions"}).out, {"area caps"}));
}

TEST_F(MeshCommand, the_summary_names_every_file_that_was_written) {
  EXPECT_TRUE(holds(pardel({"mesh", "key.poly", "-o", "m.ele", "-o", "m.vtu"}).out,
                    {"wrote   m.node, m.ele, m.poly\n", "wrote   m.vtu\n"}));
}

TEST_F(MeshCommand, the_report_names_the_decomposition_that_was_chosen) {
  const auto kind_of = [&](std::vector<std::string> arguments) {
    return report(std::move(arguments))["decomposition"]["kind"].get<std::string>();
  };
  EXPECT_EQ(kind_of({"square.poly", "-o", "m.node"}), "lattice");
  EXPECT_EQ(kind_of({"square.poly", "-o", "m.node", "--decomposition", "quadtree"}), "quadtree");
  ASSERT_EQ(pardel({"generate", "radial", "-n", "3", "-o", "r.poly", "--sizes", "r.area"}).exit_code, 0);
  EXPECT_EQ(kind_of({"r.poly", "-o", "m.node", "--sizes", "r.area"}), "quadtree");
}

TEST_F(MeshCommand, tiles_of_fewer_triangles_are_more_tiles) {
  for (const std::string kind : {"lattice", "quadtree"}) {
    const auto cells = [&](const char* triangles) {
      const json r = report({"square.poly", "-o", "m.node", "--max-area", "2e-4", "--interior", "refine",
                             "--decomposition", kind, "--triangles-per-tile", triangles, "--check"});
      EXPECT_TRUE(r["certificate"]["valid"]);
      return r["decomposition"]["cells"].get<int>();
    };
    EXPECT_EQ(cells("100000"), 1) << kind;
    EXPECT_GE(cells("100"), 16) << kind;
  }
  for (const char* wrong : {"0", "-1", "nan"})
    EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "m.node", "--triangles-per-tile", wrong}).exit_code, 2) << wrong;
}

TEST_F(MeshCommand, sizes_at_the_points_grade_the_mesh) {
  write("fine.sizes", "4\n1 0.02\n2 0.5\n3 0.5\n4 0.5\n");
  const json r = report({"square.poly", "-o", "m.node", "--sizes", "fine.sizes", "--check"});
  EXPECT_EQ(r["goal"]["sizes"], "fine.sizes");
  EXPECT_TRUE(r["certificate"]["valid"]);
  int near = 0, far = 0;
  const auto nodes = table("m.node");
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    near += nodes[i][1] < 0.25 && nodes[i][2] < 0.25;
    far += nodes[i][1] > 0.75 && nodes[i][2] > 0.75;
  }
  EXPECT_GT(near, 4 * far);
}

TEST_F(MeshCommand, the_feature_size_asks_for_edges_across_narrow_places) {
  const json coarse = report({"key.poly", "-o", "m.node", "--feature-size", "1", "--check"});
  EXPECT_EQ(coarse["goal"]["feature_size"], 1);
  EXPECT_EQ(coarse["goal"]["grading"], nullptr);
  EXPECT_TRUE(coarse["certificate"]["valid"]);
  const Ran refused = pardel({"check", "key.poly", "m.node", "--feature-size", "4"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(holds(refused.out, {"size exceeded: ", "is above the size at its centroid", "4 edges per feature size"}))
      << refused.out;
  const json dense = report({"key.poly", "-o", "m.node", "--feature-size", "4", "--check"});
  EXPECT_TRUE(dense["certificate"]["valid"]);
  EXPECT_EQ(dense["certificate"]["goal"]["feature_edges"], 4);
  EXPECT_GT(dense["mesh"]["triangles"], 4 * coarse["mesh"]["triangles"].get<int>());
  EXPECT_TRUE(certified("key.poly", "m.node", {"--feature-size", "4"}));
}

TEST_F(MeshCommand, grading_limits_how_fast_lengths_grow) {
  write("fine.sizes", "4\n1 0.02\n2 0.5\n3 0.5\n4 0.5\n");
  write("fine.asc",
        "ncols 20\nnrows 1\nxllcorner 0\nyllcorner 0\ndx 0.05\ndy 1\n0.02 0.02 0.02 0.02 0.02 0.02 "
        "0.02 0.02 0.02 0.02 0.9 0.9 0.9 0.9 0.9 0.9 0.9 0.9 0.9 0.9\n");
  write("fine.node", "5 2 1 0\n1 0 0 0.5\n2 1 0 0.5\n3 1 1 0.5\n4 0 1 0.5\n5 0.5 0.5 0.01\n");
  write("fine.ele", "4 3 0\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 5\n");
  for (const std::string field : {"fine.sizes", "fine.asc", "fine.node"}) {
    SCOPED_TRACE(field);
    const json steep = report({"square.poly", "-o", "m.node", "--sizes", field, "--check"});
    EXPECT_EQ(pardel({"check", "square.poly", "m.node", "--sizes", field, "--grading", "0.05"}).exit_code, 1);
    const json r = report({"square.poly", "-o", "m.node", "--sizes", field, "--grading", "0.05", "--check"});
    EXPECT_EQ(r["goal"]["grading"], 0.05);
    EXPECT_TRUE(r["certificate"]["valid"]);
    EXPECT_GT(r["mesh"]["triangles"], steep["mesh"]["triangles"]);
    EXPECT_TRUE(certified("square.poly", "m.node", {"--sizes", field, "--grading", "0.05"}));
  }
}

TEST_F(MeshCommand, a_raster_of_sizes_grades_the_mesh) {
  write("field.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ndx 0.5\ndy 1\n0.02 0.3\n");
  const json r = report({"square.poly", "-o", "m.node", "--sizes", "field.asc", "--check"});
  EXPECT_EQ(r["goal"]["sizes"], "field.asc");
  EXPECT_TRUE(r["certificate"]["valid"]);
  EXPECT_TRUE(certified("square.poly", "m.node", {"--sizes", "field.asc"}));
  int left = 0, right = 0;
  const auto nodes = table("m.node");
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    left += nodes[i][1] < 0.25;
    right += nodes[i][1] > 0.75;
  }
  EXPECT_GT(left, 20 * right);
}

TEST_F(MeshCommand, sizes_at_the_points_of_a_mesh_grade_the_mesh) {
  write("field.node", "4 2 1 0\n1 0 0 0.02\n2 1 0 0.3\n3 1 1 0.3\n4 0 1 0.02\n");
  write("field.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  ASSERT_EQ(pardel({"convert", "field.node", "field.vtu"}).exit_code, 0);
  write("field.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
        "$Elements\n2\n1 2 0 1 2 3\n2 2 0 1 3 4\n$EndElements\n"
        "$NodeData\n1\n\"size\"\n1\n0.0\n3\n0\n1\n4\n1 0.02\n2 0.3\n3 0.3\n4 0.02\n$EndNodeData\n");
  std::vector<json> digests;
  for (const std::string field : {"field.node", "field.vtu", "field.msh"}) {
    const json r = report({"square.poly", "-o", "m.node", "--sizes", field, "--check"});
    EXPECT_TRUE(r["certificate"]["valid"]) << field;
    EXPECT_GT(r["mesh"]["triangles"], 500) << field;
    digests.push_back(r["digest"]);
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_EQ(digests[0], digests[2]);
}

TEST_F(MeshCommand, the_first_of_several_attributes_of_a_mesh_has_the_sizes) {
  write("one.node", "4 2 1 0\n1 0 0 0.02\n2 1 0 0.3\n3 1 1 0.4\n4 0 1 0.02\n");
  write("two.node", "4 2 2 0\n1 0 0 0.02 9\n2 1 0 0.3 0.01\n3 1 1 0.4 8\n4 0 1 0.02 7\n");
  write("one.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  write("two.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  const json one = report({"square.poly", "-o", "m.node", "--sizes", "one.node"});
  EXPECT_GT(one["mesh"]["triangles"], 500);
  EXPECT_EQ(one["digest"], report({"square.poly", "-o", "m.node", "--sizes", "two.node"})["digest"]);
}

TEST_F(MeshCommand, a_raster_of_sizes_serves_a_repaired_domain_and_a_refined_mesh) {
  write("field.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n0.2\n");
  write("twice.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n0\n");
  EXPECT_EQ(pardel({"mesh", "twice.poly", "-o", "t.vtu", "--repair", "--sizes", "field.asc", "--check"}).exit_code, 0);
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "coarse.node"}).exit_code, 0);
  EXPECT_EQ(pardel({"mesh", "coarse.node", "--refine", "-o", "f.vtu", "--sizes", "field.asc", "--check"}).exit_code, 0);
}

TEST_F(MeshCommand, a_check_is_part_of_the_report) {
  const json r = report({"key.poly", "-o", "m.vtu", "--min-angle", "30", "--check"});
  EXPECT_TRUE(r["certificate"]["valid"]);
  EXPECT_GT(r["seconds"]["check"], 0.0);
  EXPECT_FALSE(report({"key.poly", "-o", "m.vtu"}).contains("certificate"));
}

TEST_F(MeshCommand, a_budget_that_is_too_small_gives_code_4_the_mesh_and_the_list) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "--max-area", "0.001", "--max-vertices", "50"});
  EXPECT_EQ(ran.exit_code, 4) << ran;
  EXPECT_TRUE(holds(ran.err, {"square.poly", "budget", "triangle ("}));
  EXPECT_TRUE(certified("square.poly", "m.vtu", {"--min-angle", "0"}));
}

TEST_F(MeshCommand, a_budget_that_is_too_small_gives_code_4_with_a_check_too) {
  const json r = report({"square.poly", "-o", "m.vtu", "--max-area", "0.001", "--max-vertices", "50", "--check"}, 4);
  EXPECT_LE(r["mesh"]["vertices"], 50);
  EXPECT_FALSE(r["goal_met"]);
  EXPECT_FALSE(r["certificate"]["valid"]);
  EXPECT_GT(r["refine"]["exempt"]["budget"], 0);
}

TEST_F(MeshCommand, a_limit_on_edges_gives_code_4_where_it_prevents_a_bound) {
  const json r = report({"square.poly", "-o", "m.vtu", "--max-area", "0.0001", "--min-edge", "0.1"}, 4);
  EXPECT_GT(r["refine"]["exempt"]["min_edge"], 0);
}

TEST_F(MeshCommand, a_conforming_goal_that_is_missed_gives_code_4_with_a_check_too) {
  write("rhombus.poly", "4 2 0 0\n1 0 0\n2 5 -1\n3 10 0\n4 5 1\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 3\n0\n");
  const json r =
      report({"rhombus.poly", "-o", "m.vtu", "--conforming", "--min-angle", "0", "--min-edge", "20", "--check"}, 4);
  EXPECT_EQ(r["certificate"]["violation_counts"], (json{{"not_conforming", 1}}));
}

TEST_F(MeshCommand, small_input_angles_are_exempt_and_reported_with_code_0) {
  write("needle.poly", "3 2 0 0\n1 0 0\n2 10 0\n3 10 0.5\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  const json r = report({"needle.poly", "-o", "m.vtu", "--check"});
  EXPECT_TRUE(r["goal_met"]);
  EXPECT_GT(r["refine"]["exempt"]["nestled"].get<int>() + r["refine"]["exempt"]["seditious"].get<int>(), 0);
  EXPECT_TRUE(holds(pardel({"mesh", "needle.poly", "-o", "m.vtu"}).out, {"exempt"}));
}

TEST_F(MeshCommand, every_exempt_triangle_is_in_the_report_with_its_small_input_angle) {
  write("needle.poly", "3 2 0 0\n1 10 0\n2 10 0.5\n3 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  const json r = report({"needle.poly", "-o", "m.node"});
  const json& exemptions = r["refine"]["exemptions"];
  int counted = 0;
  for (const json& count : r["refine"]["exempt"]) counted += count.get<int>();
  ASSERT_GT(counted, 0);
  ASSERT_EQ(exemptions.size(), counted);
  for (const json& exemption : exemptions) {
    EXPECT_LT(exemption["triangle"], r["mesh"]["triangles"]);
    EXPECT_EQ(exemption["apex"], 2);  // point 3 of the file
    EXPECT_NEAR(exemption["input_angle_deg"], std::atan2(0.5, 10) * 180 / std::acos(-1), 1e-9);
    EXPECT_TRUE(exemption["reason"] == "nestled" || exemption["reason"] == "seditious") << exemption;
  }
}

TEST_F(MeshCommand, ten_triangles_that_miss_the_goal_are_printed_and_all_are_in_the_report) {
  const std::vector<std::string> budget = {"square.poly", "-o", "m.vtu", "--max-area", "0.001", "--max-vertices", "50"};
  const json exemptions = report(budget, 4)["refine"]["exemptions"];
  ASSERT_GT(exemptions.size(), 10U);
  EXPECT_TRUE(exemptions[0]["apex"].is_null());
  EXPECT_TRUE(exemptions[0]["input_angle_deg"].is_null());

  std::vector<std::string> arguments = budget;
  arguments.insert(arguments.begin(), "mesh");
  const Ran ran = pardel(arguments);
  int listed = 0;
  for (auto at = ran.err.find("triangle ("); at != std::string::npos; at = ran.err.find("triangle (", at + 1)) ++listed;
  EXPECT_EQ(listed, 10) << ran;
  EXPECT_TRUE(holds(ran.err, {"... and " + std::to_string(exemptions.size() - 10) + " more (all in --json)"}));
}

TEST_F(MeshCommand, one_tile_gives_a_mesh_as_good_as_many_tiles) {
  const json none = report({"key.poly", "-o", "m.node", "--decomposition", "none", "--max-area", "0.0005", "--check"});
  EXPECT_EQ(none["decomposition"]["kind"], "none");
  EXPECT_TRUE(none["certificate"]["valid"]);
  EXPECT_EQ(pardel({"mesh", "key.poly", "-o", "m.node", "--decomposition", "some"}).exit_code, 2);
}

TEST_F(MeshCommand, msh_files_are_binary_without_the_option_msh_ascii) {
  const json binary = report({"key.poly", "-o", "binary.msh"});
  const json text = report({"key.poly", "-o", "text.msh", "--msh-ascii"});
  EXPECT_TRUE(read("binary.msh").starts_with("$MeshFormat\n4.1 1 8"));
  EXPECT_TRUE(read("text.msh").starts_with("$MeshFormat\n4.1 0 8"));
  EXPECT_EQ(binary["digest"], text["digest"]);
  EXPECT_TRUE(certified("key.poly", "text.msh", {}));
}

TEST_F(MeshCommand, an_invalid_domain_is_repaired_on_request) {
  write("crossed.poly",
        "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 1 1\n6 0.5 0\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 5\n6 2 4\n0\n");
  EXPECT_EQ(pardel({"mesh", "crossed.poly", "-o", "m.vtu"}).exit_code, 3);
  const Ran ran = pardel({"mesh", "crossed.poly", "-o", "m.vtu", "--repair", "--check"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"crossed.poly: repaired"}));
}

TEST_F(MeshCommand, a_repair_that_leaves_no_domain_is_an_error_and_not_a_mesh_of_the_original) {
  write("square.poly", square_poly);
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "--repair", "--snap", "10"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_EQ(ran.err, pardel({"doctor", "square.poly", "--repair", "fixed.poly", "--snap", "10", "-q"}).err);
  EXPECT_TRUE(holds(ran.err, {"pardel: square.poly: "}));
  EXPECT_FALSE(exists("m.vtu"));
}

TEST_F(MeshCommand, warns_before_the_refinement_of_a_mesh_with_very_many_triangles) {
  write("plate.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1e-9\n4 0 1e-9\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const std::string warning = "plate.poly: warning: The domain is only 1e-09 wide at (0.125, 0).";
  const Ran stopped = pardel({"mesh", "plate.poly", "-o", "m.vtu", "--progress", "always"},
                             {.interrupt_when = "million. --max-vertices limits their number"});
  EXPECT_EQ(stopped.exit_code, 130) << stopped;
  EXPECT_TRUE(
      holds(stopped.err, {warning, "needs at least 377.9 million triangles, and usually has about 831.3 million."}));
  write("wider.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1e-8\n4 0 1e-8\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Ran wider = pardel({"mesh", "wider.poly", "-o", "m.vtu", "--progress", "always"},
                           {.interrupt_when = "million. --max-vertices limits their number"});
  EXPECT_TRUE(holds(wider.err, {"needs at least 37.8 million triangles, and usually has about 83.1 million."}));
  for (const std::vector<std::string>& bound : {std::vector<std::string>{"--grading", "0.3"}, {"--feature-size", "2"}})
    for (const std::string domain : {"wider.poly", "plate.poly"}) {
      const Ran graded = pardel({"mesh", domain, "-o", "m.vtu", bound[0], bound[1], "--progress", "always"},
                                {.interrupt_when = "--max-vertices limits their number"});
      EXPECT_EQ(graded.exit_code, 130) << graded;
      EXPECT_TRUE(holds(graded.err, {domain + ": warning: The domain is only 1e-0",
                                     "With these bounds on sizes, the mesh will have about ", "'pardel doctor' lists"}))
          << graded;
    }
  const Ran limited = pardel({"mesh", "plate.poly", "-o", "m.vtu", "--max-vertices", "1000"});
  EXPECT_EQ(limited.exit_code, 4) << limited;
  EXPECT_EQ(limited.err.find("million"), std::string::npos) << limited;
  const Ran none = pardel({"mesh", "plate.poly", "-o", "m.vtu", "--min-angle", "0"});
  EXPECT_EQ(none.exit_code, 0) << none;
  EXPECT_EQ(none.err.find("million"), std::string::npos) << none;
}

TEST_F(MeshCommand, a_byte_order_mark_at_the_beginning_of_a_file_is_skipped) {
  const std::string mark = "\xEF\xBB\xBF";
  write("square.poly", square_poly);
  const std::string formats[] = {"off", "vtu", "msh", "node"};
  std::vector<std::string> make = {"mesh", "square.poly", "--msh-ascii"};
  for (const std::string& format : formats) make.insert(make.end(), {"-o", "m." + format});
  ASSERT_EQ(pardel(make).exit_code, 0);
  for (const std::string name : {"square.poly", "m.node", "m.ele", "m.poly", "m.off", "m.vtu", "m.msh"})
    write(name, mark + read(name));
  for (const std::string& format : formats) {
    const Ran ran = pardel({"check", "square.poly", "m." + format});
    EXPECT_EQ(ran.exit_code, 0) << ran;
  }
  EXPECT_EQ(pardel({"triangle", "-pq", "square.poly"}).exit_code, 0);
  EXPECT_TRUE(exists("square.1.node"));  // the points are in the .poly, so they are written as for a .poly
}

TEST_F(MeshCommand, a_gap_of_one_rounding_is_closed_by_repair_unless_the_snap_is_zero) {
  write("gap.poly",
        "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 1e-15\n6 0.5 0.5\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n0\n");
  const Ran closed = pardel({"mesh", "gap.poly", "-o", "m.vtu", "--repair", "--check"});
  EXPECT_EQ(closed.exit_code, 0) << closed;
  EXPECT_TRUE(holds(closed.err, {"gap.poly: repaired: Segments bent to points near them: 1"}));
  EXPECT_EQ(pardel({"mesh", "gap.poly", "-o", "m.vtu", "--repair", "--snap", "0"}).exit_code, 4);
  EXPECT_EQ(pardel({"mesh", "gap.poly", "-o", "m.vtu", "--snap", "0"}).exit_code, 2);
}

TEST_F(MeshCommand, a_conforming_mesh_passes_the_stricter_check) {
  ASSERT_EQ(pardel({"mesh", "key.poly", "-o", "m.node", "--conforming"}).exit_code, 0);
  EXPECT_TRUE(certified("key.poly", "m.node", {"--conforming"}));
}

TEST_F(MeshCommand, the_convex_hull_is_meshed_on_request) {
  write("corner.poly",
        "6 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 1 1\n5 1 2\n6 0 2\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 1\n0\n");
  EXPECT_DOUBLE_EQ(report({"corner.poly", "-o", "a.vtu"})["mesh"]["area"], 3.0);
  EXPECT_DOUBLE_EQ(report({"corner.poly", "-o", "b.vtu", "--convex-hull"})["mesh"]["area"], 3.5);
}

TEST_F(MeshCommand, circumcentres_and_off_centres_make_different_certified_meshes) {
  const json off = report({"key.poly", "-o", "a.vtu", "--placement", "off-centre", "--check"});
  const json circum = report({"key.poly", "-o", "b.vtu", "--placement", "circumcentre", "--check"});
  EXPECT_NE(off["digest"], circum["digest"]);
  EXPECT_EQ(report({"key.poly", "-o", "c.vtu"})["digest"], off["digest"]);
}

TEST_F(MeshCommand, a_mesh_is_refined_in_every_format_that_is_read) {
  ASSERT_EQ(pardel({"mesh", "pipe.poly", "-o", "m.node", "-o", "m.vtu", "-o", "m.msh", "--max-area", "0.1"}).exit_code,
            0);
  for (const std::string coarse : {"m.node", "m.vtu", "m.msh"}) {
    const json r = report({coarse, "--refine", "-o", "fine.node", "--max-area", "0.01", "--check"});
    EXPECT_TRUE(r["certificate"]["valid"]) << coarse;
    EXPECT_TRUE(certified("pipe.poly", "fine.node", {"--max-area", "0.01"})) << coarse;
  }
}

TEST_F(MeshCommand, a_mesh_in_place_of_a_domain_is_a_usage_error_that_names_the_option) {
  write("m.vtu", "");
  const Ran ran = pardel({"mesh", "m.vtu", "-o", "fine.vtu"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.vtu", "--refine"}));
}

TEST_F(MeshCommand, the_number_of_threads_changes_nothing_but_the_report) {
  const json one = report({"key.poly", "-o", "a.vtu", "--threads", "1"});
  const json two = report({"key.poly", "-o", "b.vtu", "--threads", "2"});
  EXPECT_EQ(one["threads"], 1);
  EXPECT_EQ(two["threads"], 2);
  EXPECT_EQ(one["digest"], two["digest"]);
}

TEST_F(MeshCommand, all_threads_are_the_default) {
  const auto threads = [&](const std::vector<std::string>& option) {
    std::vector<std::string> arguments = {"square.poly", "-o", "a.vtu"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    return report(arguments)["threads"].get<int>();
  };
  const int all = threads({});
  EXPECT_EQ(all, omp_get_max_threads());
  EXPECT_EQ(threads({"--threads", "all"}), all);
  EXPECT_EQ(threads({"--threads", "0"}), all);
  for (const char* wrong : {"-1", "5000", "two"}) {
    const Ran ran = pardel({"mesh", "square.poly", "-o", "a.vtu", "--threads", wrong});
    EXPECT_EQ(ran.exit_code, 2) << wrong;
    EXPECT_TRUE(holds(ran.err, {"--threads"})) << ran;
  }
}

TEST_F(MeshCommand, a_check_says_that_bounds_are_missed_because_the_budget_ended) {
  const Ran ran =
      pardel({"mesh", "square.poly", "-o", "m.vtu", "--max-area", "0.001", "--max-vertices", "50", "--check"});
  EXPECT_EQ(ran.exit_code, 4) << ran;
  EXPECT_TRUE(holds(ran.err, {"missed bounds only", "as many vertices as --max-vertices allows (the budget)"})) << ran;
  EXPECT_FALSE(holds(ran.err, {"found violations"})) << ran;
}

TEST_F(MeshCommand, holes_of_a_mesh_are_found_again_without_its_domain) {
  ASSERT_EQ(pardel({"mesh", "pipe.poly", "-o", "m.vtu"}).exit_code, 0);
  const json r = report({"m.vtu", "--refine", "-o", "fine.node", "--max-area", "0.01", "--check"});
  EXPECT_EQ(r["input"]["holes"], 7);
  EXPECT_TRUE(r["certificate"]["valid"]);
}

TEST_F(MeshCommand, a_goal_without_bounds_inserts_nothing) {
  write("flat.poly", "4 2 0 0\n0 0 0\n1 1 0\n2 2 0.001\n3 0.3 0.001\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
  for (const char* also : {"--quiet", "--conforming", "--regions"}) {
    EXPECT_EQ(report({"flat.poly", "-o", "m.ele", "--min-angle", "0", also})["mesh"]["triangles"], 2) << also;
  }
  ASSERT_EQ(pardel({"triangle", "-pQ", "flat"}).exit_code, 0);
  EXPECT_EQ(table("flat.1.ele")[0][0], 2);
}

TEST_F(MeshCommand, an_area_file_with_the_name_of_the_mesh_caps_each_triangle) {
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m.node", "--min-angle", "0"}).exit_code, 0);
  ASSERT_EQ(table("m.ele")[0][0], 2);
  write("m.area", "2\n1 0.001\n2 -1\n");
  const json r = report({"m.ele", "--refine", "-o", "fine.node"});
  EXPECT_GT(r["mesh"]["triangles"], 500);
  write("m.area", "3\n1 0.001\n2 -1\n3 -1\n");
  const Ran ran = pardel({"mesh", "m.ele", "--refine", "-o", "f.node"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_TRUE(holds(ran.err, {"m.area", "3 area caps for 2 triangles"}));
}

TEST_F(MeshCommand, progress_is_shown_on_request_and_erased_at_the_end) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "--max-area", "0.00002", "--progress", "always"});
  EXPECT_TRUE(holds(ran.err, {"triangles", "\r\033[K"}));
  EXPECT_TRUE(ran.err.ends_with("\r\033[K"));
}

TEST_F(MeshCommand, a_note_says_that_points_alone_mean_their_convex_hull) {
  write("points.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  const Ran points = pardel({"mesh", "points.node", "-o", "m.off"});
  EXPECT_TRUE(holds(points.out, {"0 segments", "note", "the domain is the convex hull of its points", "--refine"}));
  EXPECT_TRUE(holds(points.out, {"3 vertices, 1 triangle, "}));
  EXPECT_EQ(pardel({"mesh", "points.node", "-o", "m.off", "--convex-hull"}).out.find("note"), std::string::npos);
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "m.off"}).out.find("note"), std::string::npos);
}

TEST_F(MeshCommand, progress_names_every_step) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.vtu", "--check", "--progress", "always"});
  EXPECT_TRUE(holds(ran.err, {"reading square.poly", "validating square.poly", "triangulating", "checking",
                              "writing m.vtu", "computing statistics"}));
  const Ran check = pardel({"check", "square.poly", "m.vtu", "--progress", "always"});
  EXPECT_TRUE(holds(check.err, {"reading square.poly", "validating", "reading m.vtu", "checking"}));
  EXPECT_TRUE(check.err.ends_with("\r\033[K"));
}

TEST_F(MeshCommand, no_progress_is_written_to_a_pipe) {
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "m.vtu", "--max-area", "0.00002"}).err, "");
}

TEST_F(MeshCommand, no_progress_of_short_work_is_shown_on_a_terminal) {
  if (!terminals_exist()) GTEST_SKIP() << "no pseudo-terminals here (is /dev/pts mounted?)";
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "m.vtu"}, {.terminal = true}).err, "");
}

TEST_F(MeshCommand, uses_the_tiles_that_the_options_describe_and_reports_them) {
  for (const std::string kind : {"auto", "paper"}) {
    const json r = report({"square.poly", "-o", "out.vtu", "--max-area", "1e-4", "--cells", "3,2", "--decomposition",
                           kind, "--check", "-q"});
    const json& cut = r["decomposition"];
    EXPECT_EQ(cut["kind"], kind == "auto" ? "lattice" : kind);
    EXPECT_EQ(cut["columns"], 3);
    EXPECT_EQ(cut["rows"], 2);
    EXPECT_LT(cut["circumradius"]["measured"], cut["circumradius"]["by_t3_sharp"]);
    EXPECT_LT(cut["circumradius"]["by_t3_sharp"], cut["circumradius"]["by_t3"]);
    EXPECT_GE(cut["cell_side_over_circumradius"], 4.0);
    EXPECT_EQ(cut["handed_on"]["beyond_box"], 0);
    EXPECT_GE(r["refine"]["sweeps"].size(), 2U);
    int inserted = 0;
    for (const json& sweep : r["refine"]["sweeps"]) {
      EXPECT_LE(sweep["largest_task"], sweep["inserted"]);
      EXPECT_EQ(sweep["largest_task"] > 0, sweep["inserted"] > 0);
      inserted += sweep["inserted"].get<int>();
    }
    EXPECT_EQ(inserted, r["refine"]["inserted"].get<int>() + r["refine"]["segment_splits"].get<int>());
  }
}

TEST_F(MeshCommand, fills_the_interior_with_fewer_triangles) {
  const json refined = report({"square.poly", "-o", "m.node", "--max-area", "1e-3", "--interior", "refine"});
  const json filled = report({"square.poly", "-o", "m.node", "--max-area", "1e-3", "--interior", "fill", "--check"});
  EXPECT_EQ(refined["refine"]["laid"], 0);
  EXPECT_GT(filled["refine"]["laid"], 500);
  EXPECT_EQ(filled["refine"]["restarts"], 0);
  EXPECT_LT(filled["mesh"]["triangles"].get<int>(), 0.9 * refined["mesh"]["triangles"].get<int>());
  EXPECT_EQ(filled["goal"]["interior"], "fill");
  EXPECT_TRUE(certified("square.poly", "m.node", {"--max-area", "1e-3"}));
}

TEST_F(MeshCommand, fills_the_interior_by_default_for_angles_up_to_30_degrees_and_constant_bounds) {
  const auto laid = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"square.poly", "-o", "m.node", "--max-area", "1e-3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments)["refine"]["laid"].get<int>();
  };
  EXPECT_GT(laid({}), 500);
  EXPECT_GT(laid({"--min-angle", "30"}), 500);
  EXPECT_EQ(laid({}), laid({"--interior", "fill"}));
  EXPECT_GT(laid({"--min-angle", "33"}), 500);
  EXPECT_EQ(laid({"--min-angle", "30.5", "--placement", "off-centre"}), 0);
  EXPECT_EQ(laid({"--min-angle", "30.5", "--max-edge", "0.1"}), 0);
  EXPECT_GT(laid({"--min-angle", "30", "--max-edge", "0.1"}), 500);
  EXPECT_EQ(laid({"--grading", "0.3"}), 0);
  EXPECT_EQ(laid({"--decomposition", "paper"}), 0) << "the paper's algorithm refines";
  EXPECT_EQ(laid({"--interior", "refine"}), 0);
  EXPECT_EQ(report({"square.poly", "-o", "m.node"})["refine"]["laid"], 0) << "without a bound on size";
}

TEST_F(MeshCommand, says_how_many_equilateral_triangles_it_has_laid) {
  const auto said = [&](const char* area, const char* angle) {
    return pardel({"mesh", "square.poly", "-o", "m.node", "--max-area", area, "--min-angle", angle, "--interior",
                   "fill", "--placement", "off-centre"})
        .out;
  };
  EXPECT_TRUE(holds(said("1e-3", "30"), {"laid ", " equilateral triangles\n"}));
  EXPECT_TRUE(holds(said("1e-4", "33"), {"laid ", " equilateral triangles, after ", " restarts\n"}));
  EXPECT_TRUE(holds(said("1", "20"), {"note ", "the interior is refined"}));
}

TEST_F(MeshCommand, refuses_to_fill_the_interior_where_nothing_would_be_laid) {
  using Arguments = std::vector<std::string>;
  const std::pair<Arguments, std::string> cases[] = {
      {{}, "needs --max-area, --max-edge or --regions"},
      {{"--max-area", "0.1", "--grading", "0.2"}, "cannot be used with --grading"},
      {{"--max-area", "0.1", "--feature-size", "2"}, "cannot be used with --feature-size"},
      {{"--max-area", "0.1", "--sizes", "sizes.txt"}, "cannot be used with --sizes"},
  };
  for (const auto& [options, message] : cases) {
    Arguments arguments{"mesh", "square.poly", "-o", "m.vtu", "--interior", "fill"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {"--interior fill", message}));
    EXPECT_FALSE(exists("m.vtu"));
  }
}

TEST_F(MeshCommand, refuses_what_needs_a_domain_when_a_mesh_is_refined) {
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "m.node"}).exit_code, 0);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--regions"}, {"--convex-hull"}, {"--grading", "0.2"}, {"--feature-size", "2"}, {"--interior", "fill"}}) {
    std::vector<std::string> arguments{"mesh", "m.node", "--refine", "-o", "fine.vtu"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran;
    EXPECT_TRUE(holds(ran.err, {option[0], "needs a domain and cannot be used with --refine\n"})) << ran;
    EXPECT_FALSE(exists("fine.vtu"));
  }
}

TEST_F(MeshCommand, refuses_cells_together_with_one_tile) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu", "--cells", "3,2", "--decomposition", "none"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"--cells", "--decomposition none"}));
}

}  // namespace
}  // namespace pardel::testing
