#include "../../ref/radius_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "../../properties/domains/domains.hpp"
#include "../../ref/decomposition/cell_refiner.hpp"

namespace pardel::ref {
namespace {

/// 30 degrees, that is ρ̄ = 1; areas of at most 1.
Goal thirty_degrees_and_area_one() {
  Goal goal;
  goal.min_angle_deg = 30;
  goal.max_area = 1;
  return goal;
}

double at_thirty_degrees(RadiusTheorem theorem) {
  return CGAL::to_double(*squared_radius_bound(thirty_degrees_and_area_one(), theorem));
}

/// Two parallel segments of length 8 at the distance `gap`, and a third one at the origin in the direction (x, y).
Pslg two_bars_and_a_corner(double gap, double x, double y) {
  Pslg pslg;
  pslg.points = {{0, 0}, {8, 0}, {0, -gap}, {8, -gap}, {x, y}};
  pslg.segments = {{0, 1}, {2, 3}, {0, 4}};
  return pslg;
}

TEST(RadiusBound, at_thirty_degrees_is_two_by_t3_and_a_little_less_by_t3_sharp) {
  EXPECT_NEAR(at_thirty_degrees(RadiusTheorem::t3), 4, 1e-9);
  EXPECT_NEAR(at_thirty_degrees(RadiusTheorem::t3_sharp), 4 / std::sqrt(3), 1e-9);
}

TEST(RadiusBound, is_not_rounded_down) {
  const Goal goal = thirty_degrees_and_area_one();
  const Number ratio = 1 / Number(inverse_squared_ratio(goal)), bound = *squared_radius_bound(goal, RadiusTheorem::t3);
  EXPECT_GE(bound * bound, 16 * ratio * ratio * ratio);
}

TEST(RadiusBound, needs_bounds_on_angles_and_on_areas) {
  Goal no_areas = thirty_degrees_and_area_one(), no_angles = no_areas;
  no_areas.max_area = Goal().max_area;
  no_angles.min_angle_deg = 0;
  for (const Goal& goal : {no_areas, no_angles}) {
    const auto bound = squared_radius_bound(goal, RadiusTheorem::t3);
    ASSERT_FALSE(bound.ok());
    EXPECT_EQ(bound.error().kind, ErrorKind::usage);
  }
  EXPECT_FALSE(refine_on_lattice_sized_by(RadiusTheorem::t3, domains::square(), {}, {}).ok());
}

TEST(GrowthBound, is_one_for_right_angles_and_distant_segments) {
  EXPECT_EQ(squared_growth_bound(two_bars_and_a_corner(3, 0, 5), 9), 1);
  EXPECT_EQ(squared_growth_bound(two_bars_and_a_corner(3, -4, 5), 9), 1);
  EXPECT_EQ(squared_growth_bound(domains::square(), Number(1) / 4), 1);
}

TEST(GrowthBound, is_the_inverse_of_the_sine_of_a_sharp_corner) {
  EXPECT_EQ(squared_growth_bound(two_bars_and_a_corner(3, 3, 4), 9), Number(25) / 16);
}

/// r0 = 6 and λ = 3: (2 + 1/2) / 2.
TEST(GrowthBound, depends_on_the_distance_of_segments_that_are_nearer_than_the_bound_at_the_start) {
  EXPECT_EQ(squared_growth_bound(two_bars_and_a_corner(3, 0, 5), 36), Number(25) / 16);
}

TEST(GrowthBound, does_not_depend_on_the_order_of_the_segments) {
  const auto by_ends = [](const Segment& s, const Segment& t) { return std::pair(s.a, s.b) < std::pair(t.a, t.b); };
  for (const auto& [pslg, start] :
       {std::pair(two_bars_and_a_corner(3, 3, 4), 9), {two_bars_and_a_corner(3, 0, 5), 36}}) {
    Pslg ordered = pslg;
    std::ranges::sort(ordered.segments, by_ends);
    do {
      EXPECT_EQ(squared_growth_bound(ordered, start), Number(25) / 16);
    } while (std::ranges::next_permutation(ordered.segments, by_ends).found);
  }
}

TEST(LatticeRefiner, uses_one_lattice_if_it_is_computed_before_a_mesh_exists) {
  Goal coarse, fine;
  coarse.max_area = 0.01;
  fine.max_area = 0.005;
  const auto refined = refine_on_lattice_sized_by(RadiusTheorem::t3_sharp, domains::square(), fine, coarse);
  ASSERT_TRUE(refined.ok()) << refined.error().message;
  for (const Sweep<Lattice>& sweep : refined->sweeps) {
    EXPECT_EQ(sweep.phases.size(), 4U);
    EXPECT_NEAR(CGAL::to_double(sweep.cells.side), 4 * 0.2459, 1e-3);
  }
}

}  // namespace
}  // namespace pardel::ref
