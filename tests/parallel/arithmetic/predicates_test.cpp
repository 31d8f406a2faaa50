// The statements of predicates.hpp about the predicates, one test per statement.
#include "../../../parallel/arithmetic/predicates.hpp"

#include <limits>

#include "../../../properties/theorems/framework/property.hpp"
#include "predicate_inputs.hpp"

namespace pardel::engine {
namespace {

using testing::Four;
using testing::hard_points;
using testing::sign;

PARDEL_PROPERTY(Orient2d, has_the_sign_that_rational_arithmetic_gives,
                {.statement = "the sign of orient2d is that of the determinant in rational arithmetic, by the filtered "
                              "and by the exact path",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, unused] = *hard_points();
  RC_ASSERT(sign(orient2d(a, b, c)) == testing::true_orientation(a, b, c));
  RC_ASSERT(sign(exact::orient2d(a, b, c)) == testing::true_orientation(a, b, c));
}

PARDEL_PROPERTY(Orient2d, flips_its_sign_when_two_points_are_swapped,
                {.statement = "swapping two points flips the sign of orient2d",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, unused] = *hard_points();
  const int s = sign(orient2d(a, b, c));
  RC_ASSERT(sign(orient2d(b, a, c)) == -s);
  RC_ASSERT(sign(orient2d(a, c, b)) == -s);
  RC_ASSERT(sign(orient2d(c, b, a)) == -s);
}

PARDEL_PROPERTY(Orient2d, is_the_same_from_every_corner,
                {.statement = "rotating the three points keeps the sign of orient2d",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, unused] = *hard_points();
  RC_ASSERT(sign(orient2d(a, b, c)) == sign(orient2d(b, c, a)));
  RC_ASSERT(sign(orient2d(a, b, c)) == sign(orient2d(c, a, b)));
}

PARDEL_PROPERTY(Orient2d, is_zero_for_points_on_a_line,
                {.statement = "orient2d of three points on a line is exactly zero",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = "collinear points"}) {
  const auto [a, b, c, unused] = *testing::on_a_line();
  RC_ASSERT(orient2d(a, b, c) == 0);
}

PARDEL_PROPERTY(Orient2d, is_zero_when_two_points_are_equal,
                {.statement = "orient2d is exactly zero when two of its points are equal",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, unused] = *hard_points();
  RC_ASSERT(orient2d(a, a, b) == 0);
  RC_ASSERT(orient2d(a, b, a) == 0);
  RC_ASSERT(orient2d(b, a, a) == 0);
}

TEST(Orient2d, distinguishes_collinear_points_from_points_one_rounding_away) {
  const Point a{0.1, 0.1}, b{0.3, 0.3}, on{0.7, 0.7};
  EXPECT_EQ(orient2d(a, b, on), 0);
  EXPECT_GT(orient2d(a, b, {0.7, std::nextafter(0.7, 1.0)}), 0);
  EXPECT_LT(orient2d(a, b, {0.7, std::nextafter(0.7, 0.0)}), 0);
}

TEST(Orient2d, is_positive_for_a_left_turn_and_about_twice_the_area) {
  EXPECT_DOUBLE_EQ(orient2d({0, 0}, {3, 0}, {0, 2}), 6);
  EXPECT_DOUBLE_EQ(exact::orient2d({0, 0}, {3, 0}, {0, 2}), 6);
  EXPECT_DOUBLE_EQ(orient2d({0, 0}, {0, 2}, {3, 0}), -6);
}

PARDEL_PROPERTY(Orient2d, does_not_change_when_everything_is_scaled_by_a_power_of_two,
                {.statement = "scaling by a power of two keeps the sign of orient2d",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = "uniform points"}) {
  const auto [a, b, c, unused] = *testing::uniform();
  const int exponent = *rc::gen::inRange(-80, 190);
  const auto scaled_up = [&](Point p) { return Point{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; };
  RC_ASSERT(sign(orient2d(scaled_up(a), scaled_up(b), scaled_up(c))) == sign(orient2d(a, b, c)));
}

PARDEL_PROPERTY(Orient2d, does_not_change_when_a_lattice_is_moved,
                {.statement = "moving lattice points by a lattice vector keeps the value of orient2d",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = "a small lattice"}) {
  const auto [a, b, c, unused] = *testing::small_lattice();
  const double dx = *testing::multiple_of(1024, 1 << 30);
  const double dy = *testing::multiple_of(1024, 1 << 30);
  const auto moved = [&](Point p) { return Point{p.x + dx, p.y + dy}; };
  RC_ASSERT(orient2d(moved(a), moved(b), moved(c)) == orient2d(a, b, c));
}

PARDEL_PROPERTY(Incircle, has_the_sign_that_rational_arithmetic_gives,
                {.statement = "the sign of incircle is that of the determinant in rational arithmetic, by the filtered "
                              "and by the exact path",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, d] = *hard_points();
  RC_ASSERT(sign(incircle(a, b, c, d)) == testing::true_incircle(a, b, c, d));
  RC_ASSERT(sign(exact::incircle(a, b, c, d)) == testing::true_incircle(a, b, c, d));
}

PARDEL_PROPERTY(Incircle, flips_its_sign_when_two_points_are_swapped,
                {.statement = "swapping any two points flips the sign of incircle",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, d] = *hard_points();
  const int s = sign(incircle(a, b, c, d));
  RC_ASSERT(sign(incircle(b, a, c, d)) == -s);
  RC_ASSERT(sign(incircle(a, c, b, d)) == -s);
  RC_ASSERT(sign(incircle(c, b, a, d)) == -s);
  RC_ASSERT(sign(incircle(d, b, c, a)) == -s);
  RC_ASSERT(sign(incircle(a, d, c, b)) == -s);
  RC_ASSERT(sign(incircle(a, b, d, c)) == -s);
}

PARDEL_PROPERTY(Incircle, is_the_same_from_every_corner,
                {.statement = "rotating the first three points keeps the sign of incircle",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, d] = *hard_points();
  RC_ASSERT(sign(incircle(a, b, c, d)) == sign(incircle(b, c, a, d)));
  RC_ASSERT(sign(incircle(a, b, c, d)) == sign(incircle(c, a, b, d)));
}

PARDEL_PROPERTY(Incircle, is_zero_for_the_corners_of_a_rectangle,
                {.statement = "incircle of the four corners of a rectangle is exactly zero",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = "rectangles"}) {
  const auto [a, b, c, d] = *testing::rectangle();
  RC_ASSERT(incircle(a, b, c, d) == 0);
}

PARDEL_PROPERTY(
    Incircle, is_zero_for_points_on_a_line,
    {.statement = "incircle of four points on a line is exactly zero: a line is the circle through its points",
     .source = "parallel/arithmetic/predicates.hpp",
     .families = "collinear points"}) {
  const auto [a, b, c, d] = *testing::on_a_line();
  RC_ASSERT(incircle(a, b, c, d) == 0);
}

PARDEL_PROPERTY(Incircle, is_zero_when_two_points_are_equal,
                {.statement = "incircle is exactly zero when two of its points are equal",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = testing::hard_families}) {
  const auto [a, b, c, d] = *hard_points();
  RC_ASSERT(incircle(a, b, c, a) == 0);
  RC_ASSERT(incircle(a, b, c, b) == 0);
  RC_ASSERT(incircle(a, b, c, c) == 0);
  RC_ASSERT(incircle(a, a, c, d) == 0);
}

TEST(Incircle, distinguishes_cocircular_points_from_points_one_rounding_away) {
  const Point a{0.1, 0.2}, b{0.9, 0.2}, c{0.9, 0.7}, d{0.1, 0.7};
  EXPECT_EQ(incircle(a, b, c, d), 0);
  EXPECT_GT(incircle(a, b, c, {std::nextafter(0.1, 1.0), 0.7}), 0);
  EXPECT_LT(incircle(a, b, c, {std::nextafter(0.1, 0.0), 0.7}), 0);
}

TEST(Incircle, is_positive_inside_and_negative_outside) {
  const Point a{0, 0}, b{2, 0}, c{0, 2};
  EXPECT_GT(incircle(a, b, c, {1, 1}), 0);
  EXPECT_GT(incircle(a, b, c, {1.9, 1.9}), 0);
  EXPECT_EQ(incircle(a, b, c, {2, 2}), 0);
  EXPECT_LT(incircle(a, b, c, {2.1, 2}), 0);
}

PARDEL_PROPERTY(Incircle, does_not_change_when_everything_is_scaled_by_a_power_of_two,
                {.statement = "scaling by a power of two keeps the sign of incircle",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = "uniform points"}) {
  const auto [a, b, c, d] = *testing::uniform();
  const int exponent = *rc::gen::inRange(-80, 190);
  const auto scaled_up = [&](Point p) { return Point{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; };
  RC_ASSERT(sign(incircle(scaled_up(a), scaled_up(b), scaled_up(c), scaled_up(d))) == sign(incircle(a, b, c, d)));
}

PARDEL_PROPERTY(Incircle, does_not_change_when_a_lattice_is_moved,
                {.statement = "moving lattice points by a lattice vector keeps the value of incircle",
                 .source = "parallel/arithmetic/predicates.hpp",
                 .families = "a small lattice"}) {
  const auto [a, b, c, d] = *testing::small_lattice();
  const double dx = *testing::multiple_of(1024, 1 << 30);
  const double dy = *testing::multiple_of(1024, 1 << 30);
  const auto moved = [&](Point p) { return Point{p.x + dx, p.y + dy}; };
  RC_ASSERT(incircle(moved(a), moved(b), moved(c), moved(d)) == incircle(a, b, c, d));
}

TEST(Predicates, are_exact_at_both_ends_of_the_range) {
  const double tiny = smallest_coordinate, huge = largest_coordinate;
  EXPECT_GT(orient2d({0, 0}, {tiny, 0}, {0, tiny}), 0);
  EXPECT_LT(incircle({0, 0}, {tiny, 0}, {0, tiny}, {huge, huge}), 0);
  EXPECT_GT(incircle({0, -huge}, {huge, 0}, {0, huge}, {-std::nextafter(huge, 0.0), tiny}), 0);
  EXPECT_EQ(incircle({0, -huge}, {huge, 0}, {0, huge}, {-huge, 0}), 0);
  EXPECT_LT(incircle({0, -huge}, {huge, 0}, {0, huge}, {-huge, tiny}), 0);
  EXPECT_LT(incircle({0, 0}, {tiny, 0}, {0, tiny}, {tiny, std::nextafter(tiny, 1.0)}), 0);
}

TEST(Predicates, state_which_coordinates_are_in_their_range) {
  for (const double x : {0.0, -0.0, smallest_coordinate, -largest_coordinate, 1.5}) EXPECT_TRUE(is_usable(x)) << x;
  for (const double x : {smallest_coordinate / 2, 2 * largest_coordinate, 1e-300, -1e300,
                         std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(is_usable(x)) << x;
  EXPECT_TRUE(is_usable(Point{1.5, 0}));
  EXPECT_FALSE(is_usable(Point{1.5, 1e300})) << "both coordinates have to be in the range";
  EXPECT_FALSE(is_usable(Point{1e300, 1.5}));
  EXPECT_EQ(snapped(smallest_coordinate / 2), 0);
  EXPECT_EQ(snapped(-smallest_coordinate), -smallest_coordinate);
}

}  // namespace
}  // namespace pardel::engine
