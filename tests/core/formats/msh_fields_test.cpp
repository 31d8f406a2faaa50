// Fields and names in MSH: $NodeData, $ElementData, $PhysicalNames; and nodes with parameters.
#include "../../../core/formats/msh_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "../../../core/formats.hpp"
#include "../../../core/formats/group_names.hpp"
#include "../../../core/formats/mesh_readers.hpp"
#include "../../../core/support/same_attribute.hpp"
#include "../../temporary_folder.hpp"
#include "../mesh_with_fields.hpp"
#include "broken_text.hpp"

namespace pardel {
using namespace files;
namespace {

using Numbers = std::vector<double>;
using Things = std::vector<std::string>;

const std::string three_nodes =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n2\n"
    "4 1 0 1 2\n7 2 0 1 2 3\n$EndElements\n";
const std::string at_nodes =
    three_nodes + "$NodeData\n1\n\"speed\"\n1\n0.5\n3\n0\n2\n3\n3 30 7\n1 10 7\n2 20 7\n$EndNodeData\n";

Numbers numbers_of(const Array<double>& values) { return {values.begin(), values.end()}; }

Mesh read_msh_text(const std::string& text) {
  const Result<Mesh> mesh = parse_msh(text, "m.msh");
  EXPECT_TRUE(mesh) << mesh.error().message;
  return mesh ? *mesh : Mesh();
}
std::string failure_of_field(const std::string& text) { return message_of_invalid(parse_msh(text, "m.msh")); }

TEST(MshFields, are_read_with_their_names_places_and_times) {
  const Mesh mesh =
      read_msh_text(at_nodes + "$ElementData\n2\n\"heat\"\n\"scheme\"\n0\n4\n0\n1\n1\n0\n7 1.5\n$EndElementData\n");
  ASSERT_EQ(mesh.fields.size(), 2U);
  EXPECT_EQ(mesh.fields[0],
            (Field{"speed", Field::Place::points, 2, Array<double>(Numbers{10, 7, 20, 7, 30, 7}), 0.5}));
  EXPECT_EQ(mesh.fields[1], (Field{"heat", Field::Place::triangles, 1, Array<double>(Numbers{1.5}), 0}));
  EXPECT_EQ(mesh.attributes_per_point, 0U) << "results are no attributes";
  EXPECT_EQ(mesh.left_out.things(), Things());
}

TEST(MshFields, may_have_values_that_are_missing_or_no_numbers) {
  const Mesh mesh = read_msh_text(replaced(at_nodes, "3\n3 30 7\n1 10 7\n2 20 7\n", "2\n1 inf -inf\n3 nan 2\n"));
  ASSERT_EQ(mesh.fields.size(), 1U);
  const Numbers values = numbers_of(mesh.fields[0].values);
  EXPECT_EQ(values[0], std::numeric_limits<double>::infinity());
  EXPECT_EQ(values[1], -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(values[2]) && std::isnan(values[3])) << "node 2 has no value";
  EXPECT_TRUE(std::isnan(values[4]) && values[5] == 2);
}

TEST(MshFields, of_nodes_that_do_not_exist_are_ignored_and_of_lines_left_out) {
  EXPECT_EQ(numbers_of(read_msh_text(replaced(at_nodes, "3 30 7", "9 30 7")).fields.at(0).values).size(), 6U);
  const Mesh mesh = read_msh_text(three_nodes + "$ElementData\n0\n0\n3\n0\n1\n2\n4 8\n7 9\n$EndElementData\n");
  EXPECT_EQ(numbers_of(mesh.fields.at(0).values), Numbers{9});
  EXPECT_EQ(mesh.left_out.things(), Things{"values in elements that are not triangles"});
}

TEST(MshFields, may_be_as_short_as_possible) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n";
  for (int i = 1; i <= 9; ++i) text += std::to_string(i) + " " + std::to_string(i) + " 0 0\n";
  text += "$EndNodes\n$Elements\n0\n$EndElements\n$NodeData\n0\n0\n3\n0\n1\n9\n";
  for (int i = 1; i <= 9; ++i) text += std::to_string(i) + " 5\n";
  EXPECT_EQ(read_msh_text(text + "$EndNodeData\n").fields.at(0).values, Array<double>(9, 5.0));
}

TEST(MshFields, that_are_damaged_are_refused_with_the_line) {
  const auto with = [](const char* from, const char* to) { return failure_of_field(replaced(at_nodes, from, to)); };
  EXPECT_EQ(with("1 10 7", "1 ten 7"), "m.msh:25: expected a value at a node, found \"ten\"");
  EXPECT_EQ(with("1 10 7", "1 10"), "m.msh:25: expected a value at a node, found the end of the line");
  EXPECT_EQ(with("1 10 7", "one 10 7"), "m.msh:25: expected a node's tag, a whole number, found \"one\"");
  EXPECT_EQ(with("3\n0\n2\n3\n", "2\n0\n2\n"),
            "m.msh:22: expected the number of values per node and the number of nodes");
  EXPECT_NE(with("2\n3\n3 30", "0\n3\n3 30").find("the number of values per node"), std::string::npos);
  EXPECT_EQ(with("$EndNodeData\n", ""), "m.msh:27: expected $EndNodeData, found the end of the file");
  EXPECT_NE(with("2\n3\n3 30", "2\n3000000\n3 30").find("announces 3000000 values at nodes"), std::string::npos);
  EXPECT_NE(with("2\n3\n3 30", "2305843009213693952\n0\n3 30").find("the number of values per node"),
            std::string::npos);
  EXPECT_EQ(failure_of_field(three_nodes + "$ElementData\n0\n0\n2\n0\n1\n$EndElementData\n"),
            "m.msh:20: expected the number of values per element and the number of elements");
}

TEST(MshFields, with_many_values_at_few_nodes_are_left_out) {
  std::string few = three_nodes + "$NodeData\n1\n\"spectrum\"\n0\n3\n0\n10\n0\n$EndNodeData\n";
  const Mesh mesh = read_msh_text(few);
  EXPECT_TRUE(mesh.fields.empty());
  EXPECT_EQ(mesh.left_out.things(), Things{"the field \"spectrum\", which has very many values at few places"});
}

TEST(MshFields, before_the_nodes_and_other_sections_are_listed_as_left_out) {
  const std::string periodic = "$Periodic\n0\n$EndPeriodic\n";
  const std::string data = "$NodeData\n0\n0\n3\n0\n1\n0\n$EndNodeData\n";
  const Mesh mesh = read_msh_text(replaced(three_nodes, "$Nodes", (data + "$Nodes").c_str()) + periodic + periodic);
  EXPECT_EQ(mesh.left_out.things(), (Things{"the section $NodeData", "the section $Periodic"}));
}

TEST(MshFields, and_names_read_back_the_same_in_text_and_in_bytes) {
  const TemporaryFolder folder;
  const Mesh mesh = mesh_with_fields();
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary}) {
    ASSERT_TRUE(write_msh(mesh, folder / "m.msh", encoding));
    const Result<Mesh> once = read_mesh(folder / "m.msh");
    ASSERT_TRUE(once) << once.error().message;
    EXPECT_EQ(once->names, mesh.names);
    ASSERT_EQ(once->fields.size(), mesh.fields.size());
    for (std::size_t i = 0; i < mesh.fields.size(); ++i) {
      if (mesh.fields[i].place == Field::Place::points) {
        EXPECT_EQ(once->fields[i], mesh.fields[i]);
      }
    }
    EXPECT_EQ(once->left_out.things(), Things());
  }
}

