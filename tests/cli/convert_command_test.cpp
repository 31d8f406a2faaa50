// pardel convert: a mesh or a domain in another format, without changes.
#include <string>
#include <vector>

#include "../../core/digest.hpp"
#include "../../core/formats.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

constexpr const char* two_regions_poly = R"(10 2 1 1
0 0 0 1.5 3
1 1 0 2.5 0
2 2 0 3.5 0
3 2 1 4.5 4
4 1 1 5.5 0
5 0 1 6.5 0
6 0.4 0.4 7.5 0
7 0.6 0.4 8.5 0
8 0.6 0.6 9.5 0
9 0.4 0.6 9.75 0
11 1
0 0 1 1
1 1 2 1
2 2 3 2
3 3 4 1
4 4 5 1
5 5 0 1
6 1 4 3
7 6 7 4
8 7 8 4
9 8 9 4
10 9 6 4
1
0 0.5 0.5
2
0 0.1 0.1 7 0.01
1 1.5 0.5 9 -1
)";

class ConvertCommand : public Workshop {
 protected:
  ConvertCommand() {
    write("in.poly", two_regions_poly);
    EXPECT_EQ(pardel({"mesh", "in.poly", "-o", "m.node", "-o", "m.vtu", "-o", "m.msh"}).exit_code, 0);
  }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / "work" / name; }
  [[nodiscard]] Mesh mesh(const std::string& name) const {
    Result<Mesh> mesh = read_mesh(path(name));
    EXPECT_TRUE(mesh) << mesh.error().message;
    return std::move(mesh).value();
  }
  void convert(const std::string& from, const std::string& to) const {
    const Ran ran = pardel({"convert", from, to});
    EXPECT_EQ(ran.exit_code, 0) << from << " to " << to << ": " << ran;
    EXPECT_TRUE(ran.err.empty() ||
                holds(ran.err, {"note: " + std::filesystem::path(to).extension().string() + " cannot store: "}))
        << ran;
  }
};

TEST_F(ConvertCommand, every_pair_of_formats_keeps_the_mesh_its_regions_and_its_markers) {
  const Digest digest_of_mesh = digest(mesh("m.node"));
  for (const std::string from : {"m.ele", "m.vtu", "m.msh"}) {
    for (const std::string to : {"node", "vtu", "msh"}) {
      convert(from, "c." + to);
      EXPECT_EQ(digest(mesh("c." + to)), digest_of_mesh) << from << " to " << to;
      EXPECT_EQ(mesh("c." + to).points, mesh(from).points) << from << " to " << to;
    }
  }
}

TEST_F(ConvertCommand, there_and_back_gives_the_same_files) {
  convert("m.ele", "a.vtu");
  convert("a.vtu", "b.node");
  convert("b.node", "c.vtu");
  EXPECT_EQ(read("c.vtu"), read("a.vtu"));
  EXPECT_EQ(mesh("b.node").point_markers, mesh("m.node").point_markers);
  EXPECT_EQ(mesh("b.node").point_attributes, mesh("m.node").point_attributes);
}

