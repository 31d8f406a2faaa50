#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/formats.hpp"
#include "../../../core/formats/mesh_readers.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"
#include "broken_text.hpp"

namespace pardel {
using namespace files;
namespace {

/// A file like those of Gmsh: points, boundary entities, a parametric node, and a section that the reader skips.
constexpr const char* ascii = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 20 "mid # wall"
2 1 "left"
2 2 "region 2.5"
$EndPhysicalNames
$Entities
1 1 2 0
1 0 0 0 0
7 0 0 0 1 1 0 1 20 2 1 -1
3 0 0 0 1 1 0 1 1 1 7
4 0 0 0 1 1 0 1 -2 1 7
$EndEntities
$Nodes
3 4 2 9
0 1 0 1
9
0 1 3
1 7 1 1
5
1 1 0 0.5
2 3 0 2
2
3
0 0 0
1 0 0
$EndNodes
$Comment
2 3 0 nonsense
$EndComment
$Elements
4 4 1 4
0 1 15 1
1 9
1 7 1 1
2 2 5
2 3 2 1
3 2 3 5
2 4 2 1
4 2 5 9
$EndElements
)";

std::string failure_of_msh(const std::string& text) { return message_of_invalid(parse_msh(text, "f")); }

/// The sample mesh as the MSH reader returns it: triangles sorted by region, edges sorted by marker, and without the
/// data that MSH cannot store.
Mesh sorted_sample() {
  Mesh mesh = sample_mesh();
  mesh.point_markers.clear();
  mesh.point_attributes.clear();
  mesh.attributes_per_point = 0;
  const auto t = mesh.triangles;
  mesh.triangles[0] = {t[0].v, {2, 3, no_index}};
  mesh.triangles[1] = {t[2].v, {3, 2, no_index}};
  mesh.triangles[2] = {t[1].v, {1, 0, no_index}};
  mesh.triangles[3] = {t[3].v, {0, 1, no_index}};
  for (std::size_t i = 0; i < 4; ++i) mesh.region[i] = i < 2 ? 0 : 1;
  std::stable_sort(mesh.constrained_edges.begin(), mesh.constrained_edges.end(),
                   [](const auto& a, const auto& b) { return a.marker < b.marker; });
  return mesh;
}

TEST(Msh, reads_back_as_the_same_mesh_with_triangles_in_another_order) {
  const TemporaryFolder folder;
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary}) {
    ASSERT_TRUE(write_msh(sample_mesh(), folder / "m.msh", encoding).ok());
    const auto read = read_mesh(folder / "m.msh");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(*read, sorted_sample());
    EXPECT_EQ(digest(*read), digest(sample_mesh()));
  }
}

TEST(Msh, makes_regions_and_markers_physical_groups_whose_tags_are_their_values_if_possible) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_msh(sample_mesh(), folder / "m.msh", MshEncoding::ascii).ok());
  EXPECT_NE(folder.read("m.msh").find("$PhysicalNames\n6\n1 2 \"marker -4\"\n1 3 \"marker 0\"\n1 1 \"marker 1\"\n"
                                      "1 5 \"marker 5\"\n2 1 \"region 2.5\"\n2 7 \"region 7\"\n$EndPhysicalNames"),
            std::string::npos);
}

TEST(Msh, numbers_its_elements_from_1_without_gaps) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_msh(sample_mesh(), folder / "m.msh", MshEncoding::ascii).ok());
  std::istringstream text(folder.read("m.msh"));
  for (std::string line; std::getline(text, line) && line != "$Elements";) {
  }
  std::size_t blocks = 0, elements = 0, least = 0, most = 0;
  std::set<std::size_t> numbers;
  text >> blocks >> elements >> least >> most;
  EXPECT_EQ(elements, 9u);
  EXPECT_EQ(least, 1u);
  EXPECT_EQ(most, 9u);
  for (; blocks > 0; --blocks) {
    std::size_t dimension = 0, tag = 0, type = 0, members = 0, corner = 0;
    text >> dimension >> tag >> type >> members;
    for (; members > 0; --members) {
      std::size_t number = 0;
      text >> number >> corner >> corner;
      if (dimension == 2) text >> corner;
      EXPECT_TRUE(numbers.insert(number).second) << number;
    }
  }
  EXPECT_EQ(numbers.size(), 9u);
  EXPECT_EQ(*numbers.begin(), 1u);
  EXPECT_EQ(*numbers.rbegin(), 9u);
}