/// Triangles are written by region, so their values change places with them.
TEST(MshFields, in_triangles_stay_with_their_triangles) {
  const TemporaryFolder folder;
  const Mesh mesh = mesh_with_fields();
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::binary));
  const Result<Mesh> read = read_mesh(folder / "m.msh");
  ASSERT_TRUE(read);
  for (std::size_t f = 0; f < mesh.fields.size(); ++f) {
    const std::size_t k = mesh.fields[f].components;
    for (std::size_t t = 0; mesh.fields[f].place == Field::Place::triangles && t < mesh.triangles.size(); ++t) {
      const auto found = std::ranges::find(read->triangles, mesh.triangles[t].v, &Triangle::v);
      const auto at = static_cast<std::size_t>(found - read->triangles.begin());
      for (std::size_t c = 0; c < k; ++c)
        EXPECT_TRUE(is_same_attribute(read->fields[f].values[at * k + c], mesh.fields[f].values[t * k + c])) << f << t;
    }
  }
}

TEST(MshFields, of_a_name_are_steps) {
  const TemporaryFolder folder;
  Mesh mesh = mesh_with_fields();
  mesh.fields = {mesh.fields[0], mesh.fields[0]};
  mesh.fields[1].time = 2.5;
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::ascii));
  EXPECT_NE(folder.read("m.msh").find("1\n\"T\"\n1\n2.5\n3\n1\n1\n"), std::string::npos) << folder.read("m.msh");
  EXPECT_EQ(read_mesh(folder / "m.msh")->fields, mesh.fields);
}

TEST(MshNames, are_kept_unless_they_say_a_marker_or_an_attribute) {
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n8\n1 1 \"wall # of the tank\"\n2 2 \"water\"\n"
      "2 3 \"region 2.5\"\n1 4 \"marker 9\"\n2 5 \"domain\"\n2 6 \"marker 6\"\n0 7 \"corner\"\n1 8 \"\"\n"
      "$EndPhysicalNames\n$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements\n";
  const Mesh mesh = read_msh_text(text);
  using Of = GroupName::Of;
  EXPECT_EQ(mesh.names,
            (std::vector<GroupName>{
                {Of::marker, 1, "wall # of the tank"}, {Of::region, 2, "water"}, {Of::region, 6, "marker 6"}}));
  EXPECT_EQ(mesh.left_out.things(), Things{"the names of physical points and volumes"});
}

