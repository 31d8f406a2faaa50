// pardel check: valid meshes pass. For an invalid mesh, every violation is reported with its place.
#include <nlohmann/json.hpp>
#include <string>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

/// The mesh of the square with two triangles, cut along one diagonal.
class CheckCommand : public Workshop {
 protected:
  CheckCommand() {
    write("square.poly", square_poly);
    write("m.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
    write("m.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  }
};

TEST_F(CheckCommand, a_valid_mesh_of_another_program_is_certified) {
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"valid"}));
  EXPECT_EQ(ran.err, "");
}

TEST_F(CheckCommand, the_certificate_is_written_as_json) {
  const Ran ran = pardel({"check", "square.poly", "m.ele", "--json", "-"});
  const json certificate = json::parse(ran.out, nullptr, false);
  ASSERT_TRUE(certificate.is_object()) << ran;
  EXPECT_EQ(certificate["schema"], "pardel.certificate/1");
  EXPECT_TRUE(certificate["valid"]);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "-q", "--json", "c.json"}).out, "");
  EXPECT_EQ(json::parse(read("c.json")), certificate);
}

TEST_F(CheckCommand, takes_the_heights_of_a_2dm_for_no_attributes_also_on_standard_input) {
  // Two attributes; a .2dm has the first one as height, and no place for the other.
  write("bed.poly", "4 2 2 0\n1 0 0 5 6\n2 1 0 5 6\n3 1 1 7 8\n4 0 1 9 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  ASSERT_EQ(pardel({"mesh", "bed.poly", "-o", "bed.2dm"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "bed.poly", "bed.2dm"}).exit_code, 0);
  const Ran ran = pardel({"check", "bed.poly", "-"}, {.in_file = "bed.2dm"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
}

TEST_F(CheckCommand, the_number_of_threads_changes_nothing) {
  const auto certificate = [&](const char* threads) {
    return pardel({"check", "square.poly", "m.ele", "--threads", threads, "--json", "-"}).out;
  };
  const std::string one = certificate("1");
  EXPECT_EQ(json::parse(one)["decided_exactly"], 1) << "the four corners lie on one circle";
  EXPECT_EQ(certificate("2"), one);
  EXPECT_EQ(certificate("all"), one);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--threads", "none"}).exit_code, 2);
}

TEST_F(CheckCommand, a_missing_triangle_is_a_violation) {
  write("m.ele", "1 3 0\n1 1 2 3\n");
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_TRUE(holds(ran.out, {"uncovered"}));
}

TEST_F(CheckCommand, a_triangle_the_wrong_way_round_is_a_violation) {
  write("m.ele", "2 3 0\n1 1 3 2\n2 1 3 4\n");
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele"}).exit_code, 1);
}

TEST_F(CheckCommand, a_moved_vertex_is_a_violation) {
  write("m.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1.0000000000000002\n4 0 1\n");
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele"}).exit_code, 1);
}

TEST_F(CheckCommand, each_bound_of_the_goal_is_checked) {
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-area", "0.5"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-area", "0.4999999"}).exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--min-angle", "44.9"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--min-angle", "45.1"}).exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-edge", "1.42"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-edge", "1.41"}).exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-circumradius", "0.7072"}).exit_code, 0);
  EXPECT_EQ(pardel({"check", "square.poly", "m.ele", "--max-circumradius", "0.7071"}).exit_code, 1);
}

TEST_F(CheckCommand, bounds_that_are_missed_are_reported_in_words) {
  const auto words = [this](const std::string& option, const std::string& value) {
    return pardel({"check", "square.poly", "m.ele", option, value}).out;
  };
  EXPECT_TRUE(holds(words("--min-angle", "50"), {"small angle: 2\n  triangle 1: angle 45° is below 50°, at (0, 0)\n"}));
  EXPECT_TRUE(holds(words("--max-area", "0.3"), {"large area: 2\n  triangle 1: area 0.5 is above 0.3, at (0, 0)\n"}));
  EXPECT_TRUE(holds(words("--max-edge", "1.3"), {"edge 3-1 of triangle 1: length 1.41 is above 1.3"}));
  EXPECT_TRUE(holds(words("--max-circumradius", "0.7"), {"triangle 1: circumradius 0.707 is above 0.7"}));
  // More digits are shown where three would not tell the value from the bound.
  EXPECT_TRUE(holds(words("--max-edge", "1.41421"), {"length 1.414214 is above 1.41421"}));
}