TEST(Msh, gives_each_entity_the_box_around_its_elements) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_msh(sample_mesh(), folder / "m.msh", MshEncoding::ascii).ok());
  EXPECT_NE(folder.read("m.msh").find("\n1 0 0 0 2 2 0 1 1 0\n"), std::string::npos) << folder.read("m.msh");
  EXPECT_NE(folder.read("m.msh").find("\n5 2 0 0 2 2 0 1 5 0\n"), std::string::npos) << folder.read("m.msh");
}

TEST(Msh, takes_the_tag_of_a_group_whose_name_is_no_value) {
  const auto markers = [](const std::string& name) {
    const Result<Mesh> mesh = parse_msh(replaced(ascii, "mid # wall", name.c_str()), "f");
    EXPECT_TRUE(mesh.ok()) << mesh.error().message;
    std::set<int> all;
    for (const ConstrainedEdge& edge : mesh->constrained_edges) all.insert(edge.marker);
    return all;
  };
  const std::set<int> by_tag = markers("wall");
  EXPECT_TRUE(by_tag.contains(20));
  for (const char* name : {"marker 1.5", "marker x", "marker 5x", "marker 1e300", "marker -1e300", "marker nan"})
    EXPECT_EQ(markers(name), by_tag) << name;
  for (const int value : {5, -2147483647 - 1, 2147483647}) {
    EXPECT_TRUE(markers("marker " + std::to_string(value)).contains(value));
    EXPECT_FALSE(markers("marker " + std::to_string(value)).contains(20));
  }
}

TEST(Msh, keeps_triangles_that_have_no_region) {
  const TemporaryFolder folder;
  Mesh mesh = sorted_sample();
  mesh.region[2] = mesh.region[3] = no_index;
  mesh.region_attributes = {2.5};
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::binary).ok());
  EXPECT_EQ(*read_mesh(folder / "m.msh"), mesh);
  mesh.region.clear();
  mesh.region_attributes.clear();
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::binary).ok());
  EXPECT_EQ(*read_mesh(folder / "m.msh"), mesh);
}

TEST(Msh, of_an_empty_mesh_can_be_read) {
  const TemporaryFolder folder;
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary}) {
    ASSERT_TRUE(write_msh({}, folder / "m.msh", encoding).ok());
    const auto read = read_mesh(folder / "m.msh");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(*read, Mesh{});
  }
}

