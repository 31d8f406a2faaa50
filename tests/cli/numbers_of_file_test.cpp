// Messages about the file of a mesh name its nodes by the numbers that they have there, and its edges, which have none,
// by the numbers of their ends.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n",
                  square = "10 0 0 0\n20 2 0 0\n30 2 2 0\n40 0 2 0\n50 1 1 0\n";
/// Node 50 lies on the edge of nodes 10 and 30, of which only the triangle on the other side knows it.
const std::string hanging = head + "5\n" + square +
                            "$EndNodes\n$Elements\n3\n1 2 2 0 1 10 20 30\n2 2 2 0 1 10 50 40\n3 2 2 0 1 50 30 "
                            "40\n$EndElements\n";
/// Node 60 is no corner of a triangle, and lies on the line from node 20 to node 50.
const std::string unused =
    head + "6\n" + square +
    "60 1.5 0.5 0\n$EndNodes\n$Elements\n5\n1 2 2 0 1 10 20 50\n2 2 2 0 1 20 30 50\n3 2 2 0 1 30 40 50\n4 2 2 "
    "0 1 40 10 50\n5 1 2 7 1 20 50\n$EndElements\n";

using NumbersOfFile = Workshop;

TEST_F(NumbersOfFile, name_a_hanging_node_and_the_edge_by_tags) {
  write("hanging.msh", hanging);
  const Ran ran = pardel({"mesh", "hanging.msh", "--refine", "-o", "r.vtu"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"hanging.msh: Segments ", "Point 50 at (1, 1) lies in the interior of segment 30-10."}));
  EXPECT_EQ(ran.err.find("segment 2"), std::string::npos) << ran;
}

TEST_F(NumbersOfFile, name_an_edge_inside_the_domain_by_tags_also_in_the_list_of_problems) {
  write("unused.msh", unused);
  write("sizes.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\n1 1\n1 1\n");
  const Ran ran =
      pardel({"mesh", "unused.msh", "--refine", "-o", "r.vtu", "--sizes", "sizes.asc", "--json", "why.json"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  const std::string message = "Point 60 at (1.5, 0.5) lies in the interior of segment 20-50.";
  EXPECT_TRUE(holds(ran.err, {"unused.msh: " + message}));
  const nlohmann::json problem = nlohmann::json::parse(read("why.json"))["problems"][0];
  EXPECT_EQ(problem["message"], message);
  EXPECT_EQ(problem["ids"], nlohmann::json({60, 20, 50})) << "the ends of an edge without a number";
}

TEST_F(NumbersOfFile, begin_at_0_or_1_as_in_a_node_file) {
  for (const int first : {0, 1}) {
    const auto n = [&](int i) { return std::to_string(i + first) + " "; };
    write("m.node", "5 2 0 0\n" + n(0) + "0 0\n" + n(1) + "2 0\n" + n(2) + "2 2\n" + n(3) + "0 2\n" + n(4) + "1 1\n");
    write("m.ele", "3 3 0\n" + n(0) + n(0) + n(1) + n(2) + "\n" + n(1) + n(0) + n(4) + n(3) + "\n" + n(2) + n(4) +
                       n(2) + n(3) + "\n");
    const Ran ran = pardel({"mesh", "m.node", "--refine", "-o", "r.vtu"});
    EXPECT_EQ(ran.exit_code, 3) << ran;
    const std::string point = std::to_string(4 + first), edge = std::to_string(2 + first) + "-" + std::to_string(first);
    EXPECT_TRUE(holds(ran.err, {"m.node: ", "Point " + point + " at (1, 1) lies in the interior of segment " + edge}));
  }
}

TEST_F(NumbersOfFile, name_the_corners_of_a_triangle_that_is_turned_over) {
  write("m.node", "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n");
  write("m.ele", "2 3 0\n1 1 3 2\n2 1 4 3\n");
  write("m.poly", "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Ran ran = pardel({"mesh", "m.node", "--refine", "-o", "r.vtu"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.node: triangle 1 of the mesh (vertices 1, 3, 2) is not positively oriented"}));
}

