#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../temporary_folder.hpp"
#include "../mesh_with_fields.hpp"
#include "../sample_mesh.hpp"
#include "broken_text.hpp"

namespace pardel {
namespace {

TEST(Vtk, has_triangles_then_lines_with_their_regions_and_markers) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtk(sample_mesh(), folder / "m.vtk").ok());
  EXPECT_EQ(folder.read("m.vtk"),
            "# vtk DataFile Version 3.0\npardel\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            "POINTS 6 double\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 0\n5 5 0\n"
            "CELLS 9 31\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n2 0 1\n2 1 2\n2 2 3\n2 3 0\n2 2 4\n"
            "CELL_TYPES 9\n5\n5\n5\n5\n3\n3\n3\n3\n3\n"
            "CELL_DATA 9\nFIELD FieldData 2\nregion 1 9 double\n2.5\n7\n2.5\n7\n0\n0\n0\n0\n0\n"
            "marker 1 9 int\n0\n0\n0\n0\n1\n5\n1\n-4\n0\n"
            "POINT_DATA 6\nFIELD FieldData 2\nmarker 1 6 int\n1\n5\n5\n1\n9\n0\n"
            "attributes 1 6 double\n0.5\n1.5\n0.1\n-3\n1e-300\n1e+300\n");
  const auto read = read_mesh(folder / "m.vtk");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(*read, sample_mesh());
}

/// As VTK 9 writes it: offsets and connectivity, several values per line, metadata, arrays that mean nothing here.
constexpr const char* of_vtk_9 = R"(# vtk DataFile Version 5.1
vtk output
ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 1
TIME 1 1 double
0.5
METADATA
INFORMATION 0

POINTS 4 float
0 0 0 1 0 0 1 1 0
0 1 0
METADATA
INFORMATION 0

CELLS 5 9
OFFSETS vtktypeint64
0 3 6 8 9
CONNECTIVITY vtktypeint64
0 1 2 0
2 3 3 0 1

CELL_TYPES 4
5
5
3
1

CELL_DATA 4
SCALARS quality double
LOOKUP_TABLE default
nan 1 2 3
SCALARS marker int 1
LOOKUP_TABLE default
0 0 8 0
VECTORS flow float
1 2 3 1 2 3 1 2 3 1 2 3
FIELD FieldData 1
region 1 4 double
6 7 0 0
METADATA
INFORMATION 0

POINT_DATA 4
NORMALS n float
0 0 1 0 0 1 0 0 1 0 0 1
COLOR_SCALARS c 2
0 0 0 0 0 0 0 0
SCALARS size double
LOOKUP_TABLE mine
1 2 3 4
LOOKUP_TABLE mine 1
0 0 0 1
)";

TEST(Vtk, of_version_5_with_other_arrays_is_read) {
  const TemporaryFolder folder;
  const auto read = read_mesh(folder.write("m.vtk", of_vtk_9));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->points.size(), 4U);
  EXPECT_EQ(read->triangles[1].v, (std::array<Index, 3>{0, 2, 3}));
  EXPECT_EQ(read->constrained_edges, (std::vector<ConstrainedEdge>{{3, 0, no_index, 8}}));
  EXPECT_EQ(read->region_attributes, (std::vector<double>{6, 7}));
  EXPECT_EQ(read->attributes_per_point, 0U);
}

using Values = std::vector<double>;
using Texts = std::vector<std::string>;