TEST(Msh, of_another_program_gives_vertices_in_the_order_of_tags_and_groups_by_name_or_tag) {
  const auto mesh = parse_msh(ascii, "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(std::vector<Point>(mesh->points.begin(), mesh->points.end()),
            (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  ASSERT_EQ(mesh->triangles.size(), 2u);
  EXPECT_EQ(mesh->triangles[0], (Triangle{{0, 1, 2}, {no_index, 1, no_index}}));
  EXPECT_EQ(mesh->triangles[1], (Triangle{{0, 2, 3}, {no_index, no_index, 0}}));
  EXPECT_EQ(mesh->region_attributes, (std::vector<double>{1, 2.5}));
  EXPECT_EQ(mesh->region[0], 0u);
  EXPECT_EQ(mesh->region[1], 1u);
  EXPECT_EQ(mesh->constrained_edges, (std::vector<ConstrainedEdge>{{0, 2, no_index, 20}}));
}

TEST(Msh, may_end_with_the_last_letter_of_an_unknown_section) {
  const std::string end = ascii + std::string("$Comments\nnone\n$EndComments");
  const auto mesh = parse_msh(end, "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(*mesh, *parse_msh(ascii, "f"));
  EXPECT_EQ(message_of_invalid(parse_msh(end + "\nrest", "f")), message_of_invalid(parse_msh(end + "\nrest\n", "f")));
}

TEST(Msh, of_version_2_is_read_as_ascii) {
  const auto mesh = parse_msh(R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
10 0 0 0
20 1 0 0
30 1 1 0
40 0 1 0
$EndNodes
$Elements
4
1 15 2 0 1 10
2 1 2 6 1 10 20
3 2 2 3 1 10 20 30
4 2 0 10 30 40
$EndElements
)",
                              "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->points.size(), 4u);
  EXPECT_EQ(mesh->triangles[1], (Triangle{{0, 2, 3}, {no_index, no_index, 0}}));
  EXPECT_EQ(mesh->region_attributes, (std::vector<double>{3}));
  EXPECT_EQ(mesh->region[1], no_index);
  EXPECT_EQ(mesh->constrained_edges, (std::vector<ConstrainedEdge>{{0, 1, no_index, 6}}));
}

TEST(Msh, has_one_group_for_each_attribute_in_any_order_of_the_regions) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.region_attributes = {7, 2.5, 7};
  mesh.region.clear();
  mesh.region.append(std::vector<Index>{0, 1, 2, 1});
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::ascii).ok());
  const auto read = read_mesh(folder / "m.msh");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->region_attributes, (std::vector<double>{2.5, 7}));
  for (std::size_t t = 0; t < 4; ++t) {
    const auto corners = read->triangles[t].v;
    const auto original = std::ranges::find(mesh.triangles, corners, &Triangle::v);
    ASSERT_NE(original, mesh.triangles.end());
    const Index region = mesh.region[static_cast<std::size_t>(original - mesh.triangles.begin())];
    EXPECT_EQ(read->region_attributes[read->region[t]], mesh.region_attributes[region]) << t;
  }
}

TEST(Msh, errors_name_the_line_and_the_fault) {
  const auto failure = [&](const char* from, const char* to) { return failure_of_msh(replaced(ascii, from, to)); };
  EXPECT_EQ(failure_of_msh(""), "f:1: expected $MeshFormat, found the end of the file");
  EXPECT_EQ(failure_of_msh("\x7f"
                           "ELF"),
            "f:1: expected $MeshFormat, found \"\\x7fELF\"");
  EXPECT_EQ(failure("4.1 0", "4 0"), "f:2: expected version 4.1 or 2.x of the format");
  EXPECT_EQ(failure("4.1 0 8", "4.1 0 4"),
            "f:2: expected the size of a number, 8, a whole number from 8 to 8, found \"4\"");
  EXPECT_EQ(failure("9\n0 1 3\n", "9\n0 x 3\n"), "f:21: expected a y coordinate, found \"x\"");
  EXPECT_EQ(failure("0 1 3\n1 7", "0 nan 3\n1 7"),
            "f:21: expected a y coordinate, finite and within the range of a double, found \"nan\"");
  EXPECT_EQ(failure("1 7 1 1\n5", "1 7 1 1\n9"), "f:29: two nodes have the tag 9");
  EXPECT_EQ(failure("1 7 1 1\n5", "1 7 1 1\n0"), "f:23: expected a node's tag greater than 0");
  EXPECT_EQ(failure("1 7 1 1\n5", "1 7 1 100000\n5"),
            "f:22: announces 100000 nodes, but the rest of the file is too short for that");
  EXPECT_EQ(failure("3 4 2 9", "3 5 2 9"), "f:29: expected 5 nodes, found 4");
  EXPECT_EQ(failure("2 3 5\n", "2 3 6\n"), "f:41: there is no node 6");
  EXPECT_EQ(failure("2 3 2 1\n", "2 3 3 1\n"),
            "f:40: an element is of type 3, neither a line (1) nor a triangle (2) nor a point (15)");
  EXPECT_EQ(failure("4 4 1 4", "4 5 1 4"), "f:43: expected 5 elements, found 4");
  EXPECT_EQ(failure("$EndElements", "$EndElement"), "f:44: expected $EndElements, found \"$EndElement\"");
  const std::string format = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  EXPECT_EQ(failure_of_msh(format + "$Elements\n0 0 0 0\n$EndElements\n"),
            "f:7: expected $Nodes, found the end of the file");
  EXPECT_EQ(failure_of_msh(format + "$Nodes\n0 0 0 0\n$EndNodes\n"),
            "f:7: expected $Elements, found the end of the file");
  EXPECT_EQ(failure("$EndComment", ""), "f:31: the section \"$Comment\" does not end");
}

