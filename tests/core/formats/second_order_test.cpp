// Elements of second order in .msh and .vtu: triangles of six nodes, lines of three.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/formats.hpp"
#include "../../../core/formats/middles.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"
#include "broken_text.hpp"

namespace pardel {
namespace {

Status write_second_order(const Mesh& mesh, const std::filesystem::path& file, MshEncoding msh = MshEncoding::binary) {
  return write_mesh(mesh, {}, file, MeshFileOptions{.msh = msh, .elements = ElementOrder::second});
}

TEST(SecondOrder, middles_are_those_of_all_edges_once) {
  const Mesh mesh = sample_mesh();
  const files::Middles middles = files::middles_of(mesh);
  EXPECT_EQ(middles.edges.size(), 8U);
  EXPECT_EQ(middles.point(mesh, middles.of_triangle(0)[0]), (Point{1, 0}));
  EXPECT_EQ(middles.point(mesh, middles.of_triangle(0)[1]), (Point{1.5, 0.5}));
  EXPECT_EQ(middles.point(mesh, middles.of_triangle(0)[2]), (Point{0.5, 0.5}));
  EXPECT_EQ(middles.of_triangle(0)[1], middles.of_triangle(1)[2]);
  EXPECT_EQ(middles.point(mesh, middles.of_line[4]), (Point{1.5, 1.5}));
}

TEST(SecondOrder, an_edge_that_is_no_edge_of_a_triangle_has_a_middle_too) {
  Mesh mesh = sample_mesh();
  mesh.constrained_edges.push_back({4, 5, no_index, 1});
  mesh.constrained_edges.push_back({1, 0, no_index, 1});  // the first one again
  const files::Middles middles = files::middles_of(mesh);
  EXPECT_EQ(middles.point(mesh, middles.of_line[5]), (Point{3, 3}));
  EXPECT_EQ(middles.of_line[6], middles.of_line[0]);
}

TEST(SecondOrder, msh_has_triangles_of_type_9_and_lines_of_type_8) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_second_order(sample_mesh(), folder / "m.msh", MshEncoding::ascii).ok());
  const std::string text = folder.read("m.msh");
  EXPECT_NE(text.find("\n1 5 8 1\n"), std::string::npos) << text;  // marker 5: one line
  EXPECT_NE(text.find("\n2 7 9 2\n"), std::string::npos) << text;  // region 7: two triangles
  EXPECT_NE(text.find("\n2 2 3 "), std::string::npos) << "the line with the tag 2 from node 2 to 3";
}

/// The markers of all nodes of a .vtu: vertices, then middles.
std::vector<std::int32_t> markers_of_nodes(const std::string& vtu, std::size_t nodes) {
  const std::string offset = "offset=\"", data = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t array = vtu.find("Name=\"marker\"", vtu.find("<PointData>"));
  const std::size_t begin = std::stoul(vtu.substr(vtu.find(offset, array) + offset.size()));
  std::vector<std::int32_t> markers(nodes);
  // The number of bytes precedes the values.
  std::memcpy(markers.data(), &vtu[vtu.find(data) + data.size() + begin + sizeof(std::uint64_t)],
              nodes * sizeof(std::int32_t));
  return markers;
}

TEST(SecondOrder, middles_in_a_vtu_have_the_markers_of_their_edges) {
  const TemporaryFolder folder;
  const Mesh mesh = sample_mesh();
  ASSERT_TRUE(write_second_order(mesh, folder / "m.vtu").ok());
  const std::size_t vertices = mesh.points.size(), middles = files::middles_of(mesh).edges.size();
  std::vector<std::int32_t> markers = markers_of_nodes(folder.read("m.vtu"), vertices + middles);
  EXPECT_TRUE(std::equal(mesh.point_markers.begin(), mesh.point_markers.end(), markers.begin()));
  markers.erase(markers.begin(), markers.begin() + static_cast<std::ptrdiff_t>(vertices));
  std::ranges::sort(markers);
  EXPECT_EQ(markers, (std::vector<std::int32_t>{-4, 0, 0, 0, 0, 1, 1, 5}));
}

TEST(SecondOrder, files_are_read_as_the_mesh_of_first_order) {
  const TemporaryFolder folder;
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary}) {
    ASSERT_TRUE(write_second_order(sample_mesh(), folder / "m.msh", encoding).ok());
    const auto msh = read_mesh(folder / "m.msh");
    ASSERT_TRUE(msh.ok()) << msh.error().message;
    EXPECT_EQ(msh->points, sample_mesh().points);
    EXPECT_EQ(digest(*msh), digest(sample_mesh()));
  }
  for (const char* name : {"m.vtu", "m.ele"}) {
    ASSERT_TRUE(write_second_order(sample_mesh(), folder / name).ok());
    const auto read = read_mesh(folder / name);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(*read, sample_mesh()) << name;
  }
}

