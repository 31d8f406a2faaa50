#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../../core/formats/base64.hpp"
#include "../../../core/formats/mesh_readers.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"
#include "broken_text.hpp"

namespace pardel {
using namespace files;
namespace {

/// Two triangles, a line and a vertex, as another program may write them: as text, with unknown arrays.
constexpr const char* ascii_vtu = R"(<?xml version="1.0"?>
<!-- <Piece> in a comment is none -->
<VTKFile type='UnstructuredGrid' version="0.1" byte_order="LittleEndian">
  <UnstructuredGrid>
    <Piece NumberOfPoints="4" NumberOfCells="4">
      <PointData Scalars="height">
        <DataArray type="Float32" Name="height" format="ascii">1 2 3 4</DataArray>
        <DataArray type="Int8" Name="marker" format="ascii">1 0 -3 1</DataArray>
      </PointData>
      <CellData>
        <DataArray type="Float64" Name="region" format="ascii">9 2.5 9 1</DataArray>
      </CellData>
      <Points>
        <DataArray type="Float64" Name="anything" NumberOfComponents="3" format="ascii">
          <InformationKey name="L2_NORM_RANGE" location="vtkDataArray" length="1"><Value index="0">0</Value></InformationKey>
          0 0 0  1 0 0
          1 1 7  0 1 0
        </DataArray>
      </Points>
      <Cells>
        <DataArray type="Int64" Name="connectivity" format="ascii">
          0 1  0 1 2
          3
          0 2 3
        </DataArray>
        <DataArray type="Int64" Name="offsets" format="ascii">2 5 6 9</DataArray>
        <DataArray type="UInt8" Name="types" format="ascii">3 5 1 5</DataArray>
      </Cells>
    </Piece>
  </UnstructuredGrid>
</VTKFile>
)";

std::string failure_of_vtu(const std::string& text) { return message_of_invalid(parse_vtu(text, "f")); }

TEST(Vtu, reads_back_as_the_same_mesh) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtu(sample_mesh(), folder / "m.vtu").ok());
  const auto read = read_mesh(folder / "m.vtu");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(*read, sample_mesh());
}

TEST(Base64, ends_at_a_character_that_is_no_digit) {
  EXPECT_EQ(decode_base64("QUJD\nREVG", 99), "ABCDEF");
  EXPECT_EQ(decode_base64("QQ==QUI=QUJD", 99), "AABABC");
  EXPECT_EQ(decode_base64("QUJDREVG", 4), "ABCD");
  for (const char* other : {"{", "[", "@", "`", ":", ",", "-"})
    EXPECT_EQ(decode_base64(std::string("QUJD") + other + "REVG", 99), "ABC") << other;
  EXPECT_EQ(decode_base64("zZ09+/aA", 99), "\xcd\x9d\x3d\xfb\xf6\x80");
}

TEST(Vtu, has_the_smallest_angle_of_each_triangle) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (const Point& p : {Point{0, 0}, {1, 0}, {0, 1}, {2, 0}}) mesh.points.push_back(p);
  mesh.triangles.push_back({{0, 1, 2}, {}});
  mesh.triangles.push_back({{0, 1, 3}, {}});
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu").ok());
  const std::string file = folder.read("m.vtu");
  const std::size_t element = file.find("Name=\"quality\"");
  const std::size_t offset = std::stoul(file.substr(file.find("offset=\"", element) + 8));
  const std::size_t data = file.find("\n_") + 2 + offset;
  std::uint64_t length = 0;
  std::memcpy(&length, &file[data], 8);
  ASSERT_EQ(length, 16u);
  double quality[2];
  std::memcpy(quality, &file[data + 8], 16);
  EXPECT_NEAR(quality[0], 45, 1e-12);
  EXPECT_EQ(quality[1], 0);
}

TEST(Vtu, has_the_smallest_angle_of_a_triangle_whose_corners_have_any_order) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (const Point& p : {Point{10, 20}, {14, 20}, {10, 21}}) mesh.points.push_back(p);
  for (const std::array<Index, 3>& v : {std::array<Index, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}})
    mesh.triangles.push_back({v, {}});
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu").ok());
  const std::string file = folder.read("m.vtu");
  const std::size_t element = file.find("Name=\"quality\"");
  const std::size_t offset = std::stoul(file.substr(file.find("offset=\"", element) + 8));
  double quality[3];
  std::memcpy(quality, &file[file.find("\n_") + 2 + offset + 8], 24);
  for (const double angle : quality) EXPECT_NEAR(angle, 14.036243467926479, 1e-12);
}