TEST_F(NumbersOfFile, are_those_of_its_segments_where_a_poly_has_them) {
  write("m.node", "6 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n5 1 1\n6 1.5 0.5\n");
  write("m.ele", "4 3 0\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 5\n");
  write("m.poly", "0 2 0 0\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 2 5\n0\n");
  write("sizes.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\n1 1\n1 1\n");
  const auto refine = [&] { return pardel({"mesh", "m.node", "--refine", "-o", "r.vtu", "--sizes", "sizes.asc"}); };
  const Ran ran = refine();
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.node: Point 6 at (1.5, 0.5) lies in the interior of segment 5."})) << ran;
  write("m.poly", "0 2 0 0\n5 0\n1 2 4\n2 2 3\n3 3 4\n4 4 1\n5 1 2\n0\n");
  EXPECT_TRUE(holds(refine().err, {"Point 6 at (1.5, 0.5) lies in the interior of segment 2-5."}))
      << "segments that were cut at nodes have other numbers than in the file";
}

TEST_F(NumbersOfFile, are_those_of_the_triangles_of_a_2dm) {
  write("square.poly", "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const std::string nodes = "ND 1 0 0 0\nND 2 2 0 0\nND 3 2 2 0\nND 4 0 2 0\n";
  write("m.2dm", "MESH2D\nE3T 105 1 2 3 1\nE3T 101 1 3 4 1\n" + nodes);
  const Ran checked = pardel({"check", "square.poly", "m.2dm", "--max-area", "1.5"});
  EXPECT_EQ(checked.exit_code, 1) << checked;
  EXPECT_TRUE(holds(checked.out, {"triangle 105: area 2 is above 1.5", "triangle 101: area 2 is above 1.5",
                                  "smallest angle            45            triangle 105 at"}))
      << checked;
  write("turned.2dm", "MESH2D\nE3T 105 1 2 3 1\nE3T 101 1 4 3 1\n" + nodes);
  const Ran refined = pardel({"mesh", "turned.2dm", "--refine", "-o", "r.vtu"});
  EXPECT_EQ(refined.exit_code, 3) << refined;
  EXPECT_TRUE(holds(refined.err, {"triangle 101"})) << refined;
}

/// A square, and two triangles of which the second one overlaps the first one.
class OverlapInFiles : public Workshop {
 protected:
  OverlapInFiles() {
    write("square.poly", "4 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
    write("from0.poly", "4 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n");
    write("m.off", "OFF\n5 2 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1.5 0.5 0\n3 0 1 2\n3 3 4 2\n");
    write("tags.msh", head +
                          "5\n10 0 0 0\n20 2 0 0\n30 2 2 0\n40 0 2 0\n50 1.5 0.5 0\n$EndNodes\n$Elements\n2\n"
                          "71 2 2 0 1 10 20 30\n72 2 2 0 1 40 50 30\n$EndElements\n");
    write("zero.node", "5 2 0 0\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1.5 0.5\n");
    write("zero.ele", "2 3 0\n0 0 1 2\n1 3 4 2\n");
    for (const char* name : {"m.vtu", "m.vtk", "m.msh", "m.2dm", "m.gr3", "m.14"})
      EXPECT_EQ(pardel({"convert", "m.off", name, "-q"}).exit_code, 0) << name;
    write("one.node", "5 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n5 1.5 0.5\n");
    write("one.ele", "2 3 0\n1 1 2 3\n2 4 5 3\n");
  }
};

TEST_F(OverlapInFiles, is_named_by_the_numbers_of_the_file_in_every_format) {
  struct Case {
    const char* mesh;
    const char* edges;
    const char* triangle;
  };
  for (const auto& [mesh, edges, triangle] :
       std::vector<Case>{{"tags.msh", "boundary edges 30-10 and 40-50 intersect", "edge 30-10 of triangle 1"},
                         {"m.msh", "boundary edges 3-1 and 4-5 intersect", "edge 3-1 of triangle 1"},
                         {"one.node", "boundary edges 3-1 and 4-5 intersect", "edge 3-1 of triangle 1"},
                         {"one.ele", "boundary edges 3-1 and 4-5 intersect", "edge 3-1 of triangle 1"},
                         {"m.2dm", "boundary edges 3-1 and 4-5 intersect", "edge 3-1 of triangle 1"},
                         {"m.gr3", "boundary edges 3-1 and 4-5 intersect", "edge 3-1 of triangle 1"},
                         {"m.14", "boundary edges 3-1 and 4-5 intersect", "edge 3-1 of triangle 1"},
                         {"zero.node", "boundary edges 2-0 and 3-4 intersect", "edge 2-0 of triangle 0"},
                         {"m.off", "boundary edges 2-0 and 3-4 intersect", "edge 2-0 of triangle 0"},
                         {"m.vtk", "boundary edges 2-0 and 3-4 intersect", "edge 2-0 of triangle 0"},
                         {"m.vtu", "boundary edges 2-0 and 3-4 intersect", "edge 2-0 of triangle 0"}})
    for (const bool from_0 : {false, true}) {
      const Ran ran =
          pardel({"check", from_0 ? "from0.poly" : "square.poly", mesh, "--max-edge", "2.5", "--json", "c.json"});
      EXPECT_EQ(ran.exit_code, 1) << ran;
      EXPECT_TRUE(holds(ran.out, {edges, triangle, "numbers are those of the files",
                                  "largest angle             90            triangle " +
                                      std::string(1, triangle[std::string_view(triangle).size() - 1]) + " at"}))
          << mesh << ran;
      EXPECT_TRUE(holds(ran.out, {from_0 ? "segment 3 from point 3 to 0 is" : "segment 4 from point 4 to 1 is"}))
          << ran;
      const nlohmann::json violations = nlohmann::json::parse(read("c.json"))["violations"];
      const bool found = std::ranges::any_of(violations, [](const nlohmann::json& violation) {
        return violation["witness"].get<std::string>().starts_with("boundary edges 2-0 and 3-4 intersect");
      });
      EXPECT_TRUE(found) << mesh << ": the report counts from 0";
    }
}

TEST_F(OverlapInFiles, other_commands_name_the_numbers_of_the_file_too) {
  for (const auto& [mesh, point] : {std::pair{"tags.msh", "edge 30-10"},
                                    {"m.msh", "edge 3-1"},
                                    {"one.ele", "edge 3-1"},
                                    {"m.2dm", "edge 3-1"},
                                    {"m.gr3", "edge 3-1"},
                                    {"zero.ele", "edge 2-0"},
                                    {"m.off", "edge 2-0"},
                                    {"m.vtk", "edge 2-0"},
                                    {"m.vtu", "edge 2-0"}}) {
    std::string edge = point;
    edge[0] = 'E';
    EXPECT_TRUE(holds(pardel({"mesh", mesh, "--refine", "-o", "r.vtu"}).err, {mesh, edge + " is a side of triangle "}))
        << pardel({"mesh", mesh, "--refine", "-o", "r.vtu"});
  }
}

TEST_F(NumbersOfFile, name_points_and_triangles_of_a_field_of_sizes) {
  write("square.poly", square_poly);
  const std::string nodes = "10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n", ends = "$EndNodes\n$Elements\n2\n",
                    data = "$NodeData\n1\n\"size\"\n1\n0\n3\n0\n1\n4\n10 1\n20 1\n30 ";
  write("negative.msh", head + "4\n" + nodes + ends + "1 2 2 0 1 10 20 30\n2 2 2 0 1 10 30 40\n$EndElements\n" + data +
                            "-1\n40 1\n$EndNodeData\n");
  write("flat.msh", head + "4\n" + nodes + ends + "1 2 2 0 1 10 20 30\n2 2 2 0 1 10 30 30\n$EndElements\n" + data +
                        "1\n40 1\n$EndNodeData\n");
  EXPECT_TRUE(holds(pardel({"mesh", "square.poly", "-o", "m.vtu", "--sizes", "negative.msh"}).err,
                    {"negative.msh: the size at point 30 must be positive, not -1"}));
  EXPECT_TRUE(holds(pardel({"mesh", "square.poly", "-o", "m.vtu", "--sizes", "flat.msh"}).err,
                    {"flat.msh: triangle 2 of the mesh of the sizes (vertices 10, 30, 30) is flat"}));
}

TEST_F(NumbersOfFile, name_a_point_that_a_raster_does_not_cover) {
  write("tags.msh", head +
                        "4\n10 0 0 0\n20 2 0 0\n30 2 2 0\n40 0 2 0\n$EndNodes\n$Elements\n2\n1 2 2 0 1 10 20 30\n2 2 2 "
                        "0 1 10 30 40\n$EndElements\n");
  write("small.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\n1 1\n1 1\n");
  const Ran ran = pardel({"mesh", "tags.msh", "--refine", "-o", "r.vtu", "--sizes", "small.asc"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"does not cover point 20 at (2, 0)"})) << ran;
}

/// Two squares with one region each. Points, segments and regions count from `first`.
std::string two_squares(int first) {
  const auto n = [&](int i) { return std::to_string(i + first) + " "; };
  const std::vector<std::string> points{"0 0", "1 0", "2 0", "2 1", "1 1", "0 1"};
  std::string poly = "6 2 0 0\n";
  for (int i = 0; i < 6; ++i) poly += n(i) + points[static_cast<std::size_t>(i)] + "\n";
  poly += "7 1\n";
  for (int i = 0; i < 6; ++i) poly += n(i) + n(i) + n((i + 1) % 6) + "1\n";
  return poly + n(6) + n(1) + n(4) + "2\n0\n2\n" + n(0) + "0.5 0.5 1 -1\n" + n(1) + "1.5 0.5 2 0.01\n";
}

TEST_F(NumbersOfFile, are_those_of_the_first_output_in_the_check_of_a_mesh_just_made) {
  for (const int of_domain : {0, 1}) {
    write("two.poly", two_squares(of_domain));
    for (const auto& [output, first] : {std::pair{"m.node", 1},
                                        {"m.vtu", 0},
                                        {"m.msh", 1},
                                        {"m.off", 0},
                                        {"m.2dm", 1},
                                        {"m.vtk", 0},
                                        {"m.gr3", 1},
                                        {"m.inp", 1},
                                        {"m.svg", 0}}) {
      const Ran ran = pardel({"mesh", "two.poly", "-o", output, "-o", "other.ele", "-o", "other.off", "--check",
                              "--max-edge", "0.3", "--regions", "--max-vertices", "7", "--json", "r.json"});
      EXPECT_EQ(ran.exit_code, 4) << ran;
      const nlohmann::json report = nlohmann::json::parse(read("r.json"));
      int compared = 0;
      for (const nlohmann::json& violation : report["certificate"]["violations"]) {
        const auto number = [&](std::size_t i) { return std::to_string(violation["ids"][i].get<int>() + first); };
        if (violation["kind"] == "long_edge" && ++compared <= 10) {
          EXPECT_TRUE(
              holds(ran.err, {"edge " + number(0) + "-" + number(1) + " of triangle " + number(2) + ": length"}))
              << output;
        } else if (violation["kind"] == "region_area") {
          EXPECT_TRUE(holds(ran.err, {"triangle " + number(0) + ": area ",
                                      "the cap of region " + std::to_string(1 + of_domain) + ", at"}))
              << output;
        }
      }
      EXPECT_GE(compared, 10) << ran;
      EXPECT_TRUE(holds(ran.err, {std::string("numbers are those of ") + output, "--json counts from 0"})) << ran;
    }
  }
}

/// Point 0 is outside, points 1 and 2 are one, and the segment from point 1 to 4 is not Delaunay.
TEST_F(NumbersOfFile, are_those_of_the_written_files_in_the_check_of_triangle) {
  for (const int first : {0, 1}) {
    const auto n = [&](int i) { return std::to_string(i + first) + " "; };
    write("d.poly", "6 2 0 0\n" + n(0) + "9 9\n" + n(1) + "0 0\n" + n(2) + "0 0\n" + n(3) + "2 -0.5\n" + n(4) +
                        "4 0\n" + n(5) + "2 0.5\n5 0\n" + n(0) + n(1) + n(3) + "\n" + n(1) + n(3) + n(4) + "\n" + n(2) +
                        n(4) + n(5) + "\n" + n(3) + n(5) + n(2) + "\n" + n(4) + n(1) + n(4) + "\n0\n");
    const auto said = [&](int a, int b, int apex) {
      return "edge " + std::to_string(a + first) + "-" + std::to_string(b + first) + " of triangles " +
             std::to_string(first) + " and " + std::to_string(1 + first) + " is not locally Delaunay: vertex " +
             std::to_string(apex + first) + " (2, 0.5)";
    };
    EXPECT_TRUE(holds(pardel({"triangle", "-pDS0C", "d"}).err, {said(4, 1, 5)})) << pardel({"triangle", "-pDS0C", "d"});
    EXPECT_TRUE(holds(read("d.1.node"), {"\n" + n(1) + "0 0 ", "\n" + n(4) + "4 0 ", "\n" + n(5) + "2 0.5 "}));
    EXPECT_TRUE(holds(pardel({"triangle", "-pDjS0C", "d"}).err, {said(2, 0, 3)}))
        << pardel({"triangle", "-pDjS0C", "d"});
    EXPECT_TRUE(holds(read("d.1.node"), {"\n" + n(0) + "0 0 ", "\n" + n(2) + "4 0 ", "\n" + n(3) + "2 0.5 "}));
  }
}

}  // namespace
}  // namespace pardel::testing
