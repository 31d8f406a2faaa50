// Meshes in Triangle's files.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {
namespace {

/// The unit square in two triangles.
constexpr const char* node = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n";
constexpr const char* ele = "2 3 0\n1 1 2 3\n2 1 3 4\n";

std::string failure_of(const TemporaryFolder& folder) { return message_of(read_mesh(folder / "m.ele"), folder); }

TEST(TriangleFiles, have_all_parts_of_the_formats) {
  const TemporaryFolder folder;
  Pslg pslg;
  pslg.holes = {{0.5, 0.25}};
  pslg.regions = {{{1, 0.5}, 2.5, 0.125}, {{1.5, 1}, 7, std::numeric_limits<double>::infinity()}};
  TriangleFiles all;
  all.write_edge = true;
  all.write_neigh = true;
  ASSERT_TRUE(write_triangle_files(sample_mesh(), pslg, folder / "m.1", all).ok());
  EXPECT_EQ(folder.names(), "m.1.edge m.1.ele m.1.neigh m.1.node m.1.poly ");
  EXPECT_EQ(folder.read("m.1.node"),
            "6 2 1 1\n1 0 0 0.5 1\n2 2 0 1.5 5\n3 2 2 0.1 5\n4 0 2 -3 1\n5 1 1 1e-300 9\n6 5 5 1e+300 0\n");
  EXPECT_EQ(folder.read("m.1.ele"), "4 3 1\n1 1 2 5 2.5\n2 2 3 5 7\n3 3 4 5 2.5\n4 4 1 5 7\n");
  EXPECT_EQ(folder.read("m.1.poly"),
            "0 2 1 1\n5 1\n1 1 2 1\n2 2 3 5\n3 3 4 1\n4 4 1 -4\n5 3 5 0\n1\n1 0.5 0.25\n"
            "2\n1 1 0.5 2.5 0.125\n2 1.5 1 7 -1\n");
  EXPECT_EQ(folder.read("m.1.edge"), "8 1\n1 2 5 0\n2 5 1 0\n3 1 2 1\n4 3 5 0\n5 2 3 5\n6 4 5 0\n7 3 4 1\n8 4 1 -4\n");
  EXPECT_EQ(folder.read("m.1.neigh"), "4 3\n1 2 4 -1\n2 3 1 -1\n3 4 2 -1\n4 1 3 -1\n");
}

TEST(TriangleFiles, leave_out_the_parts_that_the_options_exclude) {
  const TemporaryFolder folder;
  TriangleFiles files;
  files.base = 0;
  files.write_node = false;
  files.markers = false;
  ASSERT_TRUE(write_triangle_files(sample_mesh(), {}, folder / "m", files).ok());
  EXPECT_EQ(folder.names(), "m.ele m.poly ");
  EXPECT_EQ(folder.read("m.ele"), "4 3 1\n0 0 1 4 2.5\n1 1 2 4 7\n2 2 3 4 2.5\n3 3 0 4 7\n");
  EXPECT_EQ(folder.read("m.poly"), "0 2 1 0\n5 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 2 4\n0\n");
}

TEST(TriangleFiles, of_second_order_have_the_middles_of_edges_opposite_the_corners) {
  const TemporaryFolder folder;
  TriangleFiles files;
  files.second_order = true;
  ASSERT_TRUE(write_triangle_files(sample_mesh(), {}, folder / "m", files).ok());
  EXPECT_EQ(folder.read("m.node").substr(0, 7), "14 2 1 ");
  // Nodes 7 and up are the midpoints of the edges (2,5), (5,1), (1,2), (3,5), (2,3), (4,5), (3,4), (4,1).
  EXPECT_NE(folder.read("m.node").find("\n7 1.5 0.5 0.75 0\n"), std::string::npos);
  EXPECT_NE(folder.read("m.node").find("\n9 1 0 1 1\n"), std::string::npos);
  EXPECT_EQ(folder.read("m.ele"),
            "4 6 1\n1 1 2 5 7 8 9 2.5\n2 2 3 5 10 7 11 7\n3 3 4 5 12 10 13 2.5\n4 4 1 5 8 12 14 7\n");
  const auto read = read_mesh(folder / "m.ele");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(*read, sample_mesh());
  EXPECT_EQ(number_in_file(*read, 5), 6U);
}

TEST(TriangleFiles, of_second_order_keep_several_attributes_of_a_point) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (const Point& p : {Point{0, 0}, {2, 0}, {0, 2}}) mesh.points.push_back(p);
  mesh.triangles.push_back({{0, 1, 2}, {no_index, no_index, no_index}});
  mesh.attributes_per_point = 2;
  for (const double a : {1.0, 10.0, 3.0, 30.0, 5.0, 70.0}) mesh.point_attributes.push_back(a);
  TriangleFiles files;
  files.second_order = true;
  ASSERT_TRUE(write_triangle_files(mesh, {}, folder / "m", files).ok());
  EXPECT_NE(folder.read("m.node").find(" 1 1 4 50"), std::string::npos) << folder.read("m.node");
  EXPECT_NE(folder.read("m.node").find(" 0 1 3 40"), std::string::npos) << folder.read("m.node");
  EXPECT_NE(folder.read("m.node").find(" 1 0 2 20"), std::string::npos) << folder.read("m.node");
  // The middles stand before the last corner.
  folder.write("n.node", "6 2 2 0\n1 0 0 1 10\n2 1 0 2 20\n3 2 0 3 30\n4 0 2 5 70\n5 1 1 0 0\n6 0 1 0 0\n");
  folder.write("n.ele", "1 6 0\n1 1 3 4 5 6 2\n");
  const auto read = read_mesh(folder / "n.ele");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(std::vector<double>(read->point_attributes.begin(), read->point_attributes.end()),
            (std::vector<double>{1, 10, 3, 30, 5, 70}));
}