TEST(Vtk, other_arrays_are_fields_those_at_points_first) {
  const TemporaryFolder folder;
  const auto read = read_mesh(folder.write("m.vtk", of_vtk_9));
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto field = [](const char* name, Field::Place place, std::size_t components, const Values& values) {
    return Field{name, place, components, Array<double>(values), 0};
  };
  constexpr auto at_points = Field::Place::points, in_triangles = Field::Place::triangles;
  ASSERT_EQ(read->fields.size(), 5U);
  EXPECT_EQ(read->fields[0], field("n", at_points, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(read->fields[1], field("c", at_points, 2, Values(8)));
  EXPECT_EQ(read->fields[2], field("size", at_points, 1, {1, 2, 3, 4}));
  EXPECT_EQ(read->fields[3], field("quality", in_triangles, 1, {std::nan(""), 1}));
  EXPECT_EQ(read->fields[4], field("flow", in_triangles, 3, {1, 2, 3, 1, 2, 3}));
  EXPECT_EQ(read->left_out.things(), (Texts{"the array \"TIME\"", "values in cells that are not triangles"}));
}

/// A line comes before a triangle.
TEST(Vtk, a_field_of_cells_is_that_of_its_triangles) {
  const TemporaryFolder folder;
  const std::string grid =
      "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 2 7\n"
      "2 0 1\n3 0 1 2\nCELL_TYPES 2\n3 5\n";
  const auto heat = [&](const std::string& of_line) {
    const auto read = read_mesh(folder.write("m.vtk", grid + "CELL_DATA 2\nTENSORS a%20%41%zz%4 float\n" + of_line +
                                                          " 0 0 0 0 0 0 0 0 1 2 3 4 5 6 7 8 nan\n" +
                                                          "FIELD F 2\nshort 1 1 int\n7\nwords 1 2 string\na b\n"));
    EXPECT_TRUE(read.ok()) << read.error().message;
    return read.ok() ? *read : Mesh();
  };
  const Texts left_out = {"the array \"short\"", "the array \"words\""};
  for (const char* of_line : {"0", "nan"}) {
    const Mesh mesh = heat(of_line);
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0], (Field{"a A%zz%4", Field::Place::triangles, 9,
                                     Array<double>(Values{1, 2, 3, 4, 5, 6, 7, 8, std::nan("")}), 0}));
    EXPECT_EQ(mesh.left_out.things(), left_out);
  }
  EXPECT_EQ(heat("5").left_out.things().back(), "values in cells that are not triangles");
}

TEST(Vtk, fields_read_back_the_same) {
  const TemporaryFolder folder;
  Mesh mesh = mesh_with_fields();
  mesh.names.clear();
  for (Field& field : mesh.fields) field.time = 0;
  mesh.fields[0].name = "a # \"b\"\n%41 \xC3\xA9";
  ASSERT_TRUE(write_vtk(mesh, folder / "m.vtk"));
  const Result<Mesh> read = read_mesh(folder / "m.vtk");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->fields.size(), mesh.fields.size());
  for (const Field& field : mesh.fields) EXPECT_EQ(std::ranges::count(read->fields, field), 1) << field.name;
  EXPECT_EQ(read->left_out.things(), Texts());
  ASSERT_TRUE(write_vtk(*read, folder / "again.vtk"));
  EXPECT_EQ(*read_mesh(folder / "again.vtk"), *read);
}

TEST(Vtk, fields_get_names_that_the_mesh_does_not_need) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  for (const char* name : {"attributes", "marker", "METADATA", ""})
    mesh.fields.push_back({name, Field::Place::points, 1, Array<double>(Values{1, 2, 3, 4, 5, 6}), 0});
  mesh.fields.push_back({"region", Field::Place::triangles, 1, Array<double>(Values{1, 2, 3, 4}), 0});
  ASSERT_TRUE(write_vtk(mesh, folder / "m.vtk"));
  const Result<Mesh> read = read_mesh(folder / "m.vtk");
  ASSERT_TRUE(read) << read.error().message;
  Texts names;
  for (const Field& field : read->fields) names.push_back(field.name);
  EXPECT_EQ(names, (Texts{"attributes 2", "marker 2", "METADATA", "field", "region 2"}));
  EXPECT_EQ(read->point_markers, mesh.point_markers);
  EXPECT_EQ(read->point_attributes, mesh.point_attributes);
  EXPECT_EQ(read->region, mesh.region);
}