TEST(SecondOrder, fields_at_points_have_the_means_of_the_ends_at_middles) {
  Mesh mesh = sample_mesh();
  mesh.fields = {{"xy", Field::Place::points, 2, {}}, {"t", Field::Place::triangles, 1, {}}};
  for (const Point& p : mesh.points) {
    mesh.fields[0].values.push_back(p.x);
    mesh.fields[0].values.push_back(p.y);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.fields[1].values.push_back(static_cast<double>(t));
  const files::Middles middles = files::middles_of(mesh);
  const std::vector<Field> fields = files::with_middles(mesh.fields, middles);
  ASSERT_EQ(fields[0].values.size(), 2 * (mesh.points.size() + middles.edges.size()));
  for (std::size_t m = 0; m < middles.edges.size(); ++m) {
    const std::size_t at = 2 * (mesh.points.size() + m);
    EXPECT_EQ((Point{fields[0].values[at], fields[0].values[at + 1]}), middles.point(mesh, m));
  }
  EXPECT_EQ(fields[1], mesh.fields[1]);
  const TemporaryFolder folder;
  for (const char* name : {"m.msh", "m.vtu"}) {
    ASSERT_TRUE(write_second_order(mesh, folder / name).ok());
    const auto read = read_mesh(folder / name);
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->fields.size(), 2U) << name;
    EXPECT_EQ(read->fields[0], mesh.fields[0]) << name;
    EXPECT_EQ(read->left_out.things(), std::vector<std::string>{"the middle nodes of triangles"}) << name;
  }
}

TEST(SecondOrder, middles_between_vertices_leave_values_and_numbers_of_the_vertices) {
  const TemporaryFolder folder;
  const auto mesh = read_mesh(folder.write(
      "m.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 1 1 0\n5 0 2 0\n6 0 1 0\n"
      "$EndNodes\n$Elements\n1\n1 9 0 1 3 5 2 4 6\n$EndElements\n"
      "$NodeData\n1\n\"T\"\n1\n0\n3\n0\n1\n6\n1 10\n2 20\n3 30\n4 40\n5 50\n6 60\n$EndNodeData\n"));
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  ASSERT_EQ(mesh->points.size(), 3U);
  EXPECT_EQ(mesh->triangles[0].v, (std::array<Index, 3>{0, 1, 2}));
  const std::array<double, 3> values{10, 30, 50};
  ASSERT_EQ(mesh->fields.size(), 1U);
  EXPECT_TRUE(std::ranges::equal(mesh->fields[0].values, values));
  EXPECT_EQ(number_in_file(*mesh, 1), 3U);
  EXPECT_EQ(number_in_file(*mesh, 2), 5U);
}

/// The files of a triangle of six nodes, whose node in the middle of (0, 0) and (2, 0) is at (1, `y`): a .msh, a .vtu
/// with points of a type, and a .ele with its .node.
std::string curved_msh(const std::string& y) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n10 0 0 0\n20 2 0 0\n30 0 2 0\n40 1 " + y +
         " 0\n50 1 1 0\n60 0 1 0\n$EndNodes\n$Elements\n1\n7 9 0 10 20 30 40 50 60\n$EndElements\n";
}
std::string curved_vtu(const std::string& y, const std::string& type = "Float64") {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"6\" NumberOfCells=\"1\">\n"
         "<Points><DataArray type=\"" +
         type + "\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 2 0 0 0 2 0 1 " + y +
         " 0 1 1 0 0 1 0</DataArray></Points>\n"
         "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5</DataArray>"
         "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">6</DataArray>"
         "<DataArray type=\"Int32\" Name=\"types\" format=\"ascii\">22</DataArray></Cells>"
         "</Piece></UnstructuredGrid></VTKFile>";
}
Result<Mesh> read_curved_ele(const TemporaryFolder& folder, const std::string& y) {
  folder.write("c.node", "6 2 0 0\n1 0 0\n2 2 0\n3 0 2\n4 1 1\n5 0 1\n6 1 " + y + "\n");
  return read_mesh(folder.write("c.ele", "1 6 0\n1 1 2 3 4 5 6\n"));
}

TEST(SecondOrder, a_middle_node_that_is_not_in_the_middle_of_its_edge_is_refused) {
  const TemporaryFolder folder;
  for (const std::string y : {"0.25", "1e-07", "-0.001"}) {
    const auto expected = [&](const std::string& before, int middle, int a, int b) {
      return before + "the middle node " + std::to_string(middle) + " is at (1, " + y +
             "), not in the middle of the edge from node " + std::to_string(a) + " to node " + std::to_string(b) +
             ", (1, 0); curved edges are not supported";
    };
    EXPECT_EQ(message_of(read_mesh(folder.write("c.msh", curved_msh(y))), folder),
              expected("c.msh:15: element 7: ", 40, 10, 20));
    EXPECT_EQ(message_of(read_mesh(folder.write("c.vtu", curved_vtu(y))), folder),
              expected("c.vtu:3: array \"connectivity\": ", 3, 0, 1));
    EXPECT_EQ(message_of(read_curved_ele(folder, y), folder), expected("c.ele:2: ", 6, 1, 2));
  }
}