TEST(Msh, has_no_node_before_the_first_tag_or_after_the_last) {
  const auto with_corner = [](const std::string& tag) {
    return parse_msh(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n5 0 0 0\n6 1 0 0\n7 0 1 0\n$EndNodes\n"
        "$Elements\n1\n1 2 0 5 6 " +
            tag + "\n$EndElements\n",
        "f");
  };
  ASSERT_TRUE(with_corner("7").ok());
  for (const char* tag : {"1", "2", "3", "4", "8", "9", "2147483647"})
    EXPECT_EQ(message_of_invalid(with_corner(tag)), std::string("f:12: there is no node ") + tag);
}

TEST(Msh, cut_off_anywhere_is_refused) {
  const TemporaryFolder folder;
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary}) {
    ASSERT_TRUE(write_msh(sample_mesh(), folder / "m.msh", encoding).ok());
    const std::string file = folder.read("m.msh");
    for (std::size_t length = 0; length + 1 < file.size(); ++length) {
      EXPECT_FALSE(parse_msh(std::string_view(file).substr(0, length), "f").ok()) << length;
    }
  }
}

TEST(Msh, of_version_2_is_read_in_binary) {
  const auto by_meshio = read_mesh(PARDEL_FORMATS_DATA "/msh22_by_meshio.msh");
  ASSERT_TRUE(by_meshio.ok()) << by_meshio.error().message;
  EXPECT_EQ(by_meshio->points.size(), 5u);
  EXPECT_EQ(by_meshio->points[4], (Point{0.5, 0.5}));
  ASSERT_EQ(by_meshio->triangles.size(), 4u);
  EXPECT_EQ(by_meshio->region_attributes, (std::vector<double>{2.5, 7}));
  EXPECT_EQ(by_meshio->constrained_edges, (std::vector<ConstrainedEdge>{{0, 1, no_index, 3}, {1, 2, no_index, 4}}));
  const auto by_gmsh = read_mesh(PARDEL_FORMATS_DATA "/msh22_by_gmsh.msh");
  ASSERT_TRUE(by_gmsh.ok()) << by_gmsh.error().message;
  EXPECT_EQ(by_gmsh->region_attributes, (std::vector<double>{5}));
  EXPECT_EQ(by_gmsh->constrained_edges.size(), 8u);
  EXPECT_EQ(by_gmsh->constrained_edges[0].marker, 9);
}

TEST(Msh, of_version_2_in_binary_and_cut_off_anywhere_is_refused) {
  std::ifstream in(PARDEL_FORMATS_DATA "/msh22_by_gmsh.msh", std::ios::binary);
  const std::string file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::size_t end = file.rfind("$EndElements") + std::string("$EndElements").size();
  for (std::size_t length = 0; length < end; ++length)
    EXPECT_FALSE(parse_msh(std::string_view(file).substr(0, length), "f").ok()) << length;
  EXPECT_TRUE(parse_msh(file, "f").ok());
}

