#include <gtest/gtest.h>

#include <vector>

#include "../../../core/formats.hpp"
#include "../../../core/neighbours.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

/// A square ring of eight triangles around a square island. The marker of the outer edge on the right is 2.
Mesh ring() {
  Mesh mesh;
  for (const Point& p : {Point{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}}) mesh.points.push_back(p);
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    mesh.triangles.push_back({{i, j, i + 4}, {}});
    mesh.triangles.push_back({{j, j + 4, i + 4}, {}});
    mesh.constrained_edges.push_back({i, j, no_index, i == 1 ? 2 : 1});
    mesh.constrained_edges.push_back({j + 4, i + 4, no_index, 4});
  }
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  return mesh;
}

std::string boundaries(const TemporaryFolder& folder, const Mesh& mesh, const std::vector<int>& open) {
  EXPECT_TRUE(write_gr3(mesh, folder / "m.gr3", open).ok());
  const std::string text = folder.read("m.gr3");
  const std::size_t at = text.find(" = number of open boundaries");
  return at == std::string::npos ? "" : text.substr(text.rfind('\n', at) + 1);
}

TEST(Gr3, has_nodes_with_depths_then_elements_then_boundaries) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_gr3(sample_mesh(), folder / "m.gr3").ok());
  EXPECT_EQ(folder.read("m.gr3"),
            "pardel\n4 6 = numbers of elements and nodes\n1 0 0 0.5\n2 2 0 1.5\n3 2 2 0.1\n4 0 2 -3\n5 1 1 1e-300\n"
            "6 5 5 1e+300\n1 3 1 2 5\n2 3 2 3 5\n3 3 3 4 5\n4 3 4 1 5\n0 = number of open boundaries\n"
            "0 = number of nodes of all open boundaries\n1 = number of land boundaries\n"
            "5 = number of nodes of all land boundaries\n5 0 = number of nodes of land boundary 1\n1\n2\n3\n4\n1\n");
}

TEST(Gr3, land_around_an_island_is_of_type_1_clockwise_and_not_repeated) {
  const TemporaryFolder folder;
  EXPECT_EQ(boundaries(folder, ring(), {}),
            "0 = number of open boundaries\n0 = number of nodes of all open boundaries\n"
            "2 = number of land boundaries\n9 = number of nodes of all land boundaries\n"
            "5 0 = number of nodes of land boundary 1\n1\n2\n3\n4\n1\n"
            "4 1 = number of nodes of land boundary 2\n6\n5\n8\n7\n");
}

TEST(Gr3, edges_with_an_open_marker_are_open_boundaries_that_share_their_ends_with_the_land) {
  const TemporaryFolder folder;
  EXPECT_EQ(boundaries(folder, ring(), {2}),
            "1 = number of open boundaries\n2 = number of nodes of all open boundaries\n"
            "2 = number of nodes of open boundary 1\n2\n3\n"
            "2 = number of land boundaries\n8 = number of nodes of all land boundaries\n"
            "4 0 = number of nodes of land boundary 1\n3\n4\n1\n2\n"
            "4 1 = number of nodes of land boundary 2\n6\n5\n8\n7\n");
  const std::vector<ConstrainedEdge> edges = read_mesh(folder / "m.gr3")->constrained_edges;
  ASSERT_EQ(edges.size(), 8U);
  EXPECT_EQ(edges[0], (ConstrainedEdge{1, 2, no_index, 2}));
  EXPECT_EQ(edges[1].marker, 1);
}

TEST(Gr3, an_open_marker_that_no_edge_of_the_boundary_has_is_an_error_and_no_file_is_made) {
  const TemporaryFolder folder;
  const Status written = write_gr3(ring(), folder / "m.gr3", std::vector<int>{2, 9});
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::usage);
  EXPECT_EQ(message_of(written, folder),
            "m.gr3: no edge of the boundary has the marker 9, which shall be an open boundary");
  EXPECT_FALSE(std::filesystem::exists(folder / "m.gr3"));
}

TEST(Gr3, is_read_as_it_was_written_also_as_fort_14) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_mesh(sample_mesh(), {}, folder / "fort.14").ok());
  const auto read = read_mesh(folder / "fort.14");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->points, sample_mesh().points);
  EXPECT_EQ(read->triangles, sample_mesh().triangles);
  EXPECT_EQ(read->point_attributes, sample_mesh().point_attributes);
}

TEST(Gr3, of_other_programs_may_have_any_title_comments_and_no_boundaries) {
  const TemporaryFolder folder;
  for (const std::string title : {"", "# grid", "2 7"}) {
    const auto read = read_mesh(folder.write("m.gr3", title + "\n1 3 ! NE NP\n1 0 0 5\n2 1 0 6\n3 0 1 7\n1 3 1 2 3\n"));
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->triangles.size(), 1U);
    EXPECT_TRUE(read->constrained_edges.empty());
  }
}

TEST(Gr3, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  const auto failure = [&](const std::string& text) {
    return message_of(read_mesh(folder.write("m.gr3", text)), folder);
  };
  const std::string grid = "title\n1 3\n1 0 0 5\n2 1 0 6\n3 0 1 7\n";
  EXPECT_EQ(failure(""), "m.gr3:1: expected the number of elements, found the end of the file");
  EXPECT_EQ(failure("title\n1 3\n1 0 0 5\n3 1 0 6\n3 0 1 7\n1 3 1 2 3\n"),
            "m.gr3:4: expected node 2 (numbers are consecutive), found 3");
  EXPECT_EQ(failure("title\n1 3\n1 0 x 5\n2 1 0 6\n3 0 1 7\n1 3 1 2 3\n"),
            "m.gr3:3: expected a y coordinate, found \"x\"");
  EXPECT_EQ(
      failure(grid + "1 4 1 2 3 3\n"),
      "m.gr3:6: expected the number of nodes of an element (only triangles are read), a whole number from 3 to 3, "
      "found \"4\"");
  EXPECT_EQ(failure(grid + "1 3 1 2 4\n"), "m.gr3:6: expected a node, a whole number from 1 to 3, found \"4\"");
  EXPECT_EQ(failure(grid + "1 3 1 2 3\n1\n2\n2\n1\n7\n"),
            "m.gr3:11: expected a node of a boundary, a whole number from 1 to 3, found \"7\"");
  EXPECT_EQ(failure(grid + "1 3 1 2 3\n1\n2\n2\n1\n"),
            "m.gr3:11: expected node of a boundary 2 of 2, found the end of the file");
  EXPECT_EQ(failure("title\n4000000000 1\n"), "m.gr3:2: announces more than a mesh can hold");
}

}  // namespace
}  // namespace pardel