TEST(Vtu, without_points_may_have_attributes) {
  const Result<Mesh> mesh = parse_vtu(
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
      "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"><PointData>"
      "<DataArray type=\"Float64\" Name=\"attributes\" format=\"ascii\"></DataArray></PointData><Points>"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\"></DataArray></Points><Cells>"
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\"></DataArray>"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\"></DataArray>"
      "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\"></DataArray></Cells>"
      "</Piece></UnstructuredGrid></VTKFile>",
      "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->points.size(), 0u);
  EXPECT_EQ(mesh->attributes_per_point, 0u);
}

TEST(Vtu, of_another_program_may_hold_text_lines_vertices_and_unknown_arrays) {
  const auto mesh = parse_vtu(ascii_vtu, "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->points.size(), 4u);
  EXPECT_EQ(mesh->points[2], (Point{1, 1}));
  ASSERT_EQ(mesh->triangles.size(), 2u);
  EXPECT_EQ(mesh->triangles[0], (Triangle{{0, 1, 2}, {no_index, 1, no_index}}));
  EXPECT_EQ(mesh->region_attributes, (std::vector<double>{1, 2.5}));
  EXPECT_EQ(mesh->region[0], 1u);
  EXPECT_EQ(mesh->point_markers[2], -3);
  EXPECT_EQ(mesh->constrained_edges, (std::vector<ConstrainedEdge>{{0, 1, no_index, 0}}));
}

TEST(Vtu, may_have_markers_of_every_integer_type_in_binary) {
  const auto with_markers = [](const std::string& type, const std::string& data) {
    return replaced(ascii_vtu, R"(<DataArray type="Int8" Name="marker" format="ascii">1 0 -3 1)",
                    "<DataArray type=\"" + type + R"(" Name="marker" format="binary">)" + data);
  };
  // The number of bytes as a UInt32, and the numbers 1, 0, 3, 2, little-endian.
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"Int8", "UInt8"}, "BAAAAAEAAwI="},
      {{"Int16", "UInt16"}, "CAAAAAEAAAADAAIA"},
      {{"Int32", "UInt32"}, "EAAAAAEAAAAAAAAAAwAAAAIAAAA="},
      {{"Int64", "UInt64"}, "IAAAAAEAAAAAAAAAAAAAAAAAAAADAAAAAAAAAAIAAAAAAAAA"}};
  for (const auto& [types, data] : cases)
    for (const std::string& type : types) {
      const auto mesh = parse_vtu(with_markers(type, data), "f");
      ASSERT_TRUE(mesh.ok()) << type << ": " << mesh.error().message;
      EXPECT_EQ(std::vector<int>(mesh->point_markers.begin(), mesh->point_markers.end()), (std::vector{1, 0, 3, 2}))
          << type;
    }
  const auto unknown = parse_vtu(with_markers("Int7", "BAAAAAEAAwI="), "f");
  ASSERT_TRUE(unknown.ok()) << unknown.error().message;
  EXPECT_TRUE(unknown->point_markers.empty());
  EXPECT_EQ(unknown->left_out.things(), std::vector<std::string>{"the array \"marker\""});
}

TEST(Vtu, with_more_points_than_a_mesh_can_hold_is_refused) {
  EXPECT_EQ(failure_of_vtu(replaced(ascii_vtu, "NumberOfPoints=\"4\"", "NumberOfPoints=\"4294967296\"")),
            "f:1: the piece announces more points than a mesh can hold");
}

TEST(Vtu, may_have_base64_with_the_length_encoded_separately_or_not) {
  // The length 36 as a UInt32, then the coordinates 0 0 0 1 0 0 0 1 0 as Float32.
  const std::string together = "JAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA==";
  const std::string apart = "JAAAAA==AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const std::string file = R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid>
<Piece NumberOfPoints="3" NumberOfCells="1"><Points>
<DataArray type="Float32" NumberOfComponents="3" format="binary">
  DATA
</DataArray></Points><Cells>
<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray>
<DataArray type="Int32" Name="types" format="ascii">5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>)";
  for (const std::string& data : {together, apart}) {
    const auto mesh = parse_vtu(replaced(file, "DATA", data), "f");
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(mesh->points[1], (Point{1, 0}));
    EXPECT_EQ(mesh->points[2], (Point{0, 1}));
    EXPECT_EQ(failure_of_vtu(replaced(file, "DATA", data.substr(0, 52))), "f:3: the data of this array are cut off");
  }
  EXPECT_EQ(failure_of_vtu(replaced(file, "DATA", "")), "f:3: the data of this array are cut off");
  EXPECT_EQ(failure_of_vtu(replaced(file, "DATA", "/////w==")),
            "f:3: this array announces 4294967295 bytes, but 12 follow");
  // The same file, with the arrays appended in base64.
  std::string appended =
      replaced(file, "format=\"binary\">\n  DATA\n</DataArray>", "format=\"appended\" offset=\"3\"/>");
  appended = replaced(appended, "</VTKFile>",
                      "<AppendedData encoding=\"base64\">\n_xyz" + together + "</AppendedData></VTKFile>");
  const auto mesh = parse_vtu(appended, "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->points[2], (Point{0, 1}));
}

