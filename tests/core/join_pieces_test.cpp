// Pieces are joined by the numbers of their points. Pieces that do not fit are an error.
#include "../../core/join_pieces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace pardel {
namespace {

NumberedMesh piece(std::vector<Point> points, std::vector<std::uint64_t> numbers) {
  NumberedMesh made;
  for (const Point p : points) made.mesh.points.push_back(p);
  for (const std::uint64_t number : numbers) made.number.push_back(number);
  if (points.size() >= 3) made.mesh.triangles.push_back({{0, 1, 2}});
  return made;
}

/// The unit square, cut along its diagonal.
std::vector<NumberedMesh> halves() {
  return {piece({{0, 0}, {1, 0}, {1, 1}}, {0, 1, 2}), piece({{0, 0}, {1, 1}, {0, 1}}, {0, 2, 3})};
}

std::string error_of(const std::vector<NumberedMesh>& pieces) {
  const Result<Mesh> joined = join_pieces(pieces);
  return joined ? "" : joined.error().message;
}

TEST(JoinPieces, makes_one_mesh) {
  const Result<Mesh> joined = join_pieces(halves());
  ASSERT_TRUE(joined) << joined.error().message;
  EXPECT_EQ(joined->points.size(), 4U);
  ASSERT_EQ(joined->triangles.size(), 2U);
  EXPECT_EQ(joined->triangles[1].v, (std::array<Index, 3>{0, 2, 3}));
  EXPECT_EQ(joined->triangles[0].n, (std::array<Index, 3>{no_index, 1, no_index}));
}

TEST(JoinPieces, of_nothing_is_an_empty_mesh) {
  ASSERT_TRUE(join_pieces({}));
  EXPECT_TRUE(join_pieces(std::vector<NumberedMesh>(2))->points.empty());
}

TEST(JoinPieces, ignores_pieces_without_points) {
  std::vector<NumberedMesh> pieces = halves();
  for (NumberedMesh& half : pieces) half.mesh.region.resize(1, 0);
  pieces.insert(pieces.begin(), NumberedMesh{});
  ASSERT_TRUE(join_pieces(pieces));
  EXPECT_EQ(join_pieces(pieces)->region.size(), 2U);
}

TEST(JoinPieces, takes_points_without_triangles) {
  std::vector<NumberedMesh> pieces = halves();
  for (NumberedMesh& half : pieces) half.mesh.region.resize(1, 0);
  pieces.insert(pieces.begin(), piece({{5, 5}}, {4}));
  ASSERT_TRUE(join_pieces(pieces)) << error_of(pieces);
  EXPECT_EQ(join_pieces(pieces)->points.size(), 5U);
}

TEST(JoinPieces, refuses_numbers_that_are_missing_or_too_large) {
  std::vector<NumberedMesh> pieces = halves();
  pieces[1].number[2] = 4;
  EXPECT_EQ(error_of(pieces), "no piece has the point with the number 3");
  pieces[1].number[2] = UINT64_MAX;
  EXPECT_EQ(error_of(pieces), "a point has the number 18446744073709551615, but the pieces have only 6 points");
  pieces[1].number.push_back(5);
  EXPECT_EQ(error_of(pieces).substr(0, 30), "a point has the number 1844674");
}

TEST(JoinPieces, refuses_different_points_with_one_number) {
  std::vector<NumberedMesh> pieces = halves();
  pieces[1].mesh.points[1] = {1, 2};
  EXPECT_EQ(error_of(pieces), "different points have the number 2, at (1, 1) and (1, 2)");
  EXPECT_EQ(join_pieces(pieces, {1}).error().message, "different points have the number 3, at (1, 1) and (1, 2)");
  pieces[1].number[2] = 4;
  pieces[1].mesh.points[1] = pieces[0].mesh.points[2];
  EXPECT_EQ(join_pieces(pieces, {1}).error().message, "no piece has the point with the number 4");
}

TEST(JoinPieces, refuses_different_data_of_a_point) {
  const std::string message = "there are different data of the point with the number 2";
  const auto with_data = [] {
    std::vector<NumberedMesh> pieces = halves();
    for (NumberedMesh& piece : pieces) {
      piece.mesh.point_markers.resize(3);
      piece.mesh.origin.resize(3);
      piece.mesh.attributes_per_point = 2;
      piece.mesh.point_attributes.resize(6, std::numeric_limits<double>::quiet_NaN());
    }
    return pieces;
  };
  EXPECT_TRUE(join_pieces(with_data()).ok());
  std::vector<NumberedMesh> pieces = with_data();
  pieces[1].mesh.point_markers[1] = 7;
  EXPECT_EQ(error_of(pieces), message);
  pieces = with_data();
  pieces[1].mesh.origin[1] = hull_vertex;
  EXPECT_EQ(error_of(pieces), message);
  for (const std::size_t attribute : {0, 1}) {
    pieces = with_data();
    pieces[1].mesh.point_attributes[2 + attribute] = 0.5;
    EXPECT_EQ(error_of(pieces), message) << attribute;
  }
}

TEST(JoinPieces, refuses_pieces_with_different_kinds_of_data) {
  const std::string message = "the pieces do not have the same kinds of data";
  std::vector<NumberedMesh> pieces = halves();
  pieces[1].mesh.region.resize(1, 0);
  EXPECT_EQ(error_of(pieces), message);
  pieces = halves();
  pieces[0].mesh.point_markers.resize(3);
  EXPECT_EQ(error_of(pieces), message);
  pieces = halves();
  pieces[0].mesh.origin.resize(3);
  EXPECT_EQ(error_of(pieces), message);
  pieces = halves();
  pieces[1].mesh.attributes_per_point = 1;
  pieces[1].mesh.point_attributes.resize(3);
  EXPECT_EQ(error_of(pieces), message);
}

}  // namespace
}  // namespace pardel