TEST(Msh, in_binary_gives_the_place_of_an_error_in_bytes) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.points[5].x = std::numeric_limits<double>::infinity();
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::binary).ok());
  const std::string message = message_of(read_mesh(folder / "m.msh"), folder);
  EXPECT_TRUE(message.starts_with("m.msh: byte ")) << message;
  EXPECT_TRUE(message.ends_with(": expected an x coordinate, found a number that is not finite")) << message;
}

/// Opens a file with Gmsh and saves it as `to`; returns Gmsh's messages.
std::string gmsh(const TemporaryFolder& folder, const std::string& options) {
  const std::string log = (folder / "log").string();
  const std::string command =
      "cd '" + (folder / "").string() + "' && '" PARDEL_GMSH "' " + options + " > '" + log + "' 2>&1";
  return std::system(command.c_str()) == 0 ? folder.read("log") : "gmsh failed: " + folder.read("log");
}

TEST(Msh, in_pieces_of_gmsh_is_read_by_the_name_without_the_numbers_of_partitions) {
  const auto whole = read_mesh(PARDEL_FORMATS_DATA "/partitioned_by_gmsh.msh");
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  EXPECT_EQ(whole->points.size(), 20u);
  EXPECT_EQ(whole->triangles.size(), 26u);
  EXPECT_EQ(whole->region_attributes, (std::vector<double>{7}));
  // The twelve edges of the boundary, not the four between the partitions.
  EXPECT_EQ(whole->constrained_edges.size(), 12u);
  for (const ConstrainedEdge& e : whole->constrained_edges) EXPECT_EQ(e.marker, 3);
  const auto first = read_mesh(PARDEL_FORMATS_DATA "/partitioned_by_gmsh_1.msh");
  ASSERT_TRUE(first.ok()) << first.error().message;
  EXPECT_EQ(first->triangles.size(), 14u);
}

/// Node 14 is in both pieces.
TEST(Msh, in_pieces_that_do_not_fit_is_refused_with_the_tag_of_the_node) {
  const TemporaryFolder folder;
  const std::string of_data = PARDEL_FORMATS_DATA "/partitioned_by_gmsh_";
  std::filesystem::copy_file(of_data + "1.msh", folder / "m_1.msh");
  std::ifstream in(of_data + "2.msh");
  const std::string second{std::istreambuf_iterator<char>(in), {}};
  folder.write("m_2.msh", replaced(second, "0.2886751345942123 0.5000000000011557 0", "0.25 0.5 0"));
  EXPECT_EQ(message_of(read_mesh(folder / "m.msh"), folder),
            "m.msh: different points have the number 14, at (0.25, 0.5) and (0.2886751345942123, 0.5000000000011557)");
}

TEST(Msh, is_opened_by_gmsh_without_a_warning_and_comes_back_the_same) {
  if (std::string(PARDEL_GMSH).empty()) GTEST_SKIP() << "gmsh is not installed";
  const TemporaryFolder folder;
  // Gmsh writes 16 digits. These suffice for the coordinates, but not for an infinite or tiny attribute.
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary}) {
    ASSERT_TRUE(write_msh(sample_mesh(), folder / "ours.msh", encoding).ok());
    const std::string log = gmsh(folder, "ours.msh -save_all -save -o theirs.msh -format msh41 -bin");
    for (const char* bad : {"Warning", "Error", "failed"}) EXPECT_EQ(log.find(bad), std::string::npos) << log;
    const auto theirs = read_mesh(folder / "theirs.msh");
    ASSERT_TRUE(theirs.ok()) << theirs.error().message << log;
    EXPECT_EQ(digest(*theirs), digest(sample_mesh()));
  }
}