TEST(MshNames, of_markers_and_regions_that_nothing_has_are_kept) {
  const TemporaryFolder folder;
  Mesh mesh = mesh_with_fields();
  mesh.names.push_back({GroupName::Of::marker, 2, "unused"});
  mesh.constrained_edges[0].marker = 0;  // gets the smallest free tag
  ASSERT_TRUE(write_msh(mesh, folder / "m.msh", MshEncoding::ascii));
  const Result<Mesh> read = read_mesh(folder / "m.msh");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(std::ranges::is_permutation(read->names, mesh.names));
  EXPECT_EQ(std::ranges::count(read->constrained_edges, 0, &ConstrainedEdge::marker), 2);
}

TEST(GroupNames, say_a_value_or_none) {
  using Of = GroupName::Of;
  EXPECT_EQ(value_of_group(Of::region, "region -2.5", 3).value, -2.5);
  EXPECT_EQ(value_of_group(Of::marker, "marker -4", 3).value, -4);
  EXPECT_EQ(value_of_group(Of::marker, "marker 2.5", 3).value, 3);
  EXPECT_TRUE(std::isnan(value_of_group(Of::region, "domain", 3).value));
  EXPECT_EQ(value_of_group(Of::marker, "domain", 3).value, 3);
  EXPECT_TRUE(is_group_name(Of::region, "region 2 of 3"));
  for (const char* name : {"", "region 7", "domain", "a\nb"}) EXPECT_FALSE(is_group_name(Of::region, name)) << name;
}

const std::string with_parameters =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n4\n1 0 0 0 0 1\n2 1 0 0 1 3 0.25\n3 1 1 0 2 1 0.5 0.75\n"
    "4 0 1 0 3 1\n$EndParametricNodes\n$Elements\n2\n1 2 0 1 2 3\n2 2 0 1 3 4\n$EndElements\n";

TEST(MshParametricNodes, are_nodes_and_their_parameters_are_left_out) {
  const Mesh mesh = read_msh_text(with_parameters);
  EXPECT_EQ(mesh.points, Array<Point>(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.left_out.things(), Things{"parameters of nodes"});
}

TEST(MshParametricNodes, that_are_damaged_are_refused_with_the_line) {
  const auto with = [](const char* from, const char* to) {
    return failure_of_field(replaced(with_parameters, from, to));
  };
  EXPECT_EQ(with("1 3 0.25", "1 3"), "m.msh:7: expected a node's parameter, found the end of the line");
  EXPECT_EQ(with("0.5 0.75", "0.5 x"), "m.msh:8: expected a node's parameter, found \"x\"");
  EXPECT_EQ(with("0 3 1\n", "0 4 1\n"),
            "m.msh:9: expected the dimension of a node's entity, a whole number from 0 to 3, found \"4\"");
  EXPECT_EQ(with("$EndParametricNodes", "$EndNodes"), "m.msh:10: expected $EndParametricNodes, found \"$EndNodes\"");
}

template <class Value>
void append_value(std::string& bytes, Value value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

TEST(MshParametricNodes, are_read_from_bytes) {
  std::string text = "$MeshFormat\n2.2 1 8\n";
  append_value(text, std::int32_t{1});
  text += "\n$EndMeshFormat\n$ParametricNodes\n3\n";
  for (std::int32_t dimension = 0; dimension < 3; ++dimension) {
    append_value(text, dimension + 1);
    for (const double x : {1.0 * dimension, 1.0 * (dimension == 1), 0.0}) append_value(text, x);
    append_value(text, dimension);
    append_value(text, std::int32_t{5});
    for (std::int32_t k = 0; k < dimension; ++k) append_value(text, 0.5);
  }
  text += "\n$EndParametricNodes\n$Elements\n1\n";
  for (const std::int32_t number : {2, 1, 0, 1, 1, 2, 3}) append_value(text, number);
  const Mesh mesh = read_msh_text(text + "\n$EndElements\n");
  EXPECT_EQ(mesh.points, Array<Point>(std::vector<Point>{{0, 0}, {1, 1}, {2, 0}}));
  EXPECT_EQ(mesh.triangles.size(), 1U);
}

TEST(MshTriangles, are_found_by_tags_in_any_order) {
  MshTriangles triangles;
  const std::vector<std::size_t> tags = {7, 8, 9, 3, 20, 19, 4};
  for (std::size_t t = 0; t < tags.size(); ++t) triangles.add(tags[t], static_cast<Index>(t));
  triangles.sort();
  for (std::size_t t = 0; t < tags.size(); ++t) EXPECT_EQ(triangles.find(tags[t]), t);
  for (const std::size_t tag : {0, 2, 5, 6, 10, 18, 21}) EXPECT_EQ(triangles.find(tag), no_index) << tag;
}

}  // namespace
}  // namespace pardel
