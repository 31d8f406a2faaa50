// Fields and names in VTU: arrays of points and cells, field data; and files with several pieces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../../core/formats/mesh_readers.hpp"
#include "../../../core/formats/vtu_names.hpp"
#include "../../temporary_folder.hpp"
#include "../mesh_with_fields.hpp"
#include "broken_text.hpp"

namespace pardel {
using namespace files;
namespace {

using Values = std::vector<double>;
using Texts = std::vector<std::string>;

std::string array_element(const std::string& attributes, const std::string& values) {
  return "<DataArray type=\"Float64\" format=\"ascii\" " + attributes + ">" + values + "</DataArray>\n";
}

/// A piece: a triangle, a line and a triangle, which make a square with its lower left corner at (x, 0).
std::string square_piece(int x, const std::string& data = {}) {
  const std::string left = std::to_string(x) + " ", right = std::to_string(x + 1) + " ";
  return "<Piece NumberOfPoints=\"4\" NumberOfCells=\"3\">\n<Points>\n" +
         array_element("NumberOfComponents=\"3\"", left + "0 0 " + right + "0 0 " + right + "1 0 " + left + "1 0") +
         "</Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 1 0 2 3"
         "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3 5 8</DataArray>\n"
         "<DataArray type=\"Int32\" Name=\"types\" format=\"ascii\">5 3 5</DataArray></Cells>\n" +
         data + "</Piece>\n";
}
std::string vtu_of(const std::string& content) {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n" + content + "</UnstructuredGrid></VTKFile>";
}
std::string at_points(const std::string& arrays) { return "<PointData>\n" + arrays + "</PointData>\n"; }
std::string in_cells(const std::string& arrays) { return "<CellData>\n" + arrays + "</CellData>\n"; }

Mesh read_vtu_text(const std::string& content) {
  const Result<Mesh> mesh = parse_vtu(vtu_of(content), "m.vtu");
  EXPECT_TRUE(mesh) << mesh.error().message;
  return mesh ? *mesh : Mesh();
}
std::string failure_of_array(const std::string& content) { return message_of_invalid(parse_vtu(vtu_of(content), "f")); }

TEST(VtuFields, are_arrays_that_are_not_of_the_mesh) {
  const Mesh mesh = read_vtu_text(square_piece(
      0, at_points(array_element("Name=\"T\"", "1 nan 3 inf") + array_element("Name=\"marker\"", "1 2 3 4") +
                   array_element("Name=\"a &lt; b\" NumberOfComponents=\"2\"", "1 2 3 4 5 6 7 8")) +
             in_cells(array_element("Name=\"heat\"", "10 nan 30"))));
  ASSERT_EQ(mesh.fields.size(), 3U);
  const Field& t = mesh.fields[0];
  EXPECT_EQ(t, (Field{"T", Field::Place::points, 1,
                      Array<double>(Values{1, std::nan(""), 3, std::numeric_limits<double>::infinity()}), 0}));
  EXPECT_EQ(mesh.fields[1].name, "a < b");
  EXPECT_EQ(mesh.fields[1].components, 2U);
  EXPECT_EQ(mesh.fields[2], (Field{"heat", Field::Place::triangles, 1, Array<double>(Values{10, 30}), 0}));
  EXPECT_EQ(mesh.left_out.things(), Texts());
}

TEST(VtuFields, size_is_a_field) {
  const Mesh mesh = read_vtu_text(square_piece(0, at_points(array_element("Name=\"size\"", "1 2 3 4"))));
  EXPECT_EQ(mesh.attributes_per_point, 0U);
  EXPECT_EQ(mesh.fields.at(0).name, "size");
}

TEST(VtuFields, have_markers_of_triangles_while_those_of_lines_are_markers) {
  const auto with_markers = [](const std::string& values) {
    return read_vtu_text(square_piece(
        0, in_cells(array_element("Name=\"marker\"", values)) + at_points(array_element("Name=\"T\"", "1 2 3 4"))));
  };
  const auto marker = [](const Values& values) {
    return Field{"marker", Field::Place::triangles, 1, Array<double>(values), 0};
  };
  const Mesh whole = with_markers("7 5 8");
  ASSERT_EQ(whole.fields.size(), 2U);
  EXPECT_EQ(whole.fields[0].name, "T");
  EXPECT_EQ(whole.fields[1], marker({7, 8}));
  EXPECT_EQ(whole.constrained_edges.at(0).marker, 5);
  EXPECT_EQ(whole.left_out.things(), Texts());
  EXPECT_EQ(with_markers("7.5 -5 0").fields.back(), marker({7.5, 0}));
  EXPECT_EQ(with_markers("7.5 -5 0").constrained_edges.at(0).marker, -5);
  EXPECT_EQ(with_markers("0 5 0").fields.size(), 1U);

  const Mesh real = with_markers("7 0.5 8");
  EXPECT_EQ(real.fields.back(), marker({7, 8}));
  EXPECT_EQ(real.constrained_edges.at(0).marker, 0);
  EXPECT_EQ(real.left_out.things(), Texts{"values in cells that are not triangles"});
}

TEST(VtuFields, have_markers_of_points_that_are_not_all_whole_numbers_of_32_bits) {
  for (const char* values : {"0.5 1 2 3", "1 2 3 4294967296", "1 nan 2 3"}) {
    const Mesh mesh = read_vtu_text(square_piece(0, at_points(array_element("Name=\"marker\"", values))));
    ASSERT_EQ(mesh.fields.size(), 1U) << values;
    EXPECT_EQ(mesh.fields[0].name, "marker");
    EXPECT_EQ(mesh.fields[0].place, Field::Place::points);
    EXPECT_EQ(mesh.fields[0].values.size(), 4U);
    EXPECT_TRUE(mesh.point_markers.empty());
  }
}

TEST(VtuFields, what_cannot_be_a_field_is_listed_as_left_out) {
  const std::string names = "<DataArray type=\"String\" Name=\"labels\" format=\"ascii\">65 0 66 0</DataArray>\n";
  const Mesh mesh =
      read_vtu_text("<FieldData>\n" + array_element("Name=\"TimeValue\"", "0.5") + "</FieldData>\n" +
                    square_piece(0, at_points(names) + in_cells(array_element("Name=\"heat\"", "1 2 3"))));
  EXPECT_EQ(mesh.fields.size(), 1U);
  EXPECT_EQ(mesh.left_out.things(),
            (Texts{"the array \"labels\"", "values in cells that are not triangles", "the field data \"TimeValue\""}));
}

TEST(VtuFields, of_a_wrong_length_are_refused_with_the_line) {
  EXPECT_EQ(failure_of_array(square_piece(0, at_points(array_element("Name=\"T\"", "1 2 3")))),
            "f:11: array \"T\": expected as many values at every point");
  EXPECT_EQ(failure_of_array(square_piece(0, in_cells(array_element("Name=\"T\"", "1 2")))),
            "f:11: array \"T\": expected as many values in every cell");
  EXPECT_EQ(failure_of_array(square_piece(0, at_points(array_element("Name=\"T\"", "1 2 x 3")))),
            "f:11: expected a value, found \"x\"");
}

TEST(VtuFields, and_names_read_back_the_same) {
  const TemporaryFolder folder;
  const Mesh mesh = mesh_with_fields();
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu"));
  const Result<Mesh> read = read_mesh(folder / "m.vtu");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->names, mesh.names);
  ASSERT_EQ(read->fields.size(), mesh.fields.size());
  for (const Field& field : mesh.fields) EXPECT_EQ(std::ranges::count(read->fields, field), 1) << field.name;
  EXPECT_EQ(read->left_out.things(), Texts());
  ASSERT_TRUE(write_vtu(*read, folder / "again.vtu"));
  EXPECT_EQ(read_mesh(folder / "again.vtu")->fields, read->fields);
}

TEST(VtuFields, get_names_that_the_mesh_does_not_need) {
  Mesh mesh = mesh_with_fields();
  for (std::size_t f = 0; f < 4; ++f) mesh.fields[f].name = "marker";
  EXPECT_EQ(names_of_vtu_fields(mesh), (Texts{"marker 2", "marker 3", "marker 2", "marker 3"}));
  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu"));
  const Result<Mesh> read = read_mesh(folder / "m.vtu");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->point_markers, mesh.point_markers);
  EXPECT_EQ(read->fields.size(), 4U);
}

