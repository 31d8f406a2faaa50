// Several ranks make the mesh of points that none of them has as a whole.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../distribution/whole_of_pieces.hpp"
#include "../given_points/part_of_rank.hpp"
#include "../samples.hpp"

namespace pardel {
namespace {

using properties::on_ranks;

std::vector<MeshPiece> meshed_pieces(const Pslg& pslg, const Goal& goal, const Options& options, int count) {
  std::vector<MeshPiece> pieces(static_cast<std::size_t>(count));
  on_ranks(count, [&](Ranks& ranks) {
    Result<MeshPiece> piece = mesh(part_of(pslg, ranks), goal, options, ranks);
    ASSERT_TRUE(piece) << count << " ranks, rank " << ranks.rank() << ": " << piece.error().message;
    pieces[ranks.rank()] = std::move(*piece);
  });
  return pieces;
}

/// The pieces are those of the mesh of one process, and have the numbers that ranks give that know the whole domain.
void expect_the_mesh_of_one_process(const Pslg& pslg, const Goal& goal, Options options, const std::string& name) {
  SCOPED_TRACE(name);
  options.threads = 1;
  const Result<Meshed> whole = mesh(pslg, goal, options);
  ASSERT_TRUE(whole) << whole.error().message;
  const auto expected = unnumbered(whole->mesh);
  const ValidPslg domain = std::move(validate(pslg)).value();
  std::vector<MeshPiece> known(2);
  on_ranks(2, [&](Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, goal, options, ranks);
    ASSERT_TRUE(piece);
    known[ranks.rank()] = std::move(*piece);
  });
  const std::uint64_t missed = known[0].missed;
  const Mesh numbered = joined(known);
  for (const int count : {1, 2, 3, 5, 8}) {
    std::vector<MeshPiece> pieces = meshed_pieces(pslg, goal, options, count);
    expect_shared_vertices(pieces);
    for (const MeshPiece& piece : pieces) {
      expect_neighbours(piece);
      EXPECT_EQ(piece.points, whole->mesh.points.size());
      EXPECT_EQ(piece.triangles, whole->mesh.triangles.size());
      EXPECT_EQ(piece.constrained_edges, whole->mesh.constrained_edges.size());
      EXPECT_EQ(piece.report.inserted, whole->report.inserted);
      EXPECT_EQ(piece.report.segment_splits, whole->report.segment_splits);
      EXPECT_EQ(piece.missed, missed);
    }
    const Mesh joint = joined(pieces);
    EXPECT_TRUE(std::ranges::equal(joint.points, numbered.points)) << count << " ranks";
    EXPECT_TRUE(unnumbered(joint) == expected) << count << " ranks";
  }
}

TEST(MeshOfPoints, is_the_mesh_of_one_process) {
  const Pslg points = domains::random_points(3'000, 3);
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 28}, {.triangles_per_tile = 100}, "angles");
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 20}, {}, "few tiles");
  expect_the_mesh_of_one_process(points, {.max_area = 1e-5}, {.triangles_per_tile = 300}, "areas");
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 25, .max_edge = 0.02}, {.cells = {7, 5}}, "edges");
  expect_the_mesh_of_one_process(points, {.min_angle_deg = 30}, {.decomposition = Decomposition::none}, "one tile");
}

TEST(MeshOfPoints, in_difficult_positions_is_the_mesh_of_one_process) {
  for (const engine::samples::Family& family : engine::samples::families(400, 5))
    expect_the_mesh_of_one_process(with_points(family.points), {.min_angle_deg = 25},
                                   {.triangles_per_tile = 50, .min_edge = 0}, family.name);
}

}  // namespace
}  // namespace pardel
