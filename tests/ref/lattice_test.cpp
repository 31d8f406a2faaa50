#include "../../ref/decomposition/lattice.hpp"

#include <gtest/gtest.h>

#include "../../properties/domains/domains.hpp"
#include "../../ref/decomposition/cell_refiner.hpp"

namespace pardel::ref {
namespace {

TEST(TheLattice, has_cells_of_four_circumradii_from_the_corner_of_the_mesh_on) {
  PlainMesh mesh;
  mesh.points = {{1, 2}, {5, 2}, {1, 5}};  // a right angle: the circumradius is 2.5
  mesh.triangles = {{0, 1, 2}};
  const Lattice lattice = lattice_over(mesh);
  EXPECT_EQ(lattice.corner, ExactPoint(1, 2));
  EXPECT_GE(lattice.side, 10);
  EXPECT_LT(lattice.side, 10 + 0x1p-40);
  EXPECT_TRUE(allows(lattice, mesh));
  mesh.points[1] = {5 + 0x1p-30, 2};
  EXPECT_FALSE(allows(lattice, mesh));
}

TEST(TheLattice, gives_a_point_between_two_cells_to_the_upper_one) {
  const Lattice lattice{{1, 2}, 10};
  EXPECT_EQ(cell_of(lattice, {1, 2}), (Cell{0, 0}));
  EXPECT_EQ(cell_of(lattice, {11, 12}), (Cell{1, 1}));
  EXPECT_EQ(cell_of(lattice, {11 - 0x1p-48, 12}), (Cell{0, 1}));
  EXPECT_EQ(cell_of(lattice, {0, -9}), (Cell{-1, -2}));
  EXPECT_EQ(cell_of({{0, 0}, Number(1) / 3}, {1, 2.0 / 3}), (Cell{3, 1}));  // the double is below 2/3
}

TEST(TheLattice, has_four_colours_that_no_two_neighbours_share) {
  const Lattice lattice{{0, 0}, 1};
  EXPECT_EQ(colours(lattice), 4);
  EXPECT_EQ(colour_of(lattice, {2, 5}), 2);
  EXPECT_EQ(colour_of(lattice, {-1, -2}), 1);
  for (std::int64_t i = -1; i <= 1; ++i)
    for (std::int64_t j = -1; j <= 1; ++j) {
      const Cell cell{i, j}, centre{0, 0};
      EXPECT_EQ(colour_of(lattice, cell) == colour_of(lattice, centre), cell == centre);
    }
}

TEST(CellRefiner, works_in_several_cells_of_the_square_at_once) {
  Goal coarse, fine;
  coarse.max_area = 0.004;
  fine.max_area = 0.002;
  const auto refined = refine_on_lattice(domains::square(), fine, coarse);
  ASSERT_TRUE(refined.ok()) << refined.error().message;
  const Sweep<Lattice>& first = refined->sweeps.front();
  EXPECT_EQ(first.phases.size(), 4u);
  EXPECT_GE(first.phases.front().touched.size(), 2u);
}

TEST(CellRefiner, says_first_what_is_wrong_with_the_goal_and_then_with_the_coarse_one) {
  const Goal hull{.convex_hull = true}, steep{.min_angle_deg = 30};
  EXPECT_EQ(refine_on_lattice(domains::square(), hull, steep).error().message,
            unsupported(domains::square(), hull)->message);
  EXPECT_EQ(refine_on_lattice(domains::square(), steep, hull).error().message,
            unsupported(domains::square(), steep)->message);
}

TEST(CellRefiner, sized_by_a_theorem_refuses_a_goal_that_it_cannot_reach) {
  const Goal steep{.min_angle_deg = 21}, coarse{.max_area = 0.01};
  const auto refused = refine_on_lattice_sized_by(RadiusTheorem::t3_sharp, domains::square(), steep, coarse);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().message, unsupported(domains::square(), steep)->message);
}

TEST(CellRefiner, refuses_what_ruppert_does) {
  Goal steep;
  steep.min_angle_deg = 21;
  for (const auto& refused :
       {refine_on_lattice(domains::star(5, 5), {}, {}), refine_on_lattice(domains::square(), steep, {}),
        refine_on_lattice(domains::square(), {}, steep), refine_on_lattice(domains::random_points(10, 1), {}, {})}) {
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
  }
}

/// The midpoint of the lower side needs one binary digit more than a double has. The coarse mesh does without it.
TEST(CellRefiner, ends_in_the_phase_that_finds_a_midpoint_that_is_not_representable) {
  const double left = 1 + 0x1p-52;
  Pslg pslg;
  pslg.points = {{left, 0}, {2, 0}, {2, 1}, {left, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const Goal coarse, fine{.max_area = 0.02};
  ASSERT_TRUE(refine_on_lattice(pslg, coarse, coarse).ok());
  for (const Turns& turns : {Turns(in_rounds), Turns(one_after_the_other)}) {
    const auto refined = refine_on_lattice(pslg, fine, coarse, turns);
    ASSERT_FALSE(refined.ok());
    EXPECT_EQ(refined.error().kind, ErrorKind::invalid_input);
    EXPECT_EQ(refined.error().message, "The midpoint of a subsegment is not representable.");
  }
}

/// A rectangle of two triangles. Its long sides are split in different phases, because a cell ends between them: the
/// small square below is where the lattice begins. After the first split, the circle through the ends of the other side
/// and the new vertex is too large for the cells.
TEST(CellRefiner, takes_larger_cells_as_soon_as_a_circumradius_has_outgrown_them) {
  Pslg pslg;
  pslg.points = {{-2, 0}, {2, 0}, {2, 1}, {-2, 1}, {-2, -8}, {-1, -8}, {-1, -7}, {-2, -7}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const auto refined = refine_on_lattice(pslg, {.min_angle_deg = 20}, {.min_angle_deg = 0});
  ASSERT_TRUE(refined.ok()) << refined.error().message;
  const PlainMesh* before = &refined->preprocessed;
  for (const Sweep<Lattice>& sweep : refined->sweeps)
    for (const Phase& phase : sweep.phases) {
      EXPECT_TRUE(allows(sweep.cells, *before));
      before = &phase.after;
    }
  ASSERT_GE(refined->sweeps.size(), 2U);
  EXPECT_EQ(refined->sweeps[0].phases.size(), 3U);
  EXPECT_FALSE(allows(refined->sweeps[0].cells, refined->sweeps[0].phases.back().after));
  EXPECT_EQ(refined->sweeps.back().phases.size(), 4U);
}

/// A subsegment waits from the phase in which a cell finds it to the phase of the cell that splits it. Other cells that
/// find it in between hand nothing on.
TEST(CellRefiner, hands_each_subsegment_on_once) {
  const auto refined = refine_on_lattice(domains::touching_holes(), {.max_area = 0.025}, {.max_area = 0.1});
  ASSERT_TRUE(refined.ok()) << refined.error().message;
  std::set<ExactPoint> midpoints;
  for (const Sweep<Lattice>& sweep : refined->sweeps)
    for (const Phase& phase : sweep.phases)
      for (const HandedOn& handed_on : phase.handed_on) EXPECT_TRUE(midpoints.insert(handed_on.point).second);
  EXPECT_EQ(midpoints.size(), 2U);
}

}  // namespace
}  // namespace pardel::ref
