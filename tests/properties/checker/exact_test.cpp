// The checker's arithmetic is exact where floating-point arithmetic is not.
#include "../../../properties/checker/arithmetic/exact.hpp"

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../../../properties/checker/arithmetic/exact_sum.hpp"

namespace pardel::checker {
namespace {

double up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double down(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

TEST(Orientation, distinguishes_one_unit_in_the_last_place_from_collinear) {
  const Point a{12, 12}, b{24, 24};
  EXPECT_EQ(checker::exactly::orientation(a, b, {0.5, 0.5}), 0);
  EXPECT_EQ(checker::exactly::orientation(a, b, {0.5, up(0.5)}), 1);
  EXPECT_EQ(checker::exactly::orientation(a, b, {0.5, down(0.5)}), -1);
}

TEST(Orientation, holds_for_the_least_and_the_largest_doubles) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(checker::exactly::orientation({0, 0}, {tiny, 0}, {0, tiny}), 1);
  EXPECT_EQ(checker::exactly::orientation({0, 0}, {tiny, tiny}, {3 * tiny, 3 * tiny}), 0);
  EXPECT_EQ(checker::exactly::orientation({0, 0}, {1e308, 0}, {0, tiny}), 1);
  EXPECT_EQ(checker::exactly::orientation({-1e308, -1e308}, {1e308, 1e308}, {tiny, 0}), -1);
}

TEST(InCircle, is_zero_exactly_on_the_circle) {
  // The points lie on the circle x^2 + y^2 = 25^2, moved far from the origin.
  const auto on = [](double x, double y) { return Point{x + 0x1p40, y + 0x1p40}; };
  EXPECT_EQ(checker::exactly::in_circle(on(25, 0), on(7, 24), on(-15, 20), on(-24, -7)), 0);
  Point d = on(-24, -7);
  d.x = up(d.x);
  EXPECT_EQ(checker::exactly::in_circle(on(25, 0), on(7, 24), on(-15, 20), d), 1);
  d.x = down(down(d.x));
  EXPECT_EQ(checker::exactly::in_circle(on(25, 0), on(7, 24), on(-15, 20), d), -1);
}

TEST(Cosine, is_compared_as_a_rational_number) {
  // cos 45 degrees is irrational, so every double is above or below it. Its square shows which.
  const double near = std::sqrt(0.5);
  for (double c : {down(near), near, up(near)}) {
    const bool below = CGAL::Gmpq(c) * CGAL::Gmpq(c) < CGAL::Gmpq(1, 2);
    EXPECT_EQ(checker::exactly::cosine_exceeds({0, 0}, {1, 1}, {1, 0}, c), below) << c;
  }
  EXPECT_FALSE(checker::exactly::cosine_exceeds({0, 0}, {0, 3}, {5, 0}, 0)) << "a right angle has cosine 0";
  EXPECT_TRUE(checker::exactly::cosine_exceeds({0, 0}, {0x1p-1000, 3}, {5, 0}, 0))
      << "slightly less than a right angle";
  EXPECT_FALSE(checker::exactly::cosine_exceeds({0, 0}, {-1, 0}, {1, 0}, 0.5))
      << "an obtuse angle has a negative cosine";
}

TEST(Area, exceeds_its_bound_by_a_unit_in_the_last_place_or_not_at_all) {
  EXPECT_FALSE(checker::exactly::area_exceeds({0, 0}, {1, 0}, {0, 1}, 0.5));
  EXPECT_TRUE(checker::exactly::area_exceeds({0, 0}, {1, 0}, {0, 1}, down(0.5)));
}

TEST(Length, exceeds_its_bound_by_a_unit_in_the_last_place_or_not_at_all) {
  EXPECT_FALSE(checker::exactly::length_exceeds({0, 0}, {3, 4}, 5));
  EXPECT_TRUE(checker::exactly::length_exceeds({0, 0}, {3, 4}, down(5)));
  EXPECT_EQ(checker::exactly::compare_lengths({0, 0}, {3, 4}, {1, 1}, {6, 1}), 0);
  EXPECT_EQ(checker::exactly::compare_lengths({0, 0}, {3, up(4)}, {1, 1}, {6, 1}), 1);
}

TEST(Circumradius, of_a_right_triangle_is_half_its_hypotenuse) {
  EXPECT_FALSE(checker::exactly::circumradius_exceeds({0, 0}, {3, 0}, {0, 4}, 2.5));
  EXPECT_TRUE(checker::exactly::circumradius_exceeds({0, 0}, {3, 0}, {0, 4}, down(2.5)));
}

TEST(Lengths, that_are_equal_are_equal_also_where_doubles_do_not_show_it) {
  const Point a{0.1, 0.2}, b{0.4, 0.7};
  EXPECT_EQ(checker::exactly::compare_lengths(a, b, b, a), 0);
  EXPECT_EQ(checker::exactly::compare_lengths(a, b, a, {0.4, up(0.7)}), -1);
  EXPECT_EQ(checker::exactly::compare_lengths(a, {0.4, up(0.7)}, a, b), 1);
}

TEST(LineOffset, is_exact) {
  // The line through (0, 0) and (4, 3) passes (-3, 4) at (-3 - x, 4 - y) with 3 x + 4 y = 25.
  using checker::exactly::line_offset_exceeds;
  EXPECT_FALSE(line_offset_exceeds({-3, 4}, {0, 0}, {4, 3}, {3, 4}));
  EXPECT_TRUE(line_offset_exceeds({-3, 4}, {0, 0}, {4, 3}, {down(3), 4}));
  EXPECT_TRUE(line_offset_exceeds({-3, 4}, {0, 0}, {4, 3}, {3, down(4)}));
  EXPECT_FALSE(line_offset_exceeds({3, -4}, {4, 3}, {0, 0}, {3, 4}));
}

TEST(LineOffset, of_a_line_along_an_axis_counts_the_other_axis_only) {
  using checker::exactly::line_offset_exceeds;
  EXPECT_FALSE(line_offset_exceeds({7, 2}, {0, 0}, {4, 0}, {0, 2}));
  EXPECT_TRUE(line_offset_exceeds({7, 2}, {0, 0}, {4, 0}, {1000, down(2)}));
}

TEST(TangentAcrossShell, is_that_of_the_angle_at_twice_the_distance) {
  using checker::exactly::tangent_across_shell;
  EXPECT_DOUBLE_EQ(tangent_across_shell({0, 0}, {1, 0}, {3, 4}), 0.8 / (2 - 0.6));
  EXPECT_DOUBLE_EQ(tangent_across_shell({0, 0}, {3, 4}, {1, 0}), 0.8 / (2 - 0.6));
  EXPECT_DOUBLE_EQ(tangent_across_shell({0x1p40, 0}, {0x1p40 + 1, 0}, {0x1p40 + 1, 0x1p-60}), 0x1p-60);
}

TEST(TangentIsBelow, is_exact) {
  using checker::exactly::tangent_is_below;
  EXPECT_FALSE(tangent_is_below({0, 0}, {4, 0}, {4, 3}, 0.75, 0));
  EXPECT_TRUE(tangent_is_below({0, 0}, {4, 0}, {4, 3}, std::nextafter(0.75, 1), 0));
  // 12 + error * (4 + 7) < 16 bound
  EXPECT_FALSE(tangent_is_below({0, 0}, {4, 0}, {4, 3}, 1.4375, 1));
  EXPECT_TRUE(tangent_is_below({0, 0}, {4, 0}, {4, 3}, std::nextafter(1.4375, 2), 1));
}

TEST(UnitAt, is_the_distance_to_the_next_larger_double_except_at_zero) {
  EXPECT_EQ(checker::unit_at(1.0), 0x1p-52);
  EXPECT_EQ(checker::unit_at(-1.5), 0x1p-52);
  EXPECT_EQ(checker::unit_at(down(1)), 0x1p-53);
  EXPECT_EQ(checker::unit_at(0x1p-138), 0x1p-190);
  EXPECT_EQ(checker::unit_at(0.0), 0);
  EXPECT_EQ(checker::unit_at(std::numeric_limits<double>::max()), 0x1p971);
  EXPECT_EQ(checker::unit_at(Point{1, -4}, Point{0.5, 3}), 0x1p-50);
}

TEST(UnitsOfASegment, come_from_its_own_ends_for_each_axis) {
  const auto [x, y] = checker::units_of_segment({1, -0x1p30}, {-2, 0});
  EXPECT_EQ(x, 0x1p-51);
  EXPECT_EQ(y, 0x1p-22);
}

TEST(Witnesses, are_fractions_where_these_are_short) {
  EXPECT_EQ(checker::exactly::orientation_text({0, 0}, {1, 0}, {0, 0.125}), "1/8");
  EXPECT_EQ(checker::exactly::squared_circumradius_text({0, 0}, {3, 0}, {0, 4}), "25/4");
  EXPECT_EQ(checker::exactly::squared_cosine_text({0, 0}, {1, 1}, {1, 0}), "1/2");
  EXPECT_EQ(checker::exactly::in_circle_text({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), "1/2");
}

TEST(Witnesses, are_rounded_where_a_fraction_has_more_than_40_characters) {
  const auto doubled_area = [](double x, double y) {
    return checker::exactly::orientation_text({0, 0}, {x, 0}, {0, y});
  };
  EXPECT_EQ(doubled_area(1e20, 1e19), "1" + std::string(39, '0'));
  EXPECT_EQ(doubled_area(0x1p67, 0x1p67), "2.1778071482940062e+40 (rounded)");
  EXPECT_EQ(doubled_area(-0x1p67, 0x1p67), "-2.1778071482940062e+40 (rounded)");
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(doubled_area(tiny, tiny), "a positive number below the least double");
  EXPECT_EQ(doubled_area(-tiny, tiny), "a negative number above the greatest");
}

TEST(Witnesses, without_a_value_say_so) {
  EXPECT_EQ(checker::exactly::squared_cosine_text({1, 1}, {1, 1}, {2, 3}), "undefined");
  EXPECT_EQ(checker::exactly::squared_circumradius_text({0, 0}, {1, 1}, {2, 2}), "infinite");
  EXPECT_EQ(checker::exactly::squared_line_distance_text({0, 1}, {2, 2}, {2, 2}), "undefined");
  EXPECT_EQ(checker::exactly::squared_line_distance_text({0, 1}, {0, 0}, {1, 1}), "1/2");
}

TEST(ExactSum, of_numbers_below_the_least_normal_double_is_exact) {
  const double least_normal = std::numeric_limits<double>::min(), tiny = std::numeric_limits<double>::denorm_min();
  ExactSum sum;
  sum.add_product(least_normal / 2, 2);
  EXPECT_EQ(sum.rounded(), least_normal);
  sum.subtract_product(least_normal - tiny, 1);
  sum.add_product(0, 7);
  sum.add_product(2, tiny);
  EXPECT_EQ(sum.rounded(), 3 * tiny);
  sum.subtract_product(4, tiny);
  EXPECT_EQ(sum.rounded(), -tiny);
}

TEST(ExactSum, holds_products_of_the_smallest_and_the_largest_doubles_together) {
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  ExactSum sum;
  for (int i = 0; i < 1000; ++i) sum.add_product(huge, huge);
  sum.subtract_product(tiny, tiny);
  for (int i = 0; i < 1000; ++i) sum.subtract_product(huge, huge);
  EXPECT_EQ(sum.sign(), -1);
  sum.add_product(tiny, tiny);
  EXPECT_EQ(sum.sign(), 0);
}

TEST(ExactSum, loses_no_product_of_the_smallest_doubles_when_another_sum_is_added_or_subtracted) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  ExactSum one, two;
  one.add_product(tiny, tiny);
  two.add_product(tiny, 2 * tiny);
  ExactSum sum = one;
  sum -= two;
  EXPECT_EQ(sum.sign(), -1);
  sum += one;
  EXPECT_EQ(sum.sign(), 0);
}

TEST(ExactSum, of_partial_sums_is_the_whole_sum) {
  ExactSum whole, part;
  for (int i = 1; i <= 100; ++i) {
    whole.add_cross({0.1 * i, 0.7}, {0.3, 1.1 * i});
    (i % 3 == 0 ? part : whole).add_cross({i / 7.0, 2}, {3, i / 9.0});
  }
  ExactSum sum = whole;
  sum += part;
  sum -= whole;
  sum -= part;
  EXPECT_EQ(sum.sign(), 0);
}

}  // namespace
}  // namespace pardel::checker