TEST(TriangleFiles, of_second_order_may_have_the_middles_before_the_corners) {
  const TemporaryFolder folder;
  // One triangle with the corners 2, 4, 6. Node 7 is in no triangle and stays.
  folder.write("m.node",
               "7 2 1 1\n1 1 0 10 1\n2 0 0 20 2\n3 1 1 30 3\n4 2 0 40 4\n5 0 1 50 5\n6 0 2 60 6\n7 9 9 70 7\n");
  folder.write("m.ele", "1 6 0\n1 2 4 6 3 5 1\n");
  folder.write("m.edge", "1 1\n1 4 6 8\n");
  const auto mesh = read_mesh(folder / "m.ele");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(std::vector<Point>(mesh->points.begin(), mesh->points.end()),
            (std::vector<Point>{{0, 0}, {2, 0}, {0, 2}, {9, 9}}));
  EXPECT_EQ(std::vector<double>(mesh->point_attributes.begin(), mesh->point_attributes.end()),
            (std::vector<double>{20, 40, 60, 70}));
  EXPECT_EQ(std::vector<int>(mesh->point_markers.begin(), mesh->point_markers.end()), (std::vector<int>{2, 4, 6, 7}));
  EXPECT_EQ(mesh->triangles[0].v, (std::array<Index, 3>{0, 1, 2}));
  EXPECT_EQ(mesh->constrained_edges, (std::vector<ConstrainedEdge>{{1, 2, no_index, 8}}));
  for (Index v = 0; v < 4; ++v) EXPECT_EQ(number_in_file(*mesh, v), (std::array<unsigned, 4>{2, 4, 6, 7}[v]));
  EXPECT_EQ(mesh->left_out.things(), std::vector<std::string>{"the middle nodes of triangles"});
}