TEST_F(ConvertCommand, triangles_files_keep_their_numbering_holes_and_regions) {
  convert("m.node", "n.node");
  for (const std::string suffix : {".node", ".ele", ".poly"}) EXPECT_EQ(read("n" + suffix), read("m" + suffix));
  write("zero.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
  write("zero.ele", "1 3 0\n0 0 1 2\n");
  convert("zero.ele", "z.ele");
  EXPECT_EQ(table("z.ele")[1], (std::vector<double>{0, 0, 1, 2}));
}

/// Its .poly refers to the nodes of the .node, the middles of edges among them.
TEST_F(ConvertCommand, a_mesh_of_second_order_keeps_the_holes_the_regions_and_their_caps) {
  ASSERT_EQ(pardel({"mesh", "in.poly", "-o", "second.ele", "--order", "2"}).exit_code, 0);
  EXPECT_EQ(pardel({"convert", "second.ele", "first.ele"}).exit_code, 0);
  for (const std::string suffix : {".node", ".ele", ".poly"}) EXPECT_EQ(read("first" + suffix), read("m" + suffix));
  EXPECT_EQ(pardel({"convert", "second.ele", "again.ele", "--order", "2"}).exit_code, 0);
  for (const std::string suffix : {".node", ".ele", ".poly"})
    EXPECT_EQ(read("again" + suffix), read("second" + suffix));
  for (const std::string order : {"1", "2"}) {
    ASSERT_EQ(pardel({"mesh", "second.ele", "--refine", "-o", "fine.ele", "--order", order}).exit_code, 0);
    EXPECT_TRUE(holds(read("fine.poly"), {"\n1\n1 0.5 0.5\n2\n1 0.1 0.1 7 0.01\n2 1.5 0.5 9 -1\n"}))
        << read("fine.poly");
  }
}

TEST_F(ConvertCommand, a_hole_is_found_where_the_format_has_none) {
  convert("m.vtu", "v.node");
  EXPECT_EQ(pardel({"mesh", "v.node", "--refine", "-o", "finer.vtu", "--max-area", "0.001", "--check"}).exit_code, 0);
}

TEST_F(ConvertCommand, a_mesh_without_segments_is_written_without_holes) {
  write("ring.node", "8 2 0 0\n1 0 0\n2 3 0\n3 3 3\n4 0 3\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n");
  write("ring.ele", "8 3 0\n1 1 2 6\n2 1 6 5\n3 2 3 7\n4 2 7 6\n5 3 4 8\n6 3 8 7\n7 4 1 5\n8 4 5 8\n");
  convert("ring.ele", "ring.2dm");
  convert("ring.2dm", "own.node");
  EXPECT_EQ(table("own.poly"), (std::vector<std::vector<double>>{{0, 2, 1, 0}, {0, 1}, {0}}));
}

TEST_F(ConvertCommand, a_wrong_mesh_stays_as_it_is) {
  write("w.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
  write("w.ele", "2 3 0\n1 1 3 2\n2 1 3 4\n");
  convert("w.ele", "w.off");
  EXPECT_EQ(mesh("w.off").triangles[0].v, (std::array<Index, 3>{0, 2, 1}));
}

TEST_F(ConvertCommand, a_note_names_what_the_format_cannot_store) {
  EXPECT_EQ(pardel({"convert", "m.ele", "n.off"}).err,
            "pardel: n.off: note: .off cannot store: regions, markers of points, attributes of points\n");
  EXPECT_EQ(pardel({"convert", "m.ele", "n.msh", "-q"}).err,
            "pardel: n.msh: note: .msh cannot store: markers of points, attributes of points\n");
  EXPECT_TRUE(holds(pardel({"convert", "m.ele", "-", "--format", "off"}).err,
                    {"pardel: -: note: its format cannot store: regions, markers"}));
  EXPECT_EQ(pardel({"convert", "m.ele", "n.vtu"}).err, "");
}

TEST_F(ConvertCommand, formats_of_other_solvers_keep_the_triangles_and_a_note_names_the_rest) {
  for (const std::string to : {"vtk", "2dm", "gr3", "14", "inp"}) convert("m.ele", "c." + to);
  EXPECT_EQ(mesh("c.vtk"), mesh("m.vtu"));
  EXPECT_EQ(digest(mesh("c.2dm")), digest(mesh("m.node")));
  EXPECT_EQ(mesh("c.gr3").triangles, mesh("m.node").triangles);
  EXPECT_EQ(read("c.14"), read("c.gr3"));
  EXPECT_EQ(pardel({"convert", "m.ele", "n.vtk"}).err, "");
  EXPECT_TRUE(holds(pardel({"convert", "m.ele", "n.2dm"}).err, {".2dm cannot store: markers of points\n"}));
  EXPECT_TRUE(holds(pardel({"convert", "m.ele", "n.inp"}).err,
                    {".inp cannot store: markers of points, attributes of points\n"}));
  EXPECT_TRUE(holds(pardel({"convert", "m.ele", "n.gr3"}).err,
                    {".gr3 cannot store: regions, markers of edges and edges inside the domain, markers of points\n"}));
}

TEST_F(ConvertCommand, open_boundaries_are_those_with_the_markers_of_the_option) {
  EXPECT_EQ(pardel({"convert", "m.ele", "h.gr3", "--open-boundary", "2,4"}).exit_code, 0);
  EXPECT_TRUE(holds(read("h.gr3"), {"\n2 = number of open boundaries\n7 = number of nodes of all open boundaries\n",
                                    "\n1 = number of land boundaries\n"}))
      << read("h.gr3");
  const Ran wrong = pardel({"convert", "m.ele", "w.gr3", "--open-boundary", "2,77"});
  EXPECT_EQ(wrong.exit_code, 2) << wrong;
  EXPECT_TRUE(holds(wrong.err, {"w.gr3: no edge of the boundary has the marker 77"}));
  EXPECT_FALSE(exists("w.gr3"));
  const Ran useless = pardel({"convert", "m.ele", "w.vtu", "--open-boundary", "2"});
  EXPECT_EQ(useless.exit_code, 2) << useless;
  EXPECT_TRUE(holds(useless.err, {"--open-boundary is for .gr3 and .14"}));
}

TEST_F(ConvertCommand, elements_of_order_2_are_written_and_read) {
  for (const std::string to : {"ele", "msh", "vtu"}) {
    EXPECT_EQ(pardel({"convert", "m.ele", "s." + to, "--order", "2"}).exit_code, 0) << to;
    EXPECT_EQ(digest(mesh("s." + to)), digest(mesh("m.node"))) << to;
    EXPECT_EQ(pardel({"check", "in.poly", "s." + to}).exit_code, 0) << to;
  }
  EXPECT_EQ(table("s.ele")[0][1], 6);
  const Ran wrong = pardel({"convert", "m.ele", "s.off", "--order", "2"});
  EXPECT_EQ(wrong.exit_code, 2) << wrong;
  EXPECT_TRUE(holds(wrong.err, {"s.off: --order 2 is for .node, .ele, .msh and .vtu"}));
  EXPECT_EQ(pardel({"convert", "m.ele", "s.vtu", "--order", "3"}).exit_code, 2);
}

TEST_F(ConvertCommand, a_domain_is_written_as_poly_with_its_numbering) {
  convert("in.poly", "out.poly");
  EXPECT_EQ(*read_pslg(path("out.poly")), *read_pslg(path("in.poly")));
  EXPECT_EQ(table("out.poly")[1][0], 0);
  write("points.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  convert("points.node", "points.poly");
  EXPECT_EQ(read_pslg(path("points.poly"))->points.size(), 3U);
}

TEST_F(ConvertCommand, a_domain_is_not_meshed) {
  const Ran ran = pardel({"convert", "in.poly", "out.vtu"});
  EXPECT_EQ(ran.exit_code, 2) << ran;
  EXPECT_TRUE(holds(ran.err, {"'pardel mesh in.poly -o out.vtu'"}));
  EXPECT_FALSE(exists("out.vtu"));
}

TEST_F(ConvertCommand, outputs_that_make_no_sense_are_usage_errors) {
  EXPECT_TRUE(holds(pardel({"convert", "m.vtu", "m2.svg"}).err, {"'pardel draw m.vtu m2.svg'"}));
  EXPECT_TRUE(holds(pardel({"convert", "m.vtu", "m2.poly"}).err, {"m.vtu is a mesh", ".node"}));
  EXPECT_TRUE(holds(pardel({"convert", "m.vtu", "m2.stl"}).err, {"'.stl' is not a known format"}));
  EXPECT_TRUE(holds(pardel({"convert", "m.vtu", "m.vtu"}).err, {"would replace"}));
  for (const std::string to : {"m2.svg", "m2.poly", "m2.stl"})
    EXPECT_EQ(pardel({"convert", "m.vtu", to}).exit_code, 2) << to;
}

/// A square of two triangles that were never merged.
TEST_F(ConvertCommand, a_mesh_with_doubled_nodes_is_copied_and_messages_have_the_numbers_of_its_file) {
  write("doubled.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 1 0\n0 0 0\n3 0 1 2\n3 5 4 3\n");
  const Ran ran = pardel({"convert", "doubled.off", "d.ele"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"Points 2 and 4 are both at (1, 1)", "Points 0 and 5 are both at (0, 0)"})) << ran;
  EXPECT_EQ(pardel({"convert", "d.ele", "back.off"}).exit_code, 0);
  EXPECT_TRUE(read("back.off").starts_with("OFF\n6 2 0\n")) << read("back.off");
  const Ran refined = pardel({"mesh", "--refine", "doubled.off", "-o", "r.ele"});
  EXPECT_EQ(refined.exit_code, 3) << refined;
  EXPECT_TRUE(holds(refined.err, {"Points 2 and 4 are both at (1, 1)"})) << refined;
}

TEST_F(ConvertCommand, doubled_nodes_are_refused_when_a_mesh_is_refined_also_if_a_poly_lies_beside_it) {
  write("d.node", "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 0\n5 1 1\n6 0 1\n");
  write("d.ele", "2 3 0\n1 1 2 3\n2 4 5 6\n");
  for (const bool with_poly : {false, true}) {
    if (with_poly) write("d.poly", "0 2 0 0\n6 1\n1 1 2 1\n2 2 3 1\n3 3 1 1\n4 4 5 1\n5 5 6 1\n6 6 4 1\n0\n");
    const Ran refined = pardel({"mesh", "--refine", "d.ele", "-o", "r.off"});
    EXPECT_EQ(refined.exit_code, 3) << refined;
    EXPECT_TRUE(holds(refined.err, {"d.ele: Points 1 and 4 are both at (0, 0)", "Points 3 and 5 are both at (1, 1)"}))
        << refined;
    EXPECT_FALSE(exists("r.off"));
  }
}

TEST_F(ConvertCommand, doubled_nodes_are_refused_in_the_same_words_by_triangle) {
  write("d.node", "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 0\n5 1 1\n6 0 1\n");
  write("d.ele", "2 3 0\n1 1 2 3\n2 4 5 6\n");
  write("d.area", "2\n1 0.1\n2 0.1\n");
  const std::string why = pardel({"mesh", "--refine", "d.ele", "-o", "r.off"}).err;
  EXPECT_TRUE(holds(why, {"d.ele: Points 1 and 4 are both at (0, 0).\nPoints 3 and 5 are both at (1, 1)."})) << why;
  write("d.poly", "0 2 0 0\n6 1\n1 1 2 1\n2 2 3 1\n3 3 1 1\n4 4 5 1\n5 5 6 1\n6 6 4 1\n0\n");
  for (const char* switches : {"-rQ", "-rpQ", "-rqaQ", "-rpqa0.1jQ"}) {
    const Ran ran = pardel({"triangle", switches, "d"});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_EQ(ran.err, why);
    EXPECT_FALSE(exists("d.1.ele"));
  }
}

/// The tags of nodes in a .msh need not follow one another.
TEST_F(ConvertCommand, doubled_nodes_of_a_msh_have_their_tags_in_messages) {
  write("tags.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n50 1 1 0\n60 0 0 0\n"
        "$EndNodes\n$Elements\n2\n7 2 2 1 1 10 20 30\n9 2 2 1 1 60 50 40\n$EndElements\n");
  const Ran ran = pardel({"convert", "tags.msh", "d.ele"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"tags.msh: Points 10 and 60 are both at (0, 0)", "Points 30 and 50 are both at (1, 1)"}))
      << ran;
  EXPECT_EQ(table("d.node")[1][0], 1) << "a .node has no such tags";
  const Ran refined = pardel({"mesh", "--refine", "tags.msh", "-o", "r.ele"});
  EXPECT_EQ(refined.exit_code, 3) << refined;
  EXPECT_TRUE(holds(refined.err, {"tags.msh: Points 10 and 60 are both at (0, 0)"})) << refined;
}

TEST_F(ConvertCommand, a_point_gets_no_marker_that_it_did_not_have) {
  write("plain.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  write("plain.ele", "1 3 0\n1 1 2 3\n");
  write("plain.poly", "0 2 0 0\n3 1\n1 1 2 5\n2 2 3 1\n3 3 1 1\n0\n");
  for (const std::string from : {"plain.node", "c.vtu", "c.msh", "c.off"}) {
    for (const std::string to : {"c.vtu", "c.msh", "c.off", "d.node"}) {
      if (from != to) {
        EXPECT_EQ(pardel({"convert", from, to}).exit_code, 0) << from << " to " << to;
      }
    }
    EXPECT_EQ(table("d.node")[0], (std::vector<double>{3, 2, 0, 0})) << from;
    EXPECT_TRUE(holds(read("d.poly"), {" 1 2 5\n"}) || holds(read("d.poly"), {" 0 1 5\n"})) << from;
  }
}

TEST_F(ConvertCommand, points_without_triangles_are_copied_to_every_format_and_back) {
  write("points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  for (const std::string to : {"p.msh", "p.vtu", "p.ele"}) {
    const Ran there = pardel({"convert", "points.off", to}), back = pardel({"convert", to, "back.off"});
    EXPECT_EQ(there.exit_code, 0) << there;
    EXPECT_EQ(there.out.find("note"), std::string::npos) << there;
    EXPECT_EQ(back.exit_code, 0) << back;
    EXPECT_EQ(read("back.off"), read("points.off")) << to;
  }
}

}  // namespace
}  // namespace pardel::testing
