#include "../../fuzz/mesh_in_pieces.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../../core/digest.hpp"
#include "../../core/join_pieces.hpp"

namespace pardel::fuzz {
namespace {

/// Three triangles around the point 0, and the outline as constrained edges.
Mesh fan() {
  Mesh mesh;
  for (const Point p : {Point{0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 0}}) mesh.points.push_back(p);
  for (const Index i : {1U, 2U, 3U}) {
    mesh.triangles.push_back({{0, i, i + 1}, {}});
    mesh.region.push_back(i == 2 ? 1 : 0);
    mesh.constrained_edges.push_back({i, i + 1, no_index, static_cast<int>(i)});
  }
  mesh.region_attributes = {5, -2};
  mesh.attributes_per_point = 1;
  for (const double a : {1.5, 2.5, 3.5, 4.5, 5.5}) mesh.point_attributes.push_back(a);
  return mesh;
}

TEST(MeshInPieces, joined_again_are_the_mesh) {
  for (const std::size_t count : {1U, 2U, 3U}) {
    const std::optional<MeshInPieces> divided = in_pieces(fan(), count);
    ASSERT_TRUE(divided);
    std::vector<NumberedMesh> pieces;
    for (std::size_t rank = 0; rank < count; ++rank) {
      pieces.push_back({divided->mesh[rank], {}});
      for (const std::uint64_t number : divided->number[rank]) pieces.back().number.push_back(number);
    }
    const Result<Mesh> joined = join_pieces(pieces);
    ASSERT_TRUE(joined) << joined.error().message;
    EXPECT_EQ(joined->points, fan().points);
    EXPECT_EQ(joined->point_attributes, fan().point_attributes);
    EXPECT_EQ(digest(*joined), digest(fan()));
  }
}

TEST(MeshInPieces, have_about_equally_many_triangles) {
  const std::optional<MeshInPieces> divided = in_pieces(fan(), 2);
  ASSERT_TRUE(divided);
  EXPECT_EQ(divided->mesh[0].triangles.size(), 1U);
  EXPECT_EQ(divided->mesh[1].triangles.size(), 2U);
}

TEST(MeshInPieces, know_the_vertices_that_they_share) {
  const std::optional<MeshInPieces> divided = in_pieces(fan(), 2);
  ASSERT_TRUE(divided);
  for (const std::size_t rank : {0U, 1U}) {
    const PieceOfMesh piece = divided->piece(rank);
    ASSERT_EQ(piece.shared.size(), 1U);
    EXPECT_EQ(piece.shared[0].rank, rank == 0 ? 1 : 0);
    std::vector<std::uint64_t> numbers;
    for (const Index v : piece.shared[0].vertices) numbers.push_back(piece.number[v]);
    EXPECT_EQ(numbers, (std::vector<std::uint64_t>{0, 2}));
  }
}

TEST(MeshInPieces, do_not_exist_for_every_mesh) {
  Mesh lonely = fan();
  lonely.points.push_back({9, 9});
  lonely.point_attributes.push_back(0);
  EXPECT_FALSE(in_pieces(lonely, 2)) << "a point without a triangle";
  Mesh crossing = fan();
  crossing.constrained_edges.push_back({1, 4, no_index, 0});
  EXPECT_FALSE(in_pieces(crossing, 2)) << "an edge from one piece to the other";
  Mesh flat = fan();
  flat.triangles[2].v[2] = flat.triangles[2].v[1];
  EXPECT_FALSE(in_pieces(flat, 2)) << "a triangle with equal corners";
  Mesh single = fan();
  single.triangles.resize(1);
  single.region.resize(1);
  EXPECT_FALSE(in_pieces(single, 2)) << "one triangle";
}

}  // namespace
}  // namespace pardel::fuzz