TEST(VtuFields, may_have_names_that_look_like_attributes) {
  const TemporaryFolder folder;
  Mesh mesh = mesh_with_fields();
  mesh.fields[0].name = "x format=";
  mesh.fields[1].name = " NumberOfComponents='7' offset=";
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu"));
  const Result<Mesh> read = read_mesh(folder / "m.vtu");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->fields, mesh.fields);
}

/// The writer computes an array of this name; another program may mean something else by it.
TEST(VtuFields, quality_is_a_field_unless_it_is_the_smallest_angle) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu"));
  EXPECT_TRUE(read_mesh(folder / "m.vtu")->fields.empty());
  mesh.fields.push_back({vtu_quality, Field::Place::triangles, 1, Array<double>(Values{1, 2, 3, 4}), 0});
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu"));
  EXPECT_EQ(read_mesh(folder / "m.vtu")->fields, mesh.fields);
}

TEST(VtuNames, are_pairs_of_integers_in_the_field_data) {
  const std::string data = "<FieldData>\n" + array_element("Name=\"water\"", "2 2") +
                           array_element("Name=\"wall\"", "3 1") + array_element("Name=\"other\"", "3 1") +
                           array_element("Name=\"region 4\"", "9 2") + array_element("Name=\"volume\"", "1 3") +
                           array_element("Name=\"half\"", "0.5 2") + "</FieldData>\n";
  const Mesh mesh = read_vtu_text(data + square_piece(0));
  EXPECT_EQ(mesh.names,
            (std::vector<GroupName>{{GroupName::Of::region, 2, "water"}, {GroupName::Of::marker, 3, "wall"}}));
  EXPECT_EQ(mesh.left_out.things(), (Texts{"the field data \"other\"", "the field data \"region 4\"",
                                           "the field data \"volume\"", "the field data \"half\""}));
}

