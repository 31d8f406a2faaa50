#include "../../ref/decomposition/quadtree.hpp"

#include <gtest/gtest.h>

#include "../../properties/domains/domains.hpp"
#include "../../ref/decomposition/cell_refiner.hpp"

namespace pardel::ref {
namespace {

TEST(TheQuadtree, has_the_leaves_around_a_leaf_in_its_buffer_zone_if_all_are_equal) {
  const Quadtree tree = uniform_quadtree({0, 0}, 8, 2);
  EXPECT_EQ(buffer_zone(tree, {0, 0, 2}), (std::set<Cell>{{0, 1, 2}, {1, 0, 2}, {1, 1, 2}}));
  EXPECT_EQ(buffer_zone(tree, {1, 2, 2}).size(), 8u);
  EXPECT_EQ(colours(tree), 4);
}

TEST(TheQuadtree, has_orthogonal_neighbours_of_neighbours_in_a_buffer_zone_and_no_others) {
  // A leaf of side 4 on the right; two leaves of side 2 on its left, and two further ones.
  const Quadtree tree{
      {0, 0},
      8,
      {{{1, 0, 1}, 0}, {{1, 1, 1}, 0}, {{0, 1, 1}, 0}, {{0, 0, 2}, 0}, {{1, 0, 2}, 0}, {{0, 1, 2}, 0}, {{1, 1, 2}, 0}}};
  // Above the neighbour on the right of (1, 0) lies (1, 1) of level 1, which does not touch it.
  EXPECT_EQ(buffer_zone(tree, {1, 0, 2}), (std::set<Cell>{{0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 1}, {1, 1, 1}}));
  EXPECT_FALSE(touch({1, 0, 2}, {1, 1, 1}));
  EXPECT_TRUE(touch({1, 1, 2}, {1, 1, 1}));
  EXPECT_FALSE(touch({1, 1, 2}, {1, 1, 2}));
}

TEST(TheQuadtree, gives_a_point_between_leaves_to_the_upper_one_and_a_point_outside_to_the_nearest) {
  const Quadtree tree = uniform_quadtree({-4, -4}, 8, 2);
  EXPECT_EQ(cell_of(tree, {0, -2}), (Cell{2, 1, 2}));
  EXPECT_EQ(cell_of(tree, {-0x1p-60, 0}), (Cell{1, 2, 2}));
  EXPECT_EQ(cell_of(tree, {-5, 100}), (Cell{0, 3, 2}));
}

TEST(TheQuadtree, compares_only_circumdisks_that_meet_the_leaf) {
  PlainMesh mesh;
  mesh.points = {{1, 1}, {3, 1}, {1, 3}};  // a right angle: the circle around (2, 2) with the squared radius 2
  mesh.triangles = {{0, 1, 2}};
  const Quadtree tree = uniform_quadtree({0, 0}, 16, 2);
  EXPECT_FALSE(is_wide_enough(tree, {0, 0, 2}, mesh));
  EXPECT_TRUE(is_wide_enough(tree, {0, 0, 2}, mesh, 0.36));
  EXPECT_TRUE(is_wide_enough(tree, {1, 0, 2}, mesh));
  EXPECT_FALSE(may_be_refined(tree, {1, 1, 2}, mesh));
  EXPECT_TRUE(may_be_refined(tree, {2, 2, 2}, mesh));
  EXPECT_FALSE(allows(tree, mesh));
  EXPECT_TRUE(allows(uniform_quadtree({0, 0}, 16, 0), mesh));
}

/// Touching is decided exactly, in all directions: the disk around (3, 4) with the radius 5 reaches from -2 to 8 and
/// from -1 to 9.
TEST(TheQuadtree, has_a_leaf_that_is_wide_enough_if_a_large_open_disk_only_touches_it) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {6, 0}, {6, 8}};
  mesh.triangles = {{0, 1, 2}};
  constexpr double inwards = 0x1p-33;
  struct Touching {
    Point corner, step;
  };
  for (const auto& [corner, step] : {Touching{{8, 0}, {-inwards, 0}}, Touching{{-10, 0}, {inwards, 0}},
                                     Touching{{0, 9}, {0, -inwards}}, Touching{{0, -9}, {0, inwards}}}) {
    const Cell leaf{0, 0, 0};
    EXPECT_TRUE(is_wide_enough(uniform_quadtree(corner, 8, 0), leaf, mesh));
    const Point nearer{corner.x + step.x, corner.y + step.y};
    EXPECT_FALSE(is_wide_enough(uniform_quadtree(nearer, 8, 0), leaf, mesh));
  }
}

TEST(CellRefiner, works_in_several_leaves_of_the_square_at_once) {
  Goal coarse, fine;
  coarse.max_area = 0.002;
  fine.max_area = 0.001;
  const auto refined = refine_on_quadtree(domains::square(), fine, coarse);
  ASSERT_TRUE(refined.ok()) << refined.error().message;
  std::size_t most = 0;
  for (const Phase& phase : refined->sweeps.front().phases) most = std::max(most, phase.touched.size());
  EXPECT_GE(most, 2u);
}

}  // namespace
}  // namespace pardel::ref
