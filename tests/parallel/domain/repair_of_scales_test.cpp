// repair() without a given snapping distance, of domains that mix scales: each part is repaired as if it was alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "../../../parallel/mesher.hpp"
#include "../../../parallel/repair.hpp"
#include "../../../parallel/validate.hpp"
#include "../shapes.hpp"
#include "drawing.hpp"

namespace pardel::engine {
namespace {

using testing::add_square;
using testing::Drawing;
using testing::square;

using Places = std::set<std::array<double, 2>>;

Pslg by_default(const Pslg& pslg) {
  Result<Repaired> result = repair(pslg);
  EXPECT_TRUE(result.ok()) << result.error().message;
  return result ? std::move(result->domain).pslg() : Pslg();
}

Pslg united(Pslg pslg, const Pslg& added) {
  const auto first = static_cast<Index>(pslg.points.size());
  pslg.points.insert(pslg.points.end(), added.points.begin(), added.points.end());
  for (const Segment& s : added.segments) pslg.segments.push_back({first + s.a, first + s.b, s.marker});
  pslg.holes.insert(pslg.holes.end(), added.holes.begin(), added.holes.end());
  pslg.regions.insert(pslg.regions.end(), added.regions.begin(), added.regions.end());
  return pslg;
}

/// A square with two crossing diagonals; a wall that ends one rounding beside the lower side, and one beside which a
/// point lies; two pairs of points that are one rounding apart; and a slit, wider than the default distance, that is
/// much narrower than the walls around it.
Pslg damaged_square(double side, Point at) {
  Pslg pslg;
  const auto place = [&](double x, double y) { return Point{at.x + x * side, at.y + y * side}; };
  const auto wall = [&](Point a, Point b, int marker) {
    const auto first = static_cast<Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {a, b});
    pslg.segments.push_back({first, first + 1, marker});
  };
  add_square(pslg, side, at, 1);
  pslg.segments.push_back({0, 2, 2});
  pslg.segments.push_back({1, 3, 3});
  wall(place(0.25, 0x1p-46), place(0.25, 0.125), 4);
  wall(place(0.125, 0.5), place(0.125, 0.75), 5);
  pslg.points.push_back(place(0.125 + 0x1p-46, 0.625));
  pslg.points.push_back(place(0.5, 0.75));
  pslg.points.push_back(place(0.5, 0.75 + 0x1p-46));
  wall(place(0.625, 0.75), place(0.75, 0.875), 6);
  wall(place(0.75 + 0x1p-46, 0.875), place(0.875, 0.75), 7);
  wall(place(0.375, 0.0625), place(0.625, 0.0625), 8);
  wall(place(0.375, 0.0625 + 0x1p-34), place(0.625, 0.0625 + 0x1p-34), 9);
  return pslg;
}

/// Expects the repair of both parts to be that of each one alone, in both orders.
void expect_as_alone(const Pslg& small, const Pslg& huge, const std::string& what) {
  Drawing alone(by_default(small));
  alone.add(by_default(huge));
  EXPECT_EQ(Drawing(by_default(united(small, huge))), alone) << what;
  EXPECT_EQ(Drawing(by_default(united(huge, small))), alone) << what;
}

constexpr std::array<double, 4> huge_sides{0x1p10, 0x1p20, 0x1p50, 0x1p80};

TEST(RepairOfScales, has_something_to_do_in_the_small_square) {
  const Pslg damaged = damaged_square(1, {-3, -2}), whole = by_default(damaged);
  EXPECT_EQ(whole.points.size(), damaged.points.size() - 4 + 2);
  EXPECT_EQ(whole.segments.size(), damaged.segments.size() - 1 + 6);
}

TEST(RepairOfScales, of_a_small_square_beside_a_huge_one_is_that_of_the_small_one_alone) {
  for (const double side : huge_sides) {
    const Pslg small = damaged_square(1, {-3, -2});
    expect_as_alone(small, square(side), std::to_string(side));
    expect_as_alone(small, damaged_square(side, {0, 0}), "both are damaged: " + std::to_string(side));
  }
}

TEST(RepairOfScales, of_a_small_square_inside_a_huge_one_is_that_of_the_small_one_alone) {
  for (const double side : huge_sides) {
    Pslg huge;
    add_square(huge, side, {-side / 2, -side / 2});
    expect_as_alone(damaged_square(1, {2, 1}), huge, std::to_string(side));
  }
}

TEST(RepairOfScales, of_three_squares_of_different_scales_is_that_of_each_alone) {
  const Pslg small = damaged_square(1, {-3, -2}), middle = damaged_square(0x1p30, {0x1p10, 0x1p10}),
             huge = damaged_square(0x1p60, {0x1p31, -0x1p60});
  Drawing alone(by_default(small));
  alone.add(by_default(middle));
  alone.add(by_default(huge));
  EXPECT_EQ(Drawing(by_default(united(united(huge, small), middle))), alone);
}

TEST(RepairOfScales, is_not_changed_by_far_points) {
  Pslg pslg = damaged_square(1, {-3, -2});
  const Pslg alone = by_default(pslg);
  const std::vector<Point> far{{0x1p20, 3}, {-0x1p50, 0x1p50}, {0x1p80, 0}, {0x1p80, 1}};
  pslg.points.insert(pslg.points.begin(), far.begin(), far.begin() + 2);
  for (Segment& s : pslg.segments) s = {s.a + 2, s.b + 2, s.marker};
  pslg.points.insert(pslg.points.end(), far.begin() + 2, far.end());
  Drawing expected(alone);
  for (const Point p : {far[0], far[1], far[2]}) expected.points.insert({p.x, p.y});  // the last two are one place
  EXPECT_EQ(Drawing(by_default(pslg)), expected);
}

TEST(RepairOfScales, keeps_the_hole_of_a_small_square_close_to_the_side_of_a_huge_one) {
  Pslg small = square(4);
  for (Point& p : small.points) p = {p.x - 5, p.y - 5};
  add_square(small, 2, {-4, -4});
  small.holes = {{-3, -3}};
  const Pslg both = by_default(united(damaged_square(0x1p50, {0, 0}), small));
  EXPECT_EQ(both.holes, small.holes);
}

/// The places of the mesh in a box.
Places places_in(const Mesh& mesh, Point low, Point high) {
  Places places;
  for (const Point p : mesh.points)
    if (p.x >= low.x && p.y >= low.y && p.x <= high.x && p.y <= high.y) places.insert({p.x, p.y});
  return places;
}

TEST(RepairOfScales, gives_a_small_square_the_mesh_that_it_has_alone) {
  const Pslg small = damaged_square(1, {-3, -2});
  for (const double side : huge_sides) {
    Pslg huge;
    add_square(huge, side, {0, 0});
    const auto mesh_of = [](const Pslg& pslg) {
      return mesh(repair(pslg)->domain, {.min_angle_deg = 20.7}, {.threads = 2}).value();
    };
    const Meshed alone = mesh_of(small), both = mesh_of(united(huge, small));
    EXPECT_TRUE(both.report.goal_met());
    EXPECT_EQ(places_in(both.mesh, {-3, -2}, {-2, -1}), places_in(alone.mesh, {-3, -2}, {-2, -1})) << side;
  }
}

}  // namespace
}  // namespace pardel::engine