/// Node 4 is the middle of an edge of the first triangle and a corner of the second one.
TEST(TriangleFiles, of_second_order_keep_a_middle_that_is_a_corner_elsewhere) {
  const TemporaryFolder folder;
  folder.write("m.node",
               "11 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 0\n7 2 2\n8 9 9\n9 2 1\n10 1.5 1.5\n11 1.5 0.5\n");
  folder.write("m.ele", "2 6 0\n1 1 2 3 4 5 6\n2 4 2 7 9 10 11\n");
  const auto mesh = read_mesh(folder / "m.ele");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(std::vector<Point>(mesh->points.begin(), mesh->points.end()),
            (std::vector<Point>{{0, 0}, {2, 0}, {0, 2}, {1, 1}, {2, 2}, {9, 9}}));
  EXPECT_EQ(mesh->triangles[1].v, (std::array<Index, 3>{3, 1, 4}));
}

TEST(TriangleFiles, end_with_the_command_that_made_them) {
  const TemporaryFolder folder;
  TriangleFiles files;
  files.write_edge = files.write_neigh = true;
  files.command = "pardel triangle -pqen m";
  ASSERT_TRUE(write_triangle_files(sample_mesh(), {}, folder / "m", files).ok());
  for (const std::string suffix : {".node", ".ele", ".poly", ".edge", ".neigh"}) {
    EXPECT_TRUE(folder.read("m" + suffix).ends_with("\n# Generated by pardel triangle -pqen m\n")) << suffix;
  }
  const auto read = read_mesh(folder / "m.ele");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(*read, sample_mesh());
}

TEST(TriangleFiles, read_back_as_the_same_mesh) {
  const TemporaryFolder folder;
  for (const int base : {0, 1}) {
    TriangleFiles files;
    files.base = base;
    files.write_edge = true;
    files.write_neigh = true;
    ASSERT_TRUE(write_triangle_files(sample_mesh(), {}, folder / "m", files).ok());
    const auto read = read_mesh(folder / "m.node");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(*read, sample_mesh());
  }
}

TEST(TriangleFiles, of_a_mesh_without_markers_of_points_have_none) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.point_markers.clear();
  ASSERT_TRUE(write_mesh(mesh, {}, folder / "m.node").ok());
  const auto read = read_mesh(folder / "m.node");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(*read, mesh);
}

TEST(TriangleFiles, need_only_nodes_and_elements) {
  const TemporaryFolder folder;
  folder.write("m.node", node);
  folder.write("m.ele", ele);
  const auto mesh = read_mesh(folder / "m.node");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->triangles[0], (Triangle{{0, 1, 2}, {no_index, 1, no_index}}));
  EXPECT_EQ(mesh->triangles[1], (Triangle{{0, 2, 3}, {no_index, no_index, 0}}));
  EXPECT_TRUE(mesh->region.empty());
  EXPECT_TRUE(mesh->constrained_edges.empty());
}

TEST(TriangleFiles, take_constraints_from_the_edges_if_there_is_no_poly_of_the_mesh) {
  const TemporaryFolder folder;
  folder.write("m.node", node);
  folder.write("m.ele", ele);
  folder.write("m.edge", "5 1\n1 1 2 1\n2 2 3 4\n3 3 4 1\n4 4 1 1\n5 1 3 0\n");
  // This .poly has points, so it is the input of the mesh and not a part of the mesh.
  folder.write("m.poly", "3\n1 0 0\n2 1 0\n3 1 1\n1 0\n1 1 2\n0\n");
  const auto mesh = read_mesh(folder / "m.ele");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->constrained_edges,
            (std::vector<ConstrainedEdge>{
                {0, 1, no_index, 1}, {1, 2, no_index, 4}, {2, 3, no_index, 1}, {3, 0, no_index, 1}}));
}