TEST(Vtu, by_VTK_has_elements_after_the_values_of_an_array) {
  const std::string inner =
      "<InformationKey name=\"L2_NORM_RANGE\" length=\"1\"><Value index=\"0\">0</Value></InformationKey>";
  const std::string values = "0 0 0  1 0 0\n          1 1 7  0 1 0\n        ";
  ASSERT_NE(std::string(ascii_vtu).find(values), std::string::npos);
  const auto mesh = parse_vtu(replaced(ascii_vtu, values.c_str(), (values + inner).c_str()), "f");
  ASSERT_FALSE(mesh.ok()) << "the elements are before and after the values";
  const std::string before = std::string(ascii_vtu).substr(std::string(ascii_vtu).find("<InformationKey"));
  const std::string first = before.substr(0, before.find("</InformationKey>") + 17);
  const std::string after = replaced(replaced(ascii_vtu, first.c_str(), ""), values.c_str(), (values + inner).c_str());
  const auto by_vtk = parse_vtu(after, "f");
  ASSERT_TRUE(by_vtk.ok()) << by_vtk.error().message;
  EXPECT_EQ(*by_vtk, *parse_vtu(ascii_vtu, "f"));
}

/// A square in four triangles in two regions, with two constrained edges.
void expect_square(const Mesh& mesh, const char* file) {
  EXPECT_EQ(mesh.points.size(), 5u) << file;
  EXPECT_EQ(mesh.points[4], (Point{0.5, 0.5})) << file;
  ASSERT_EQ(mesh.triangles.size(), 4u) << file;
  EXPECT_EQ(mesh.triangles[3].v, (std::array<Index, 3>{3, 0, 4})) << file;
  EXPECT_EQ(mesh.region_attributes, (std::vector<double>{2.5, 7})) << file;
  EXPECT_EQ(mesh.constrained_edges, (std::vector<ConstrainedEdge>{{0, 1, no_index, 3}, {1, 2, no_index, 4}})) << file;
}

TEST(Vtu, compressed_by_zlib_is_read_inline_and_appended_in_one_block_and_in_several) {
  for (const char* file : {"zlib_by_meshio.vtu", "zlib_appended_raw.vtu", "zlib_appended_base64.vtu"}) {
    const auto mesh = read_mesh(std::filesystem::path(PARDEL_FORMATS_DATA) / file);
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    expect_square(*mesh, file);
    EXPECT_EQ(mesh->point_markers[4], -5) << file;
  }
}

TEST(Vtu, compressed_by_zlib_and_damaged_is_refused) {
  std::ifstream in(PARDEL_FORMATS_DATA "/zlib_appended_raw.vtu", std::ios::binary);
  const std::string file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const std::size_t data = file.find("\n_") + 2;
  std::string damaged = file;
  damaged[data + 8 * 7 + 5] ^= 0x55;  // in the first block, after four sizes of blocks
  EXPECT_NE(failure_of_vtu(damaged).find("block 0 of this array does not expand to 32 bytes"), std::string::npos);
  damaged = file;
  damaged[data + 8 + 7] = 0x7f;  // the size of a block
  EXPECT_NE(failure_of_vtu(damaged).find("does not expand to"), std::string::npos);
  damaged = file;
  damaged[data + 7] = 0x7f;  // the number of blocks
  EXPECT_NE(failure_of_vtu(damaged).find("the data of this array are cut off"), std::string::npos);
  for (std::size_t length = data; length < file.size() - 30; ++length)
    EXPECT_FALSE(parse_vtu(std::string_view(file).substr(0, length), "f").ok()) << length;
}