TEST(Vtk, errors_in_fields_name_the_line) {
  const TemporaryFolder folder;
  const std::string grid =
      "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
      "CELLS 1 4\n3 0 1 2\n";
  const auto failure = [&](const std::string& data) {
    return message_of(read_mesh(folder.write("w.vtk", grid + data)), folder);
  };
  const std::string types = "CELL_TYPES 1\n5\n";
  EXPECT_EQ(failure(types + "POINT_DATA 3\nVECTORS v float\n1 2 3\n4 x 6\n7 8 9\n"),
            "w.vtk:14: expected a value, found \"x\"");
  EXPECT_EQ(failure(types + "POINT_DATA 3\nSCALARS T float\nLOOKUP_TABLE default\n1000\n2000\n"),
            "w.vtk:16: expected a value, found the end of the file");
  EXPECT_EQ(failure(types + "POINT_DATA 3\nFIELD F 1\nT 1000000 3 float\n1 2 3\n"),
            "w.vtk:13: announces 1000000 the number of components, but the rest of the file is too short for that");
  EXPECT_EQ(failure(types + "VECTORS v float\n1 2 3\n"), "w.vtk:12: expected CELL_DATA or POINT_DATA before an array");
  EXPECT_EQ(failure("POINT_DATA 3\nVECTORS v float\n1 2 3 1 2 3 1 2 3\n" + types),
            "w.vtk:9: expected CELL_TYPES before POINT_DATA");
}

TEST(Vtk, attributes_of_points_are_not_replaced_by_sizes) {
  const TemporaryFolder folder;
  const std::string size = "SCALARS size double\nLOOKUP_TABLE mine\n1 2 3 4\n",
                    attributes = "SCALARS attributes double\nLOOKUP_TABLE mine\n5 6 7 8\n";
  for (const std::string& both : {size + attributes, attributes + size}) {
    const auto read = read_mesh(folder.write("m.vtk", replaced(of_vtk_9, size, both)));
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_EQ(read->attributes_per_point, 1U);
    EXPECT_EQ(read->point_attributes[3], 8) << both;
  }
}

/// Two triangles and a line between them, with arrays in the three cells and at the four points.
Mesh with_arrays(const std::string& arrays) {
  const TemporaryFolder folder;
  const auto read = read_mesh(folder.write(
      "m.vtk",
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      "POINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 3 11\n3 0 1 2\n2 0 1\n3 0 2 3\nCELL_TYPES 3\n5 3 5\n" +
          arrays));
  EXPECT_TRUE(read.ok()) << read.error().message;
  return read.ok() ? *read : Mesh();
}

TEST(Vtk, markers_of_triangles_are_a_field_and_those_of_lines_markers) {
  const auto in_cells = [](const std::string& type, const std::string& values) {
    return with_arrays("CELL_DATA 3\nSCALARS marker " + type + "\nLOOKUP_TABLE default\n" + values + "\n");
  };
  const auto marker = [](const Values& values) {
    return std::vector{Field{"marker", Field::Place::triangles, 1, Array<double>(values), 0}};
  };
  const Mesh whole = in_cells("int", "7 5 8");
  EXPECT_EQ(whole.fields, marker({7, 8}));
  EXPECT_EQ(whole.constrained_edges[0].marker, 5);
  EXPECT_EQ(whole.left_out.things(), Texts());
  EXPECT_EQ(in_cells("double", "7.5 -5 0").fields, marker({7.5, 0}));
  EXPECT_EQ(in_cells("double", "7.5 -5 0").constrained_edges[0].marker, -5);
  EXPECT_EQ(in_cells("int", "0 5 0").fields, std::vector<Field>());

  const Mesh real = in_cells("double", "7 0.5 8");
  EXPECT_EQ(real.fields, marker({7, 8}));
  EXPECT_EQ(real.constrained_edges[0].marker, 0);
  EXPECT_EQ(real.left_out.things(), Texts{"values in cells that are not triangles"});

  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtk(whole, folder / "again.vtk"));
  const auto again = read_mesh(folder / "again.vtk");
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(again->fields.at(0).name, "marker 2");
  EXPECT_EQ(again->fields.at(0).values, whole.fields.at(0).values);
  EXPECT_EQ(again->constrained_edges, whole.constrained_edges);
}

