#include <gtest/gtest.h>

#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

Mesh read_2dm(const TemporaryFolder& folder, const std::string& text) {
  Result<Mesh> mesh = read_mesh(folder.write("m.2dm", text));
  EXPECT_TRUE(mesh) << mesh.error().message;
  return mesh ? std::move(*mesh) : Mesh{};
}

TEST(TwoDm, has_elements_with_materials_then_nodes_then_a_nodestring_per_chain_of_a_marker) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_2dm(sample_mesh(), folder / "m.2dm").ok());
  EXPECT_EQ(folder.read("m.2dm"),
            "MESH2D\nNUM_MATERIALS_PER_ELEM 1\nE3T 1 1 2 5 1\nE3T 2 2 3 5 7\nE3T 3 3 4 5 1\nE3T 4 4 1 5 7\n"
            "ND 1 0 0 0.5\nND 2 2 0 1.5\nND 3 2 2 0.1\nND 4 0 2 -3\nND 5 1 1 1e-300\nND 6 5 5 1e+300\n"
            "NS 4 -1 -4\nNS 3 -5 0\nNS 1 -2 1\nNS 3 -4 1\nNS 2 -3 5\n");
}

TEST(TwoDm, continues_a_nodestring_after_ten_nodes) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (int i = 0; i < 12; ++i) mesh.points.push_back({static_cast<double>(i), static_cast<double>(i * i)});
  for (Index i = 0; i + 1 < 12; ++i) mesh.constrained_edges.push_back({i, i + 1, no_index, 6});
  ASSERT_TRUE(write_2dm(mesh, folder / "m.2dm").ok());
  const std::string text = folder.read("m.2dm");
  EXPECT_TRUE(text.ends_with("NS 1 2 3 4 5 6 7 8 9 10\nNS 11 -12 6\n")) << text;
  EXPECT_EQ(read_mesh(folder / "m.2dm")->constrained_edges, mesh.constrained_edges);
}

TEST(TwoDm, of_other_programs_has_any_order_gaps_between_numbers_and_other_cards) {
  const TemporaryFolder folder;
  const Mesh mesh = read_2dm(folder,
                             "MESH2D\r\nMESHNAME \"bay\"\nE3T 7 10 30 20 4\nNS 10 20\nNS -30\nNS 30 -10 outflow\n"
                             "ND 30 0 1 -2.5\nND 10 0 0 1\nND 20 1 0\nBEGPARAMDEF\nGM \"Mesh\"\nENDPARAMDEF\n");
  EXPECT_EQ(mesh.points[2], (Point{0, 1}));
  EXPECT_EQ(mesh.triangles[0].v, (std::array<Index, 3>{0, 2, 1}));
  EXPECT_EQ(mesh.region_attributes, std::vector<double>{4});
  EXPECT_EQ(mesh.point_attributes[0], 1);
  EXPECT_EQ(mesh.point_attributes[1], 0);
  EXPECT_EQ(mesh.point_attributes[2], -2.5);
  const std::vector<ConstrainedEdge> edges = {{0, 1, no_index, 1}, {1, 2, no_index, 1}, {2, 0, no_index, 2}};
  EXPECT_EQ(mesh.constrained_edges, edges);
}

TEST(TwoDm, triangles_keep_their_numbers_for_messages) {
  const TemporaryFolder folder;
  using Numbers = std::vector<std::uint64_t>;
  const auto numbers = [&](const std::string& first, const std::string& second) {
    return read_2dm(folder, "MESH2D\nE3T " + first + " 1 2 3 1\nE3T " + second +
                                " 1 3 4 1\nND 1 0 0 0\nND 2 1 0 0\nND 3 1 1 0\nND 4 0 1 0\n");
  };
  EXPECT_EQ(numbers("101", "105").numbers.of_triangles, (Numbers{101, 105}));
  EXPECT_EQ(numbers("2", "1").numbers.of_triangles, (Numbers{2, 1}));
  EXPECT_EQ(numbers("1", "2").numbers.of_triangles, Numbers());
  EXPECT_EQ(number_of_triangle_in_file(numbers("101", "105"), 1), 105U);
  EXPECT_EQ(number_of_triangle_in_file(numbers("1", "2"), 1), 2U);
}

TEST(TwoDm, without_materials_has_no_regions) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_2dm(folder, "MESH2D\nNUM_MATERIALS_PER_ELEM 0\nE3T 1 1 2 3\nND 1 0 0 0\nND 2 1 0 0\nND 3 0 1 0\n")
                  .region_attributes.empty());
}

TEST(TwoDm, without_nodes_has_no_heights) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_2dm(folder, "MESH2D\n").attributes_per_point, 0U);
}

TEST(TwoDm, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& text) {
    return message_of(read_mesh(folder.write("m.2dm", text)), folder);
  };
  const std::string nodes = "MESH2D\nND 1 0 0 0\nND 2 1 0 0\nND 3 0 1 0\n";
  EXPECT_EQ(failure(""), "m.2dm:1: expected MESH2D, found the end of the file");
  EXPECT_EQ(failure("MESH3D\n"), "m.2dm:1: expected MESH2D, found \"MESH3D\"");
  EXPECT_EQ(failure("MESH2D\nND 1 0 zero 0\n"), "m.2dm:2: expected a y coordinate, found \"zero\"");
  EXPECT_EQ(failure("MESH2D\nND 0 0 0 0\n"),
            "m.2dm:2: expected a node's number, a whole number from 1 to 2147483647, found \"0\"");
  EXPECT_EQ(failure(nodes + "ND 2 5 5 5\n"), "m.2dm:6: two nodes have the number 2");
  EXPECT_EQ(failure(nodes + "E3T 5 1 2 3 1\nE3T 1 1 2 3 1\nE3T 5 2 3 1 1\n"),
            "m.2dm:8: two triangles have the number 5");
  EXPECT_EQ(failure(nodes + "E3T 1 1 2 4 1\n"), "m.2dm:5: there is no node 4");
  EXPECT_EQ(failure(nodes + "E3T 1 1 2 3\n"),
            "m.2dm:5: expected a material, a whole number, found the end of the line");
  EXPECT_EQ(failure(nodes + "E4Q 1 1 2 3 3 1\n"),
            "m.2dm:5: elements of type \"E4Q\" are not read, only triangles (E3T)");
  EXPECT_EQ(failure(nodes + "NS 1 9 -2\n"), "m.2dm:5: there is no node 9");
  EXPECT_EQ(failure(nodes + "NS 1 2\nE3T 1 1 2 3 1\n"),
            "m.2dm:6: the nodestring before this line has no end, a negative number");
}

}  // namespace
}  // namespace pardel
