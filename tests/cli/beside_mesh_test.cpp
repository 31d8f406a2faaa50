// What files carry beside a mesh is kept, or a line on standard error names what is lost.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../../core/formats.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

/// A square of two triangles with names, a field at its nodes and one in its triangles.
constexpr const char* tank_msh = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "wall of the tank"
2 2 "water"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
6
1 1 2 1 1 1 2
2 1 2 1 1 2 3
3 1 2 1 1 3 4
4 1 2 1 1 4 1
5 2 2 2 1 1 2 3
6 2 2 2 1 1 3 4
$EndElements
$NodeData
1
"T"
1
0.5
3
0
1
4
1 0.2
2 0.2
3 0.2
4 0.2
$EndNodeData
$ElementData
1
"flow"
0
3
0
2
2
5 1 2
6 3 4
$EndElementData
$Periodic
0
$EndPeriodic
)";

class BesideMesh : public Workshop {
 protected:
  BesideMesh() {
    write("tank.msh", tank_msh);
    write("square.poly", square_poly);
  }
};

TEST_F(BesideMesh, one_note_names_the_fields_and_one_what_is_not_read) {
  const Ran ran = pardel({"check", "square.poly", "tank.msh", "-q"});
  EXPECT_EQ(ran.exit_code, 1) << "the markers are others";
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err,
            "pardel: tank.msh: note: the file has the fields \"T\" at points, \"flow\" in triangles, which the check "
            "does not use\npardel: tank.msh: note: not read: the section $Periodic\n");
}

TEST_F(BesideMesh, fields_and_names_go_from_msh_to_vtu_and_back) {
  const std::string note = "the file has the fields \"T\" at points, \"flow\" in triangles\n";
  ASSERT_EQ(pardel({"convert", "tank.msh", "direct.msh", "--msh-ascii"}).exit_code, 0);
  EXPECT_TRUE(holds(read("direct.msh"), {"\"wall of the tank\"", "\"water\"", "$NodeData\n1\n\"T\"\n1\n0.5\n",
                                         "$ElementData\n1\n\"flow\"\n", "\n5 1 2\n6 3 4\n"}));
  const Ran there = pardel({"convert", "tank.msh", "tank.vtu"});
  EXPECT_TRUE(holds(there.err, {note, "tank.vtu: note: .vtu cannot store: times of fields\n"})) << there;
  const Ran back = pardel({"convert", "tank.vtu", "back.msh", "--msh-ascii"});
  EXPECT_EQ(back.err, "pardel: tank.vtu: note: " + note);
  std::string expected = read("direct.msh");
  expected.replace(expected.find("\n0.5\n3\n"), 7, "\n0\n3\n");
  EXPECT_EQ(read("back.msh"), expected);
}

TEST_F(BesideMesh, a_format_without_fields_and_names_makes_a_note) {
  for (const std::string to : {"t.off", "t.node", "t.2dm", "t.gr3", "t.inp"}) {
    const Ran ran = pardel({"convert", "tank.msh", to});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_TRUE(holds(ran.err, {" cannot store: ",
                                "the field \"T\", the field \"flow\", the name \"wall of the tank\", "
                                "the name \"water\"\n"}))
        << ran;
  }
}

TEST_F(BesideMesh, middle_nodes_that_are_left_out_make_a_note) {
  ASSERT_EQ(pardel({"triangle", "-po2Q", "square.poly"}).exit_code, 0);
  EXPECT_EQ(pardel({"convert", "square.1.ele", "s.vtu"}).err,
            "pardel: square.1.ele: note: not read: the middle nodes of triangles\n");
}

TEST_F(BesideMesh, a_mesh_with_curved_edges_is_refused_by_all_commands) {
  write("c.node", "6 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 0.25\n");
  write("c.ele", "1 6 0\n1 1 2 3 4 5 6\n");
  write("c.poly", "3 2 0 0\n1 0 0\n2 2 0\n3 0 2\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"check", "c.poly", "c.ele"},
                                             {"convert", "c.ele", "o.msh", "--order", "2"},
                                             {"mesh", "--refine", "c.ele", "-o", "o.msh"}}) {
    const Ran ran = pardel(command);
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_TRUE(holds(ran.err, {"c.ele:2: the middle node 6 is at (1, 0.25), not in the middle of the edge from node 1 "
                                "to node 2, (1, 0); curved edges are not supported\n"}))
        << ran;
    EXPECT_FALSE(exists("o.msh"));
  }
}

