// The parts of many_signs: hard points are hard, certain signs are true, and a wrong sign is noticed.
#include <gtest/gtest.h>

#include <cmath>

#include "../../fuzz/exact_signs.hpp"
#include "../../fuzz/many_signs/certified.hpp"
#include "../../fuzz/many_signs/compare.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;

constexpr int many = 20'000;

double rounded_orientation(Point a, Point b, Point c) { return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x); }
double rounded_incircle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  return (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
         (cx * cx + cy * cy) * (ax * by - ay * bx);
}

Comparison compared(const Predicates& predicates) {
  Comparison result;
  Random random(5);
  for (int i = 0; i < many; ++i) compare_all(hard_points(random), result, predicates);
  return result;
}

TEST(ExactSigns, are_those_of_small_figures) {
  EXPECT_EQ(true_orientation({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(true_orientation({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(true_orientation({0, 0}, {0x1p-140, 0x1p-140}, {0x1p200, 0x1p200}), 0);
  EXPECT_EQ(true_orientation({0, 0}, {0x1p-140, 0x1p-140}, {0x1p200, std::nextafter(0x1p200, 0)}), -1);
  EXPECT_EQ(true_incircle({0, 0}, {1, 0}, {1, 1}, {0, 1}), 0);
  EXPECT_EQ(true_incircle({0, 0}, {1, 0}, {1, 1}, {0x1p-140, 1}), 1);
  EXPECT_EQ(true_incircle({0, 0}, {1, 0}, {1, 1}, {-0x1p-140, 1}), -1);
}

TEST(CertainSigns, are_true_and_found_for_nearly_all_random_points) {
  Random random(3);
  int open = 0;
  for (int i = 0; i < many; ++i) {
    for (const bool hard : {false, true}) {
      const auto [a, b, c, d] = hard ? hard_points(random) : random_points(random);
      const auto turn = certain_orientation(a, b, c), in = certain_incircle(a, b, c, d);
      EXPECT_EQ(turn.value_or(true_orientation(a, b, c)), true_orientation(a, b, c));
      EXPECT_EQ(in.value_or(true_incircle(a, b, c, d)), true_incircle(a, b, c, d));
      if (!in && !hard) ++open;
    }
  }
  EXPECT_LT(open, many / 5);
}

TEST(HardPoints, reach_every_stage_of_the_predicates) {
  const Comparison found = compared({});
  EXPECT_EQ(found.differences, 0U) << found.first_difference;
  EXPECT_GT(found.zeros, many / 10);
  EXPECT_GT(found.filters, many);
  for (const std::uint64_t count : found.incircle_stages) EXPECT_GT(count, many / 200);
  EXPECT_EQ(found.orient2d_stages[0], 0U);  // it has no stage for small lattices
  for (std::size_t stage = 1; stage < 5; ++stage) EXPECT_GT(found.orient2d_stages[stage], many / 200) << stage;
}

TEST(Comparison, notices_predicates_that_trust_rounded_determinants) {
  EXPECT_GT(compared({.orient2d = rounded_orientation}).differences, 100U);
  const Comparison found = compared({.incircle = rounded_incircle});
  EXPECT_GT(found.differences, 100U);
  EXPECT_TRUE(found.first_difference.starts_with("incircle at (")) << found.first_difference;
}

TEST(Comparison, adds_up) {
  Comparison sum;
  Random random(1);
  compare(random_points(random), sum);
  Comparison wrong;
  for (int i = 0; i < 100; ++i)
    compare(hard_points(random), wrong, {.orient2d = [](Point, Point, Point) { return 2.0; }});
  sum.add(wrong);
  EXPECT_EQ(sum.orientations, 101U);
  EXPECT_EQ(sum.incircles, 101U);
  EXPECT_EQ(sum.differences, wrong.differences);
  EXPECT_EQ(sum.first_difference, wrong.first_difference);
  EXPECT_GT(sum.differences, 10U);
}

}  // namespace
}  // namespace pardel::fuzz
