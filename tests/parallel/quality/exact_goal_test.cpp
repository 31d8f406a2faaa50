#include "../../../parallel/quality/exact_goal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "../../../parallel/quality/criteria.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../../../properties/checker/tolerances.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

/// A triangle with the area 6 and the longest edge 5.
constexpr std::array<Point, 3> right_triangle{{{0, 0}, {3, 0}, {0, 4}}};

bool keeps_sizes(const ExactGoal& goal) {
  return goal.keeps_sizes(right_triangle[0], right_triangle[1], right_triangle[2]);
}

double next(double x) { return std::nextafter(x, INFINITY); }
double previous(double x) { return std::nextafter(x, 0); }

TEST(ExactGoal, allows_areas_and_edges_up_to_the_bound) {
  EXPECT_TRUE(keeps_sizes(ExactGoal({.max_area = 6, .max_edge = 5}, {})));
  EXPECT_FALSE(keeps_sizes(ExactGoal({.max_area = previous(6)}, {})));
  EXPECT_FALSE(keeps_sizes(ExactGoal({.max_edge = previous(5)}, {})));
  EXPECT_TRUE(Criteria({.max_area = 6}, Placement::off_centre, {})
                  .too_large(Measure(Shape(right_triangle[0], right_triangle[1], right_triangle[2]))))
      << "criteria are stricter";
}

TEST(ExactGoal, allows_sizes_and_caps_at_the_centroid) {
  const auto size = [](double at) { return [at](Point p) { return p.x == 1 ? at : 100.0; }; };
  EXPECT_TRUE(keeps_sizes(ExactGoal({.size = size(5)}, {})));
  EXPECT_FALSE(keeps_sizes(ExactGoal({.size = size(previous(5))}, {})));
  EXPECT_TRUE(keeps_sizes(ExactGoal({}, size(6))));
  EXPECT_FALSE(keeps_sizes(ExactGoal({}, size(previous(6)))));
}

TEST(ExactGoal, without_a_bound_allows_everything) {
  EXPECT_TRUE(ExactGoal({.min_angle_deg = 0}, {}).keeps_sizes({0, 0}, {1e60, 0}, {0, 1e60}));
  EXPECT_TRUE(ExactGoal({.min_angle_deg = 0}, {}).keeps_angles({0, 0}, {1e60, 0}, {0, 1}));
}

/// The bounds lie just above and just below the smallest angle, up to a few roundings.
TEST(ExactGoal, decides_about_angles_as_the_checker_does) {
  samples::Random random(5);
  int kept = 0, decisions = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point p{random.uniform(-1, 1), random.uniform(-1, 1)}, q{random.uniform(2, 3), random.uniform(-1, 1)};
    const Point r{random.uniform(-1, 3), random.uniform(2, 4)};
    const auto angle = [](Point o, Point u, Point v) {
      return std::atan2((u.x - o.x) * (v.y - o.y) - (u.y - o.y) * (v.x - o.x),
                        (u.x - o.x) * (v.x - o.x) + (u.y - o.y) * (v.y - o.y)) *
             180 / std::numbers::pi;
    };
    double bound = std::min({angle(p, q, r), angle(q, r, p), angle(r, p, q)});
    for (int step = random.below(7); step > 0; --step) bound = i % 2 == 0 ? next(bound) : previous(bound);
    const double cosine = angle_cosine_bound(bound);
    const bool breaks = checker::exactly::cosine_exceeds(p, q, r, cosine) ||
                        checker::exactly::cosine_exceeds(q, r, p, cosine) ||
                        checker::exactly::cosine_exceeds(r, p, q, cosine);
    const bool keeps = ExactGoal({.min_angle_deg = bound}, {}).keeps_angles(p, q, r);
    EXPECT_EQ(keeps, !breaks) << bound;
    kept += keeps ? 1 : 0;
    ++decisions;
  }
  EXPECT_GT(kept, decisions / 4);
  EXPECT_LT(kept, 3 * decisions / 4);
}

}  // namespace
}  // namespace pardel::engine