TEST(VtuPiecesInOneFile, are_one_mesh_whose_equal_points_are_joined) {
  const Mesh mesh = read_vtu_text(square_piece(0, in_cells(array_element("Name=\"region\"", "7 0 7"))) +
                                  square_piece(1, in_cells(array_element("Name=\"region\"", "2 0 7"))));
  EXPECT_EQ(mesh.points.size(), 6U);
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.triangles[3].v, (std::array<Index, 3>{1, 5, 2}));
  EXPECT_EQ(mesh.triangles[3].n[1], 0U) << "across the border";
  EXPECT_EQ(mesh.region_attributes, (Values{2, 7}));
  EXPECT_EQ(mesh.region[2], 0U);
  EXPECT_EQ(mesh.constrained_edges.at(1), (ConstrainedEdge{1, 4, no_index, 0}));
  EXPECT_EQ(number_in_file(mesh, 4), 5U) << "the second point of the second piece";
}

TEST(VtuPiecesInOneFile, keep_points_that_one_piece_has_twice) {
  const std::string doubled = replaced(square_piece(0), "1 1 0 0 1 0", "1 0 0 0 1 0");
  EXPECT_EQ(read_vtu_text(doubled + square_piece(1)).points.size(), 8U) << "three points at (1, 0)";
  EXPECT_EQ(read_vtu_text(square_piece(0) + square_piece(5)).points.size(), 8U) << "far from each other";
}

TEST(VtuPiecesInOneFile, keep_equal_points_with_different_markers) {
  const auto marked = [](int x, const std::string& markers) {
    return square_piece(
        x, at_points("<DataArray type=\"Int32\" format=\"ascii\" Name=\"marker\">" + markers + "</DataArray>\n"));
  };
  EXPECT_EQ(read_vtu_text(marked(0, "1 2 3 4") + marked(1, "2 5 6 3")).points.size(), 6U);
  EXPECT_EQ(read_vtu_text(marked(0, "1 2 3 4") + marked(1, "2 5 6 9")).points.size(), 7U);
}

TEST(VtuPiecesInOneFile, share_the_points_whose_numbers_they_share) {
  const auto numbered = [](int x, const std::string& numbers) {
    return square_piece(x, at_points("<DataArray type=\"Int64\" format=\"ascii\" Name=\"GlobalNodeId\">" + numbers +
                                     "</DataArray>\n" + array_element("Name=\"T\"", numbers)));
  };
  const Mesh mesh = read_vtu_text(numbered(0, "0 1 2 3") + numbered(1, "1 4 5 2"));
  EXPECT_EQ(mesh.points.size(), 6U);
  EXPECT_EQ(mesh.triangles[3].v, (std::array<Index, 3>{1, 5, 2}));
  EXPECT_EQ(mesh.fields.at(0).values, Array<double>(Values{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(failure_of_array(numbered(0, "0 1 2 3") + numbered(1, "1 4 5 3")),
            "f: different points have the number 3, at (0, 1) and (1, 1)");
}

TEST(VtuPiecesInOneFile, may_lack_fields_that_others_have) {
  const Mesh mesh = read_vtu_text(square_piece(0, at_points(array_element("Name=\"T\"", "1 2 3 4"))) + square_piece(1));
  const double none = std::nan("");
  EXPECT_EQ(mesh.fields.at(0), (Field{"T", Field::Place::points, 1, Array<double>(Values{1, 2, 3, 4, none, none}), 0}));
}

TEST(VtuPiecesInOneFile, that_are_damaged_are_refused_with_the_line) {
  const std::string second = replaced(square_piece(1), ">0 1 2 0 1 0 2 3<", ">0 1 2 0 1 0 2 4<");
  EXPECT_EQ(failure_of_array(square_piece(0) + second),
            "f:16: array \"connectivity\": expected value 7 from 0 to 3, found 4");
  EXPECT_EQ(failure_of_array(square_piece(0, at_points(array_element("Name=\"marker\"", "1 2 3 4"))) + square_piece(1)),
            "f: the pieces do not have the same kinds of data");
}

TEST(VtuPiecesInOneFile, are_no_piece_of_a_pvtu) {
  const TemporaryFolder folder;
  folder.write("two.vtu", vtu_of(square_piece(0) + square_piece(1)));
  const Result<NumberedMesh> piece = read_vtu_piece(folder / "two.vtu");
  ASSERT_FALSE(piece);
  EXPECT_NE(piece.error().message.find("expected one <Piece>, as a file of a .pvtu has, found 2"), std::string::npos);
}

TEST(Vtu, of_a_mesh_without_markers_of_points_has_none) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.point_markers.clear();
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu"));
  EXPECT_EQ(*read_mesh(folder / "m.vtu"), mesh);
}

}  // namespace
}  // namespace pardel