TEST(Vtk, markers_of_points_that_are_not_all_whole_numbers_of_32_bits_are_a_field) {
  for (const Values& values : {Values{0.5, 1, 2, 3}, Values{1, 2, 3, 4294967296}, Values{1, std::nan(""), 2, 3}}) {
    std::string text = "POINT_DATA 4\nSCALARS marker double\nLOOKUP_TABLE default\n";
    for (const double value : values) text += std::to_string(value) + "\n";
    const Mesh mesh = with_arrays(text);
    ASSERT_EQ(mesh.fields.size(), 1U) << text;
    EXPECT_EQ(mesh.fields[0], (Field{"marker", Field::Place::points, 1, Array<double>(values), 0}));
    EXPECT_TRUE(mesh.point_markers.empty());
  }
}

TEST(Vtk, errors_name_the_line_and_the_fault) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtk(sample_mesh(), folder / "m.vtk").ok());
  const std::string text = folder.read("m.vtk");
  const auto failure = [&](const std::string& from, const std::string& to) {
    return message_of(read_mesh(folder.write("w.vtk", replaced(text, from, to))), folder);
  };
  EXPECT_EQ(failure("# vtk", "# VTK"), "w.vtk:1: expected \"# vtk DataFile Version\"");
  EXPECT_EQ(failure("ASCII", "BINARY"), "w.vtk:3: expected ASCII, found \"BINARY\"; only text files are read");
  EXPECT_EQ(failure("UNSTRUCTURED_GRID", "POLYDATA"), "w.vtk:4: expected UNSTRUCTURED_GRID, found \"POLYDATA\"");
  EXPECT_EQ(failure("2 2 0\n", "2 inf 0\n"),
            "w.vtk:8: expected a y coordinate, finite and within the range of a double, found \"inf\"");
  EXPECT_EQ(failure("POINTS 6", "POINTS 600"),
            "w.vtk:5: announces 600 points, but the rest of the file is too short for that");
  EXPECT_EQ(failure("3 1 2 4", "3 1 2 6"), "w.vtk:14: expected a point, a whole number from 0 to 5, found \"6\"");
  EXPECT_EQ(failure("CELL_TYPES 9\n5\n", "CELL_TYPES 9\n9\n"),
            "w.vtk:23: cell 0 is of type 9, neither a triangle (5) nor a line (3) nor a vertex (1)");
  EXPECT_EQ(failure("CELL_TYPES 9\n5\n", "CELL_TYPES 9\n3\n"), "w.vtk:23: cell 0 of type 3 has 3 points");
  EXPECT_EQ(failure("CELL_TYPES 9", "CELL_TYPES 8"), "w.vtk:22: expected as many cells as CELLS has, 9");
  EXPECT_EQ(failure("POINT_DATA 6", "POINT_DATA 5"), "w.vtk:54: expected as many values as there are points, 6");
  EXPECT_EQ(failure("FIELD", "FOLD"), "w.vtk:33: expected a section, found \"FOLD\"");
  EXPECT_EQ(failure("marker 1 9 int\n0\n", "marker 1 9 int\nx\n"), "w.vtk:45: expected a value, found \"x\"");
  EXPECT_EQ(message_of(read_mesh(folder.write("w.vtk", text.substr(0, text.find("CELL_TYPES")))), folder),
            "w.vtk:22: expected CELL_TYPES, found the end of the file");
}

}  // namespace
}  // namespace pardel
