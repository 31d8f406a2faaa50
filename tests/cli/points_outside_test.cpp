// Points that lie outside the domain or in a hole: notes about them, and meshes without them.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../../core/formats.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

/// A square with boreholes 5 and 6 inside, 7 to 9 to the right of it, and 10 in a triangular hole of the points 11 to
/// 13.
constexpr const char* boreholes = R"(13 2 1 0
1 0 0 0
2 100 0 0
3 100 60 0
4 0 60 0
5 30 10 5
6 60 10 6
7 120 10 7
8 130 30 8
9 115 45 9
10 50 35 10
11 40 30 0
12 60 30 0
13 50 50 0
7 0
1 1 2
2 2 3
3 3 4
4 4 1
5 11 12
6 12 13
7 13 11
1
1 51 36
)";
const std::string note =
    "note: 4 points, the first at (120, 10), are in no triangle, because they lie outside the "
    "domain or in a hole; ";

class PointsOutside : public Workshop {
 protected:
  PointsOutside() {
    write("boreholes.poly", boreholes);
    write("square.poly", square_poly);
  }
};

TEST_F(PointsOutside, are_counted_in_a_note_of_each_command_that_meets_them) {
  EXPECT_TRUE(holds(pardel({"mesh", "boreholes.poly", "-o", "m.vtu", "-q"}).err, {note + "--drop-unused writes"}));
  EXPECT_TRUE(holds(pardel({"triangle", "-p", "boreholes"}).err, {note + "the switch j writes"}));
  EXPECT_TRUE(holds(pardel({"doctor", "boreholes.poly"}).err, {note + "'pardel mesh --drop-unused' writes"}));
  EXPECT_EQ(pardel({"triangle", "-pQ", "boreholes"}).err, "");
  for (const char* command : {"mesh", "doctor"}) {
    std::vector<std::string> arguments = {command, "square.poly", "--json", "-"};
    if (arguments[0] == "mesh") arguments.insert(arguments.end(), {"-o", "m.vtu"});
    const Ran ran = pardel(arguments);
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(nlohmann::json::parse(ran.out)["points_outside"], 0);
    arguments[1] = "boreholes.poly";
    EXPECT_EQ(nlohmann::json::parse(pardel(arguments).out)["points_outside"], 4);
  }
}

TEST_F(PointsOutside, are_not_counted_in_a_domain_with_problems_until_it_is_repaired) {
  const std::string twice =
      std::string(boreholes).replace(0, 2, "14").insert(std::string(boreholes).find("7 0\n"), "14 0 0 0\n");
  write("twice.poly", twice);
  const auto findings = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"doctor", "twice.poly", "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return nlohmann::json::parse(pardel(arguments).out);
  };
  EXPECT_TRUE(findings({})["points_outside"].is_null());
  EXPECT_EQ(findings({"--repair", "fixed.poly"})["points_outside"], 4);
}

TEST_F(PointsOutside, are_left_out_of_meshes_in_all_formats) {
  for (const char* suffix : {"node", "msh", "vtu", "off", "vtk", "2dm", "gr3", "14"}) {
    const std::string all = std::string("all.") + suffix, used = std::string("used.") + suffix,
                      converted = std::string("converted.") + suffix;
    EXPECT_EQ(pardel({"mesh", "boreholes.poly", "-o", all}).exit_code, 0);
    const Ran ran = pardel({"mesh", "boreholes.poly", "-o", used, "--drop-unused", "--check"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_TRUE(holds(ran.err, {note + "the mesh is written without them"}));
    EXPECT_EQ(pardel({"convert", all, converted, "-j"}).exit_code, 0);
    EXPECT_EQ(pardel({"check", "boreholes.poly", used}).exit_code, 0) << suffix;
    const Result<Mesh> of_mesh = read_mesh(folder_ / "work" / used),
                       of_convert = read_mesh(folder_ / "work" / converted), whole = read_mesh(folder_ / "work" / all);
    ASSERT_TRUE(of_mesh && of_convert && whole) << suffix;
    EXPECT_EQ(of_mesh->points, of_convert->points) << suffix;
    EXPECT_EQ(of_mesh->point_attributes, of_convert->point_attributes) << suffix;
    EXPECT_EQ(of_mesh->points.size() + 4, whole->points.size()) << suffix;
    EXPECT_EQ(of_mesh->triangles.size(), whole->triangles.size()) << suffix;
    for (const Point p : of_mesh->points) EXPECT_LE(p.x, 100) << suffix;
  }
  EXPECT_EQ(pardel({"mesh", "boreholes.poly", "-o", "part.inp", "-j"}).exit_code, 0);
  EXPECT_EQ(read("part.inp").find("120"), std::string::npos);
}

TEST_F(PointsOutside, leave_the_holes_of_the_domain_in_the_poly_of_a_converted_mesh) {
  ASSERT_EQ(pardel({"mesh", "boreholes.poly", "-o", "m.node"}).exit_code, 0);
  ASSERT_EQ(pardel({"convert", "m.node", "used.node", "-j"}).exit_code, 0);
  const Result<Pslg> before = read_pslg(folder_ / "work" / "m.poly"), after = read_pslg(folder_ / "work" / "used.poly");
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->holes, before->holes);
  EXPECT_EQ(after->segments.size(), before->segments.size());
}

TEST_F(PointsOutside, of_a_mesh_are_left_out_when_it_is_refined) {
  ASSERT_EQ(pardel({"mesh", "boreholes.poly", "-o", "m.vtu"}).exit_code, 0);
  const Ran ran = pardel({"mesh", "m.vtu", "--refine", "-o", "r.vtu", "-j", "--max-area", "100", "--check"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.vtu: note: 4 points, the first at (120, 10), are in no triangle; the mesh is"}));
  EXPECT_EQ(pardel({"check", "boreholes.poly", "r.vtu", "--max-area", "100"}).exit_code, 0);
}

TEST_F(PointsOutside, leave_all_components_of_a_field_to_the_other_points) {
  write("m.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 7 7 0\n3 1 0 0\n4 1 1 0\n5 0 1 0\n$EndNodes\n"
        "$Elements\n2\n1 2 0 1 3 4\n2 2 0 1 4 5\n$EndElements\n$NodeData\n1\n\"v\"\n1\n0\n3\n0\n3\n5\n"
        "1 1 2 3\n2 4 5 6\n3 7 8 9\n4 10 11 12\n5 13 14 15\n$EndNodeData\n");
  ASSERT_EQ(pardel({"convert", "m.msh", "used.vtu", "--drop-unused"}).exit_code, 0);
  const Result<Mesh> mesh = read_mesh(folder_ / "work" / "used.vtu");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->points.size(), 4U);
  ASSERT_EQ(mesh->fields.size(), 1U);
  EXPECT_EQ(mesh->fields[0].values, Array<double>(std::vector<double>{1, 2, 3, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

TEST_F(PointsOutside, are_those_of_meshes_only_for_convert) {
  const Ran ran = pardel({"convert", "boreholes.poly", "copy.poly", "--drop-unused"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"--drop-unused is for meshes"}));
}

}  // namespace
}  // namespace pardel::testing
