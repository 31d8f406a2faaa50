// Fields and names of pieces are joined like the pieces.
#include "../../core/join_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace pardel {
namespace {

/// Two halves of a square, with a field at the points of the first one and one in the triangles of each.
std::vector<NumberedMesh> halves_with_fields() {
  std::vector<NumberedMesh> pieces(2);
  const auto set = [&](NumberedMesh& piece, std::vector<Point> points, std::vector<std::uint64_t> numbers,
                       double heat) {
    piece.mesh.points = Array<Point>(points);
    piece.number = Array<std::uint64_t>(numbers);
    piece.mesh.triangles.push_back({{0, 1, 2}});
    piece.mesh.fields.push_back({"heat", Field::Place::triangles, 1, Array<double>(1, heat), 0});
  };
  set(pieces[0], {{0, 0}, {1, 0}, {1, 1}}, {0, 1, 2}, 5);
  set(pieces[1], {{0, 0}, {1, 1}, {0, 1}}, {0, 2, 3}, 6);
  pieces[0].mesh.fields.push_back({"T", Field::Place::points, 1, Array<double>(std::vector<double>{1, 2, 3}), 0});
  pieces[0].mesh.names = {{GroupName::Of::marker, 1, "wall"}};
  pieces[1].mesh.names = {{GroupName::Of::marker, 1, "border"}, {GroupName::Of::region, 1, "water"}};
  return pieces;
}

TEST(JoinFields, puts_values_where_their_points_and_triangles_are) {
  const Result<Mesh> mesh = join_pieces(halves_with_fields());
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->fields.size(), 2U);
  EXPECT_EQ(mesh->fields[0].values, Array<double>(std::vector<double>{5, 6}));
  EXPECT_EQ(mesh->fields[1],
            (Field{"T", Field::Place::points, 1, Array<double>(std::vector<double>{1, 2, 3, std::nan("")}), 0}));
}

TEST(JoinFields, keeps_the_first_value_and_the_first_name) {
  std::vector<NumberedMesh> pieces = halves_with_fields();
  pieces[1].mesh.fields.push_back({"T", Field::Place::points, 1, Array<double>(std::vector<double>{8, 9, 7}), 0});
  pieces[1].mesh.left_out.add("text");
  const Result<Mesh> mesh = join_pieces(pieces);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->fields[1].values, Array<double>(std::vector<double>{1, 2, 3, 7}));
  EXPECT_EQ(mesh->names,
            (std::vector<GroupName>{{GroupName::Of::marker, 1, "wall"}, {GroupName::Of::region, 1, "water"}}));
  EXPECT_EQ(mesh->left_out.things(), std::vector<std::string>{"text"});
}

TEST(JoinFields, keeps_the_steps_of_a_field_apart) {
  std::vector<NumberedMesh> pieces = halves_with_fields();
  for (NumberedMesh& piece : pieces)
    piece.mesh.fields.push_back(
        {"heat", Field::Place::triangles, 1, Array<double>(1, piece.mesh.fields[0].values[0] + 10), 2.5});
  const Result<Mesh> mesh = join_pieces(pieces);
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->fields.size(), 3U);
  EXPECT_EQ(mesh->fields[0], (Field{"heat", Field::Place::triangles, 1, Array<double>(std::vector<double>{5, 6}), 0}));
  EXPECT_EQ(mesh->fields[2],
            (Field{"heat", Field::Place::triangles, 1, Array<double>(std::vector<double>{15, 16}), 2.5}));
}

}  // namespace
}  // namespace pardel