TEST(Vtu, has_the_constrained_edges_as_lines_with_their_markers) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtu(sample_mesh(), folder / "m.vtu").ok());
  const std::string file = folder.read("m.vtu");
  const std::size_t cells = sample_mesh().triangles.size() + sample_mesh().constrained_edges.size();
  EXPECT_NE(file.find("NumberOfCells=\"" + std::to_string(cells) + "\""), std::string::npos);
  const std::size_t cell_data = file.find("<CellData>");
  EXPECT_LT(file.find("Name=\"marker\"", cell_data), file.find("</CellData>"));
  EXPECT_EQ(read_mesh(folder / "m.vtu")->constrained_edges, sample_mesh().constrained_edges);
}

TEST(Vtu, errors_name_the_line_and_the_fault) {
  const auto failure = [&](const char* from, const char* to) { return failure_of_vtu(replaced(ascii_vtu, from, to)); };
  EXPECT_EQ(failure_of_vtu(""), "f:1: expected a VTK file (<VTKFile type=\"UnstructuredGrid\" ...>), found none");
  EXPECT_EQ(failure_of_vtu("\x89PNG<\xff\xfe<<"),
            "f:1: expected a VTK file (<VTKFile type=\"UnstructuredGrid\" ...>), found none");
  EXPECT_EQ(failure("'UnstructuredGrid'", "\"PolyData\""),
            "f:3: expected type=\"UnstructuredGrid\", found \"PolyData\"");
  EXPECT_EQ(failure("LittleEndian", "BigEndian"), "f:3: expected byte_order=\"LittleEndian\", found \"BigEndian\"");
  EXPECT_EQ(failure("version=\"0.1\"", "version=\"0.1\" compressor=\"vtkLZ4DataCompressor\""),
            "f:3: expected no compressor or vtkZLibDataCompressor, found \"vtkLZ4DataCompressor\"");
  EXPECT_EQ(failure("Piece Num", "Peace Num"), "f:1: expected a <Piece>, found none");
  EXPECT_EQ(failure("</UnstructuredGrid>", "<Piece/>"), "f:30: expected the number of points, found \"\"");
  EXPECT_EQ(failure("NumberOfPoints=\"4\"", "NumberOfPoints=\"-4\""),
            "f:5: expected the number of points, found \"-4\"");
  EXPECT_EQ(failure("NumberOfCells=\"4\"", ""), "f:5: expected the number of cells, found \"\"");
  EXPECT_EQ(failure("NumberOfPoints=\"4\"", ""), "f:5: expected the number of points, found \"\"");
  EXPECT_EQ(failure("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\""),
            "f:15: array \"anything\": expected 15 values, found 12");
  EXPECT_EQ(failure("NumberOfPoints=\"4\"", "NumberOfPoints=\"4000000000\""),
            "f:15: array \"anything\": expected 12000000000 values, found 12");
  EXPECT_EQ(failure("1 1 7  0 1 0", "1 1 7  0 nan 0"),
            "f:17: expected a value, finite and within the range of a double, found \"nan\"");
  EXPECT_EQ(failure("0 2 3\n", "0 2 3.5\n"), "f:24: expected a value, a whole number, found \"3.5\"");
  EXPECT_EQ(failure("0 2 3\n", "0 2 4\n"), "f:21: array \"connectivity\": expected value 8 from 0 to 3, found 4");
  EXPECT_EQ(failure("2 5 6 9", "2 4 6 9"),
            "f:26: array \"offsets\": expected cell 1 to end at 5 of 9 corners, found 4");
  EXPECT_EQ(failure("2 5 6 9", "2 5 6"), "f:26: array \"offsets\": expected 4 values, found 3");
  EXPECT_EQ(failure("3 5 1 5", "3 5 1 9"),
            "f:27: array \"types\": cell 3 is of type 9, neither a triangle (5) nor a line (3) nor a vertex (1)");
  EXPECT_EQ(failure("Name=\"types\"", "Name=\"kinds\""), "f:1: expected an array types in <Cells>");
  EXPECT_EQ(failure("format=\"ascii\">2 5", "format=\"hex\">2 5"),
            "f:26: expected format ascii, binary or appended, found \"hex\"");
  EXPECT_EQ(failure("format=\"ascii\">2 5", "format=\"appended\" offset=\"0\">2 5"),
            "f:26: there are no appended data at offset 0");
}