TEST_F(BesideMesh, fields_of_order_2_are_those_of_the_vertices_when_they_are_read) {
  ASSERT_EQ(pardel({"convert", "tank.msh", "first.msh", "--msh-ascii"}).exit_code, 0);
  for (const std::string second : {"second.msh", "second.vtu"}) {
    ASSERT_EQ(pardel({"convert", "tank.msh", second, "--order", "2"}).exit_code, 0);
    const Ran back = pardel({"convert", second, "back.msh", "--msh-ascii"});
    EXPECT_TRUE(holds(back.err, {"the file has the fields \"T\" at points, \"flow\" in triangles\n",
                                 "not read: the middle nodes of triangles\n"}))
        << back;
    std::string expected = read("first.msh");
    if (second == "second.vtu") expected.replace(expected.find("\n0.5\n3\n"), 7, "\n0\n3\n");
    EXPECT_EQ(read("back.msh"), expected) << second;
  }
}

TEST_F(BesideMesh, arrays_of_a_vtk_are_fields_in_other_formats_and_back) {
  const std::string vtk =
      "# vtk DataFile Version 3.0\npardel\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n0 0 0\n1 0 0\n0 1 0\n"
      "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
  write("t.vtk", vtk +
                     "POINT_DATA 3\nSCALARS T double\nLOOKUP_TABLE default\n1 2 3\n"
                     "VECTORS speed double\n0 0 0 1 1 0 2 2 0\n");
  const Ran ran = pardel({"convert", "t.vtk", "t.vtu"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.err, "pardel: t.vtk: note: the file has the fields \"T\" at points, \"speed\" at points\n");
  ASSERT_EQ(pardel({"convert", "t.vtu", "back.vtk"}).exit_code, 0);
  EXPECT_EQ(read("back.vtk"),
            vtk + "POINT_DATA 3\nFIELD FieldData 2\nT 1 3 double\n1\n2\n3\nspeed 3 3 double\n0 0 0\n1 1 0\n2 2 0\n");
  EXPECT_TRUE(
      holds(pardel({"convert", "t.vtk", "t.off"}).err, {".off cannot store: the field \"T\", the field \"speed\"\n"}));
}

TEST_F(BesideMesh, a_vtk_has_fields_but_no_names_and_no_times) {
  const Ran ran = pardel({"convert", "tank.msh", "tank.vtk"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"tank.vtk: note: .vtk cannot store: the name \"wall of the tank\", the name \"water\", "
                              "times of fields\n"}))
      << ran;
  ASSERT_EQ(pardel({"convert", "tank.msh", "first.vtu"}).exit_code, 0);
  const Result<Mesh> vtu = read_mesh(folder_ / "work" / "first.vtu"), vtk = read_mesh(folder_ / "work" / "tank.vtk");
  ASSERT_TRUE(vtu && vtk);
  EXPECT_EQ(vtk->fields.size(), 2U);
  EXPECT_EQ(vtk->fields, vtu->fields);
  EXPECT_TRUE(vtk->left_out.things().empty());
}

TEST_F(BesideMesh, a_refined_mesh_keeps_the_names_and_the_report_lists_them) {
  const Ran ran = pardel({"mesh", "--refine", "tank.msh", "-o", "finer.msh", "-o", "finer.off", "--max-area", "0.1",
                          "--json", "report.json", "--msh-ascii"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"\nnames   marker 1 \"wall of the tank\", region 2 \"water\"\n"})) << ran;
  EXPECT_TRUE(holds(
      ran.err, {"\"flow\" in triangles, which the refined mesh does not have\n",
                "finer.off: note: .off cannot store: regions, the name \"wall of the tank\", the name \"water\"\n"}))
      << ran;
  EXPECT_TRUE(holds(read("finer.msh"), {"1 1 \"wall of the tank\"\n2 2 \"water\"\n"}));
  const json report = json::parse(read("report.json"));
  EXPECT_EQ(report["names"],
            json::parse(R"([{"marker": 1, "name": "wall of the tank"}, {"region": 2, "name": "water"}])"));
}

/// The unit square: its points have the markers `of_points`, and there is a segment inside it.
std::string square_with(const std::string& of_points, const std::string& inner, const std::string& regions) {
  const std::string m = " " + of_points + "\n";
  return "6 2 0 1\n1 0 0" + m + "2 1 0" + m + "3 1 1" + m + "4 0 1" + m + "5 0.3 0.5" + m + "6 0.7 0.5" + m +
         (inner.empty() ? "4 0\n" : "5 0\n") + "1 1 2\n2 2 3\n3 3 4\n4 4 1\n" + inner + "0\n" + regions;
}