TEST_F(CheckCommand, ten_findings_per_kind_are_printed_and_all_are_in_the_json) {
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "fine.vtu", "--max-area", "0.0004", "-q"}).exit_code, 0);
  const Ran ran = pardel({"check", "square.poly", "fine.vtu", "--max-edge", "0.0001", "--max-area", "1e-9"});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(pardel({"check", "square.poly", "fine.vtu", "--max-area", "1e-9", "--json", "all.json", "-q"}).exit_code,
            1);
  const json certificate = json::parse(read("all.json"));
  const std::size_t triangles = certificate["mesh"]["triangles"];
  ASSERT_GT(triangles, 1010U);
  EXPECT_EQ(certificate["violations"].size(), triangles);
  std::size_t lines = 0;
  for (std::size_t at = 0; (at = ran.out.find(": area ", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 10U);
  EXPECT_TRUE(holds(ran.out, {"... and " + std::to_string(triangles - 10) + " more (all in the file of --json)"}));
}

TEST_F(CheckCommand, an_invalid_domain_is_refused) {
  write("bad.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n2 0\n1 1 3\n2 2 4\n0\n");
  const Ran ran = pardel({"check", "bad.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"bad.poly", "cross"}));
}

TEST_F(CheckCommand, a_mesh_that_cannot_be_read_is_refused_with_its_line) {
  write("m.ele", "2 3 0\n1 1 2 3\n2 1 3 9\n");
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.ele:3:", "9"}));
}

TEST_F(CheckCommand, vertices_that_differ_from_input_points_by_rounding_get_a_hint) {
  write("third.poly", "3 2 0 0\n1 0 0\n2 0.30000000000000004 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  for (const auto& [x, is_rounded] : {std::pair("0.3", true), std::pair("0.3001", false)}) {
    write("m.off", std::string("OFF\n3 1 0\n0 0 0\n") + x + " 0 0\n0 1 0\n3 0 1 2\n");
    const Ran ran = pardel({"check", "third.poly", "m.off", "--min-angle", "0"});
    EXPECT_EQ(ran.exit_code, 1) << ran;
    EXPECT_EQ(bool(holds(ran.out, {"hint", "rounding only: m.off has too few digits\n"})), is_rounded) << ran;
    EXPECT_TRUE(holds(ran.out, {"at (0.30000000000000004, 0)"})) << "six digits would not show the difference";
  }
}

TEST_F(CheckCommand, the_hint_about_a_msh_says_how_gmsh_writes_exact_coordinates) {
  write("third.poly", "3 2 0 0\n1 0 0\n2 0.30000000000000004 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  write("m.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 0.3 0 0\n3 0 1 0\n$EndNodes\n"
        "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
  const Ran ran = pardel({"check", "third.poly", "m.msh", "--min-angle", "0"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_TRUE(holds(ran.out, {"hint", "rounding", "-bin -format msh41"})) << ran;
}

TEST_F(CheckCommand, what_the_mesh_or_the_domain_lacks_is_named) {
  write("regions.poly", std::string(square_poly) + "1\n1 0.75 0.25 7 0\n");
  const Ran ran = pardel({"check", "regions.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"not checked: regions of triangles: the mesh has none"})) << ran;
  const json certificate = json::parse(pardel({"check", "regions.poly", "m.ele", "--json", "-"}).out);
  EXPECT_EQ(certificate["not_checked"][0], "regions of triangles: the mesh has none");
}

/// Solvers write their results into the file of the mesh.
TEST_F(CheckCommand, values_that_the_domain_does_not_have_are_no_fault) {
  write("m.node", "4 2 1 0\n1 0 0 1.5\n2 1 0 2.5\n3 1 1 3.5\n4 0 1 4.5\n");
  const Ran ran = pardel({"check", "square.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"not checked: attributes of vertices: the domain has none"})) << ran;
}

TEST_F(CheckCommand, values_at_the_nodes_of_a_msh_are_results_and_no_attributes) {
  const std::string msh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
      "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n"
      "$NodeData\n1\n\"T\"\n1\n0.0\n3\n0\n1\n4\n1 1.0\n2 2.0\n3 3.0\n4 4.0\n$EndNodeData\n";
  write("field.msh", msh);
  write("attributes.poly", "4 2 1 0\n1 0 0 8\n2 1 0 8\n3 1 1 8\n4 0 1 8\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  for (const char* domain : {"square.poly", "attributes.poly"}) {
    const Ran ran = pardel({"check", domain, "field.msh"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_EQ(ran.err,
              "pardel: field.msh: note: the file has the field \"T\" at points, which the check does not use\n");
  }
}

TEST_F(CheckCommand, the_hint_about_rounding_is_given_only_for_rounded_points) {
  const auto hints = [&](const std::string& x, const std::string& y) {
    write("m.node", "4 2 0 0\n1 0 0\n2 1 0\n3 " + x + " " + y + "\n4 0 1\n");
    write("far.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 1e20 3e19\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    const Ran ran = pardel({"check", "far.poly", "m.ele"});
    EXPECT_EQ(ran.exit_code, x == "1" && y == "1" ? 0 : 1) << ran;
    return ran.out.find("by rounding only: m.node has too few digits\n") != std::string::npos;
  };
  EXPECT_TRUE(hints("1.0000000000000002", "1"));
  EXPECT_FALSE(hints("1.4", "1.2")) << "a far point does not make the difference small";
  EXPECT_FALSE(hints("1.00001", "1"));
  write("missing.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0.25\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  write("m.node", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0.25\n");
  const Ran ran = pardel({"check", "missing.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_EQ(ran.out.find("rounding"), std::string::npos) << "the point has no triangle, but is not rounded";
}

TEST_F(CheckCommand, areas_beside_a_far_corner_are_not_lost) {
  write("needle.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 1e20 3e19\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  write("m.node", "3 2 0 0\n1 0 0\n2 1 0\n3 1e20 3e19\n");
  for (const char* corners : {"1 2 3", "2 3 1", "3 1 2"}) {
    write("m.ele", std::string("1 3 0\n1 ") + corners + "\n");
    const Ran ran = pardel({"check", "needle.poly", "m.ele", "--max-area", "1e19", "--min-angle", "0"});
    EXPECT_EQ(ran.exit_code, 1) << ran;
    EXPECT_TRUE(holds(ran.out, {"triangle 1: area 1.5e+19 is above 1e+19", "largest area              1.5e+19"}))
        << ran;
  }
}

TEST_F(CheckCommand, a_wrong_region_is_named_by_its_attribute) {
  write("regions.poly", std::string(square_poly) + "1\n1 0.75 0.25 7 0\n");
  write("m.ele", "2 3 1\n1 1 2 3 7\n2 1 3 4 5\n");
  const Ran ran = pardel({"check", "regions.poly", "m.ele"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_TRUE(holds(ran.out, {"triangle 2 has the region attribute 5, but its face has 7, that of region 1",
                              "numbers are those of the files"}))
      << ran;
}

/// A height stands for an attribute, a material for a region, and the boundaries of a .gr3 have no markers.
TEST_F(CheckCommand, a_mesh_is_compared_as_far_as_its_format_can_store_it) {
  write("d.poly",
        "5 2 2 0\n1 0 0 5 6\n2 2 0 5 6\n3 2 1 5 6\n4 0 1 5 6\n5 1 1 7 8\n6 1\n1 1 2 3\n2 2 3 2\n3 3 5 1\n"
        "4 5 4 1\n5 4 1 1\n6 5 1 9\n0\n2\n1 0.1 0.5 4 -1\n2 1.5 0.5 6 -1\n");
  for (const std::string name : {"m.vtk", "m.2dm", "m.gr3", "m.14"}) {
    EXPECT_EQ(pardel({"mesh", "d.poly", "-o", name, "--max-area", "0.01"}).exit_code, 0);
    const Ran ran = pardel({"check", "d.poly", name, "--max-area", "0.01"});
    EXPECT_EQ(ran.exit_code, 0) << name << ran;
    EXPECT_EQ(pardel({"check", "d.poly", name, "--max-area", "0.001"}).exit_code, 1) << name;
  }
}

}  // namespace
}  // namespace pardel::testing