/// Three triangles, whose offsets have to be 3 6 9.
TEST(Vtu, with_triangles_that_do_not_follow_each_other_is_refused) {
  const auto with_offsets = [](const std::string& offsets) {
    return R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="3"><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 2 0 0 0 1 0 1 1 0</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 3 1 4 3 1 2 4</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">)" +
           offsets + R"(</DataArray>
<DataArray type="Int32" Name="types" format="ascii">5 5 5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>)";
  };
  const auto mesh = parse_vtu(with_offsets("3 6 9"), "f");
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  EXPECT_EQ(mesh->triangles[2].v, (std::array<Index, 3>{1, 2, 4}));
  const auto failure = [](int cell, int end, int found) {
    return "f:4: array \"offsets\": expected cell " + std::to_string(cell) + " to end at " + std::to_string(end) +
           " of 9 corners, found " + std::to_string(found);
  };
  EXPECT_EQ(failure_of_vtu(with_offsets("4 7 10")), failure(0, 3, 4));
  EXPECT_EQ(failure_of_vtu(with_offsets("2 5 8")), failure(0, 3, 2));
  EXPECT_EQ(failure_of_vtu(with_offsets("0 3 6")), failure(0, 3, 0));
  EXPECT_EQ(failure_of_vtu(with_offsets("3 7 11")), failure(1, 6, 7));
  EXPECT_EQ(failure_of_vtu(with_offsets("3 5 7")), failure(1, 6, 5));
  EXPECT_EQ(failure_of_vtu(with_offsets("3 6 10")), failure(2, 9, 10));
  EXPECT_EQ(failure_of_vtu(with_offsets("3 6 8")), failure(2, 9, 8));
}

TEST(Vtu, has_as_many_attributes_at_every_point) {
  const auto with_values = [](const std::string& values) {
    return replaced(replaced(ascii_vtu, "Name=\"height\"", "Name=\"attributes\""), "1 2 3 4", values);
  };
  for (const std::size_t each : {1U, 2U, 3U}) {
    std::string values;
    for (std::size_t i = 0; i < 4 * each; ++i) values += "0.5 ";
    const auto mesh = parse_vtu(with_values(values), "f");
    ASSERT_TRUE(mesh.ok()) << mesh.error().message;
    EXPECT_EQ(mesh->attributes_per_point, each);
    EXPECT_EQ(mesh->point_attributes.size(), 4 * each);
  }
  for (const char* values : {"1", "1 2 3", "1 2 3 4 5", "1 2 3 4 5 6 7"})
    EXPECT_EQ(failure_of_vtu(with_values(values)), "f:7: array \"attributes\": expected as many values at every point")
        << values;
}

TEST(Vtu, cut_off_anywhere_is_refused) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_vtu(sample_mesh(), folder / "m.vtu").ok());
  const std::string file = folder.read("m.vtu");
  const std::size_t data_end = file.size() - std::string("\n</AppendedData>\n</VTKFile>\n").size();
  for (std::size_t length = 0; length < data_end; ++length) {
    EXPECT_FALSE(parse_vtu(std::string_view(file).substr(0, length), "f").ok()) << length;
  }
  EXPECT_TRUE(parse_vtu(std::string_view(file).substr(0, data_end), "f").ok());
}

TEST(Vtu, with_a_number_that_is_not_finite_is_refused) {
  const TemporaryFolder folder;
  Mesh mesh = sample_mesh();
  mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu").ok());
  EXPECT_NE(message_of(read_mesh(folder / "m.vtu"), folder).find("value 10 of the array \"Points\" is not finite"),
            std::string::npos);
}

TEST(Vtu, that_is_none_is_refused_at_its_first_line) {
  EXPECT_EQ(failure_of_vtu("\n<x/>"), "f:1: expected a VTK file (<VTKFile type=\"UnstructuredGrid\" ...>), found none");
  EXPECT_EQ(
      failure_of_vtu("\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\"></VTKFile>"),
      "f:1: expected a <Piece>, found none");
}