TEST_F(BesideMesh, mesh_names_what_a_format_cannot_store_as_convert_does) {
  write("inner.poly", square_with("0", "5 5 6\n", ""));
  write("regions.poly", square_with("0", "", "1\n1 0.5 0.25 2.5 0\n"));
  write("region_0.poly", square_with("0", "", "1\n1 0.5 0.25 0 0\n"));
  write("own_markers.poly", square_with("9", "", ""));
  const auto notes = [&](const std::string& from, const std::string& to) {
    const Ran ran = pardel({"mesh", from, "-o", to, "-q"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    return ran.err;
  };
  EXPECT_EQ(notes("inner.poly", "y.gr3"),
            "pardel: y.gr3: note: .gr3 cannot store: markers of edges and edges inside the domain\n");
  EXPECT_EQ(notes("regions.poly", "y.off"), "pardel: y.off: note: .off cannot store: regions\n");
  for (const char* name : {"regions.poly", "region_0.poly"})
    EXPECT_EQ(notes(name, "y.2dm"),
              "pardel: y.2dm: note: .2dm cannot store: attributes of regions that are not whole numbers from 1 on\n");
  EXPECT_EQ(notes("own_markers.poly", "y.msh"), "pardel: y.msh: note: .msh cannot store: markers of points\n");
  ASSERT_EQ(notes("own_markers.poly", "own.ele"), "");
  EXPECT_EQ(pardel({"mesh", "--refine", "own.ele", "-o", "y.msh", "-q"}).err,
            "pardel: y.msh: note: .msh cannot store: markers of points\n");
}

TEST_F(BesideMesh, mesh_is_silent_where_the_format_stores_all) {
  write("plain.poly", square_with("0", "", ""));
  for (const std::string to : {"y.node", "y.vtu", "y.vtk", "y.msh", "y.off", "y.2dm", "y.gr3", "y.inp"})
    EXPECT_EQ(pardel({"mesh", "plain.poly", "-o", to, "-q"}).err, "") << to;
  // These markers of points are those of the edges.
  EXPECT_EQ(pardel({"mesh", "square.poly", "-o", "y.msh", "-q"}).err, "");
  ASSERT_EQ(pardel({"mesh", "square.poly", "-o", "s.ele", "-q"}).exit_code, 0);
  EXPECT_EQ(pardel({"mesh", "--refine", "s.ele", "-o", "y.msh", "-q"}).err, "");
}

TEST_F(BesideMesh, the_first_field_of_single_numbers_has_the_sizes) {
  ASSERT_EQ(pardel({"convert", "tank.msh", "tank.vtu"}).exit_code, 0);
  for (const std::string sizes : {"tank.msh", "tank.vtu"}) {
    const Ran ran = pardel({"mesh", "square.poly", "-o", "m.off", "--sizes", sizes, "--json", "-"});
    ASSERT_EQ(ran.exit_code, 0) << ran;
    EXPECT_GT(json::parse(ran.out)["mesh"]["triangles"], 30) << sizes;
  }
}

TEST_F(BesideMesh, the_field_that_is_called_size_has_the_sizes_wherever_it_is) {
  std::string text = tank_msh;
  const std::string values = "1 0.2\n2 0.2\n3 0.2\n4 0.2\n";
  text.replace(text.find(values), values.size(), "1 9\n2 9\n3 9\n4 9\n");
  write("two.msh", text + "$NodeData\n1\n\"size\"\n1\n0\n3\n0\n1\n4\n" + values + "$EndNodeData\n");
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.off", "--sizes", "two.msh", "--json", "-"});
  ASSERT_EQ(ran.exit_code, 0) << ran;
  EXPECT_GT(json::parse(ran.out)["mesh"]["triangles"], 30);
}

TEST_F(BesideMesh, a_point_without_a_size_is_named_as_in_its_file) {
  std::string text = tank_msh;
  text.replace(text.find("4\n1 0.2\n2 0.2\n3 0.2\n"), 20, "3\n1 0.2\n2 0.2\n");
  write("gap.msh", text);
  const Ran ran = pardel({"mesh", "square.poly", "-o", "m.off", "--sizes", "gap.msh"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"gap.msh: point 3 has no value that could be an edge length"})) << ran;
}

TEST_F(BesideMesh, names_from_files_do_not_control_the_terminal) {
  std::string text = tank_msh;
  text.replace(text.find("\"T\""), 3, "\"T\x1b[31m\xff\"");
  write("odd.msh", text);
  const Ran ran = pardel({"convert", "odd.msh", "odd.off"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_EQ(ran.err.find('\x1b'), std::string::npos) << ran;
}

}  // namespace
}  // namespace pardel::testing