TEST(SecondOrder, a_line_of_three_nodes_is_straight_too) {
  const TemporaryFolder folder;
  std::string text = curved_msh("0");
  text.replace(text.find("1\n7 9 0"), 2, "2\n5 8 0 10 30 50\n");
  EXPECT_EQ(message_of(read_mesh(folder.write("l.msh", text)), folder),
            "l.msh:15: element 5: the middle node 50 is at (1, 1), not in the middle of the edge from node 10 to node "
            "30, (0, 1); curved edges are not supported");
}

TEST(SecondOrder, a_middle_node_may_be_rounded_as_the_numbers_of_the_file_are) {
  const TemporaryFolder folder;
  for (const std::string y : {"0", "1e-15", "-1e-10"}) {
    EXPECT_TRUE(read_mesh(folder.write("r.msh", curved_msh(y))).ok()) << y;
    EXPECT_TRUE(read_mesh(folder.write("r.vtu", curved_vtu(y))).ok()) << y;
    EXPECT_TRUE(read_curved_ele(folder, y).ok()) << y;
  }
  EXPECT_TRUE(read_mesh(folder.write("r.vtu", curved_vtu("1e-7", "Float32"))).ok());
  EXPECT_FALSE(read_mesh(folder.write("r.vtu", curved_vtu("0.01", "Float32"))).ok());
}

TEST(SecondOrder, a_middle_node_may_be_a_little_off_along_its_edge_as_those_of_gmsh_are) {
  const TemporaryFolder folder;
  const auto at = [&](const std::string& x) {
    return read_mesh(folder.write("a.msh", replaced(curved_msh("0"), "40 1 0", "40 " + x + " 0")));
  };
  EXPECT_TRUE(at("1.000003").ok());
  EXPECT_FALSE(at("1.01").ok());
  EXPECT_FALSE(at("0.5").ok()) << "at a quarter, as at the tip of a crack";
}

TEST(SecondOrder, middles_of_short_edges_far_from_the_origin_are_read_back) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  for (Point& p : mesh.points) p = {1e7 / 3 + p.x * 1e-8, 1e9 / 7 + p.y * 1e-7};
  for (const char* name : {"m.msh", "m.vtu", "m.ele"}) {
    ASSERT_TRUE(write_second_order(mesh, folder / name).ok());
    const auto read = read_mesh(folder / name);
    EXPECT_TRUE(read.ok()) << read.error().message;
  }
}

TEST(SecondOrder, gmsh_reads_the_file) {
  if (std::string(PARDEL_GMSH).empty()) GTEST_SKIP() << "gmsh is not installed";
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  ASSERT_TRUE(write_second_order(mesh, folder / "ours.msh").ok());
  const std::string command = std::string(PARDEL_GMSH) + " -v 2 -save -format msh22 -o " +
                              (folder / "theirs.msh").string() + " " + (folder / "ours.msh").string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto read = read_mesh(folder / "theirs.msh");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->triangles.size(), mesh.triangles.size());
  EXPECT_EQ(read->constrained_edges.size(), mesh.constrained_edges.size());
  EXPECT_NE(folder.read("theirs.msh").find(" 9 2 7 7 "), std::string::npos) << folder.read("theirs.msh");
}

TEST(SecondOrder, errors_name_the_line_and_the_node) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_second_order(sample_mesh(), folder / "m.msh", MshEncoding::ascii).ok());
  const std::string text = folder.read("m.msh");
  const std::size_t at = text.find("\n2 7 9 2\n") + 9;
  std::string wrong = text;
  wrong.insert(text.find('\n', at), "9");  // the last node of the triangle
  const std::string message = message_of(read_mesh(folder.write("w.msh", wrong)), folder);
  EXPECT_TRUE(message.starts_with("w.msh:")) << message;
  EXPECT_NE(message.find("there is no node "), std::string::npos) << message;
}

TEST(SecondOrder, is_refused_for_other_formats) {
  const TemporaryFolder folder;
  for (const char* name : {"m.off", "m.vtk", "m.2dm", "m.gr3", "m.inp", "m.svg"}) {
    const Status written = write_second_order(sample_mesh(), folder / name);
    ASSERT_FALSE(written.ok()) << name;
    EXPECT_EQ(written.error().kind, ErrorKind::usage);
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
}

}  // namespace
}  // namespace pardel