/// Compared with the law of cosines.
TEST(Vtu, has_the_smallest_angle_of_triangles_that_are_turned) {
  const TemporaryFolder folder;
  Mesh mesh;
  for (const Point& p : {Point{0, 0}, {3, 1}, {1, 2}, {-2, 5}, {4, 7}}) mesh.points.push_back(p);
  for (const std::array<Index, 3>& v : {std::array<Index, 3>{0, 1, 2}, {1, 4, 3}, {4, 0, 1}, {3, 2, 4}})
    mesh.triangles.push_back({v, {}});
  ASSERT_TRUE(write_vtu(mesh, folder / "m.vtu").ok());
  const std::string file = folder.read("m.vtu");
  const std::size_t element = file.find("Name=\"quality\"");
  const std::size_t offset = std::stoul(file.substr(file.find("offset=\"", element) + 8));
  double quality[4];
  std::memcpy(quality, &file[file.find("\n_") + 2 + offset + 8], 32);
  for (std::size_t t = 0; t < 4; ++t) {
    double least = 180;
    for (unsigned i = 0; i < 3; ++i) {
      const auto point = [&](unsigned k) { return mesh.points[mesh.triangles[t].v[(i + k) % 3]]; };
      const auto length = [](Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); };
      const double a = length(point(1), point(2)), b = length(point(0), point(1)), c = length(point(0), point(2));
      least = std::min(least, std::acos((b * b + c * c - a * a) / (2 * b * c)) * 180 / std::numbers::pi);
    }
    EXPECT_NEAR(quality[t], least, 1e-9);
  }
}

TEST(Pvtu, names_its_pieces_in_any_xml) {
  const TemporaryFolder folder;
  const std::filesystem::path list =
      folder.write("list.pvtu",
                   "<?xml version=\"1.0\"?>\n<VTKFile type='PUnstructuredGrid'>\n<!-- <Piece Source=\"old.vtu\"/> -->\n"
                   "<Piece Source=\"a.vtu\"/><Piece Source = 'b \"2\".vtu' /><Piece\n  Other=\"x>y\"\n"
                   "  Source\n= \"c&amp;d.vtu\"></Piece>\n</VTKFile>\n");
  const auto files = files_of_pieces(list);
  ASSERT_TRUE(files) << files.error().message;
  ASSERT_EQ(files->size(), 3U);
  EXPECT_EQ((*files)[0].filename(), "a.vtu");
  EXPECT_EQ((*files)[1].filename(), "b \"2\".vtu");
  EXPECT_EQ((*files)[2].filename(), "c&d.vtu");
  const auto without = files_of_pieces(folder.write("no.pvtu", "<VTKFile>\n<Piece Source=\"a.vtu\"/>\n<Piece/>\n"));
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message.find("no.pvtu:3: expected <Piece Source=\"...\">, found no Source"),
            std::string::npos)
      << without.error().message;
}

/// A .pvtu may name any file, so the name of a piece alone would not tell what is wrong.
TEST(Pvtu, is_named_if_a_piece_cannot_be_read) {
  const TemporaryFolder folder;
  const std::filesystem::path list = folder.write("list.pvtu", "<Piece Source=\"/no/such/piece.vtu\"/>");
  const Result<Mesh> mesh = read_mesh(list);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().message, list.string() + ": /no/such/piece.vtu: cannot be opened: No such file or directory");
}

/// Earlier versions of write_vtu() stored the constrained edges as field data.
TEST(Vtu, of_earlier_versions_has_constrained_edges_as_field_data) {
  const std::string data =
      "<FieldData>\n<DataArray type=\"Int32\" Name=\"constrained_edges\" format=\"ascii\">0 1 1 2 3 0</DataArray>\n"
      "<DataArray type=\"Int32\" Name=\"constrained_edge_markers\" format=\"ascii\">4 5 6</DataArray>\n</FieldData>\n";
  std::string text = replaced(ascii_vtu, "  <UnstructuredGrid>\n", "  <UnstructuredGrid>\n" + data);
  text = replaced(text, "0 1  0 1 2", "0    0 1 2");
  text = replaced(replaced(text, "2 5 6 9", "1 4 5 8"), "3 5 1 5", "1 5 1 5");
  const auto mesh = parse_vtu(text, "f");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->constrained_edges,
            (std::vector<ConstrainedEdge>{{0, 1, no_index, 4}, {1, 2, no_index, 5}, {3, 0, no_index, 6}}));
  EXPECT_NE(failure_of_vtu(replaced(text, ">4 5 6<", ">4 5<")), "(no error)");
  const auto without_markers = parse_vtu(replaced(text, "constrained_edge_markers", "other_markers"), "f");
  ASSERT_TRUE(without_markers) << without_markers.error().message;
  EXPECT_EQ(without_markers->constrained_edges,
            (std::vector<ConstrainedEdge>{{0, 1, no_index, 0}, {1, 2, no_index, 0}, {3, 0, no_index, 0}}));
}

}  // namespace
}  // namespace pardel