TEST(Msh, made_by_gmsh_is_read_with_its_groups) {
  if (std::string(PARDEL_GMSH).empty()) GTEST_SKIP() << "gmsh is not installed";
  const TemporaryFolder folder;
  folder.write("two.geo", R"(Point(1)={0,0,0,0.3}; Point(2)={2,0,0,0.3}; Point(3)={2,1,0,0.3}; Point(4)={0,1,0,0.3};
Point(5)={1,0,0,0.3}; Point(6)={1,1,0,0.3};
Line(1)={1,5}; Line(2)={5,2}; Line(3)={2,3}; Line(4)={3,6}; Line(5)={6,4}; Line(6)={4,1}; Line(7)={5,6};
Line Loop(1)={1,7,5,6}; Line Loop(2)={2,3,4,-7}; Plane Surface(1)={1}; Plane Surface(2)={2};
Physical Curve("outer", 10) = {1:6}; Physical Curve("mid", 20) = {7};
Physical Surface("left", 3) = {1}; Physical Surface("right", 8) = {2};
)");
  std::vector<Digest> digests;
  for (const char* format : {"msh41", "msh22"}) {
    const std::string log = gmsh(folder, std::string("-2 two.geo -o two.msh -format ") + format);
    const auto mesh = read_mesh(folder / "two.msh");
    ASSERT_TRUE(mesh.ok()) << mesh.error().message << log;
    EXPECT_EQ(mesh->region_attributes, (std::vector<double>{3, 8}));
    for (const ConstrainedEdge& e : mesh->constrained_edges) {
      const bool mid = mesh->points[e.a].x == 1 && mesh->points[e.b].x == 1;
      EXPECT_EQ(e.marker, mid ? 20 : 10);
    }
    digests.push_back(digest(*mesh));
  }
  EXPECT_EQ(digests[0], digests[1]);
}

TEST(Msh, numbers_points_from_one) {
  const Result<Mesh> mesh = parse_msh(ascii, "f");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->first_id.value, 1);
}

TEST(Msh, knows_the_tags_of_its_points) {
  const Result<Mesh> mesh = parse_msh(ascii, "f");
  ASSERT_TRUE(mesh);
  for (Index v = 0; v < 4; ++v) EXPECT_EQ(number_in_file(*mesh, v), (std::array<unsigned, 4>{2, 3, 5, 9}[v]));
  const TemporaryFolder folder;
  ASSERT_TRUE(write_msh(*mesh, folder / "m.msh", MshEncoding::binary));
  EXPECT_EQ(number_in_file(*read_mesh(folder / "m.msh"), 3), 4U);
}

TEST(Msh, without_nodes_has_no_corners) {
  const char* text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n0\n$EndNodes\n$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n";
  EXPECT_EQ(message_of_invalid(parse_msh(text, "f")), "f:9: there is no node 1");
}

TEST(Msh, has_the_largest_int_as_a_tag) {
  Mesh mesh = sample_mesh();
  mesh.region_attributes = {2147483646, 2147483647};
  const TemporaryFolder folder;
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::ascii));
  EXPECT_NE(folder.read("m.msh").find("2 2147483647 \"region 2147483647\""), std::string::npos);
}

TEST(Msh, with_the_largest_number_of_nodes_is_too_short_and_with_one_more_cannot_be_held) {
  const auto failure = [](const std::string& nodes) {
    return message_of_invalid(parse_msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes + "\n", "f"));
  };
  EXPECT_EQ(failure("4294967293"), "f:5: announces more nodes than a mesh can hold");
  EXPECT_NE(failure("4294967292"), "f:5: announces more nodes than a mesh can hold");
}

TEST(Msh, of_version_4_with_the_largest_number_of_nodes_is_too_short_and_with_one_more_cannot_be_held) {
  const auto failure = [](const std::string& nodes) {
    return message_of_invalid(
        parse_msh("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + nodes + " 1 9\n2 1 0 1\n", "f"));
  };
  EXPECT_EQ(failure("4294967293"), "f:5: announces more nodes than a mesh can hold");
  EXPECT_NE(failure("4294967292"), "f:5: announces more nodes than a mesh can hold");
}

}  // namespace
}  // namespace pardel