TEST(TriangleFiles, of_neighbours_must_agree_with_the_triangles) {
  const TemporaryFolder folder;
  folder.write("m.node", node);
  folder.write("m.ele", ele);
  folder.write("m.neigh", "2 3\n1 -1 2 -1\n2 -1 -1 1\n");
  EXPECT_TRUE(read_mesh(folder / "m.ele").ok());
  folder.write("m.neigh", "2 3\n1 -1 2 -1\n2 -1 1 -1\n");
  EXPECT_EQ(failure_of(folder), "m.neigh:3: expected neighbour -1, as the triangles have it, found 1");
  folder.write("m.neigh", "3 3\n");
  EXPECT_EQ(failure_of(folder), "m.neigh:1: expected as many triangles as the .ele has, 2");
  folder.write("m.neigh", "2 4\n");
  EXPECT_EQ(failure_of(folder),
            "m.neigh:1: expected the number of neighbours per triangle, a whole number from 3 to 3, found \"4\"");
  folder.write("m.neigh", "2 3\n1 -1 2 7\n");
  EXPECT_EQ(failure_of(folder), "m.neigh:2: expected a neighbour, a whole number from -1 to 2, found \"7\"");
}

TEST(TriangleFiles, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  EXPECT_EQ(failure_of(folder), "m.node: cannot be opened: No such file or directory");
  folder.write("m.node", node);
  EXPECT_EQ(failure_of(folder), "m.ele: cannot be opened: No such file or directory");
  const auto failure = [&](const char* text) {
    folder.write("m.ele", text);
    return failure_of(folder);
  };
  EXPECT_EQ(failure(""), "m.ele:1: expected the number of triangles, found the end of the file");
  EXPECT_EQ(failure("1 4 0\n"), "m.ele:1: expected 3 or 6 nodes per triangle, found 4");
  EXPECT_EQ(failure("1 3 0\n1 1 2 5\n"),
            "m.ele:2: expected a corner of a triangle, a whole number from 1 to 4, found \"5\"");
  EXPECT_EQ(failure("1 3 0\n1 1 2\n"),
            "m.ele:2: expected a corner of a triangle, a whole number, found the end of the line");
  EXPECT_EQ(failure("1 3 0\n0 1 2 3\n"), "m.ele:2: expected triangle 1 (numbers are consecutive), found 0");
  EXPECT_EQ(failure("1 3 1\n1 1 2 3\n"), "m.ele:2: expected a triangle's attribute, found the end of the line");
  EXPECT_EQ(failure("2 3 0\n1 1 2 3\n#...\n#...\n"), "m.ele:5: expected triangle 2 of 2, found the end of the file");
  EXPECT_EQ(failure("100000 3 0\n1 1 2 3\n"),
            "m.ele:1: announces 100000 triangles, but the rest of the file is too short for that");
  folder.write("m.ele", ele);
  folder.write("m.poly", "0 2 0 0\n1 0\n1 1 9\n0\n");
  EXPECT_EQ(failure_of(folder), "m.poly:3: expected an end of a segment, a whole number from 1 to 4, found \"9\"");
}

TEST(MeshFiles, without_a_suffix_are_known_by_their_beginning) {
  const TemporaryFolder folder;
  for (const char* name : {"m.off", "m.msh", "m.vtu", "m.vtk", "m.2dm"}) {
    ASSERT_TRUE(write_mesh(sample_mesh(), {}, folder / name).ok());
    const auto named = read_mesh(folder / name);
    folder.write("mesh", folder.read(name));
    const auto nameless = read_mesh(folder / "mesh");
    ASSERT_TRUE(nameless.ok()) << nameless.error().message;
    EXPECT_EQ(*nameless, *named) << name;
  }
  folder.write("mesh", "solid");
  EXPECT_NE(read_mesh(folder / "mesh").error().message.find("must be .msh, .vtu, .off, .vtk or .2dm"),
            std::string::npos);
}

TEST(MeshFiles, are_known_by_their_suffix) {
  for (const char* name : {"a.node", "a.ele", "a b.vtu", "x/a.msh", "a.off", "a.svg"}) EXPECT_TRUE(mesh_format(name));
  for (const char* name : {"a.poly", "a", "vtu", "a.vtu.gz"}) EXPECT_FALSE(mesh_format(name));
  EXPECT_EQ(write_mesh({}, {}, "a.gz").error().kind, ErrorKind::usage);
  EXPECT_EQ(read_mesh("a.svg").error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace pardel
