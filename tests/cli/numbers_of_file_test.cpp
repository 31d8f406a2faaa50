// Messages about the file of a mesh name its nodes by the numbers that they have there, and its edges, which have none,
// by the numbers of their ends.
#include <nlohmann/json.hpp>
#include <string>

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
  write("m.node", "5 2 0 0\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n5 1 1\n");
  write("m.ele", "4 3 0\n1 1 2 5\n2 2 3 5\n3 3 4 5\n4 4 1 5\n");
  write("m.poly", "0 2 0 0\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 2 4\n0\n");
  write("sizes.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\n1 1\n1 1\n");
  const Ran ran = pardel({"mesh", "m.node", "--refine", "-o", "r.vtu", "--sizes", "sizes.asc"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"m.node: Point 5 at (1, 1) lies in the interior of segment 5."})) << ran;
}

}  // namespace
}  // namespace pardel::testing
