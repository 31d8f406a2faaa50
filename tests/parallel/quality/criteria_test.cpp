#include "../../../parallel/quality/criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "../samples.hpp"
#include "exact_bounds.hpp"

namespace pardel::engine {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

Shape moved(const Shape& s, Point by) {
  return {{s.p[0].x + by.x, s.p[0].y + by.y}, {s.p[1].x + by.x, s.p[1].y + by.y}, {s.p[2].x + by.x, s.p[2].y + by.y}};
}

/// An isosceles triangle with the given angle at the top.
Shape isosceles(double degrees, double height) {
  const double half = height * std::tan(radians(degrees / 2));
  return {{-half, 0}, {half, 0}, {0, height}};
}

TEST(BadShape, is_every_triangle_that_an_exact_comparison_rejects) {
  for (const double bound : {5.0, 20.7, 25.0, 30.0, 33.0}) {
    const Criteria criteria({.min_angle_deg = bound}, Placement::circumcentre, {});
    for (int i = -2000; i <= 2000; ++i)
      for (const double height : {1.0, 1e-9, 3e7}) {
        const Shape s = isosceles(bound * (1 + i * 0x1p-52), height);
        EXPECT_TRUE(criteria.bad_shape(s) || !sharper_than(s, bound)) << bound << ' ' << i;
      }
  }
}

TEST(BadShape, is_no_triangle_that_is_slightly_better_than_the_bound) {
  for (const double bound : {5.0, 20.7, 25.0, 30.0, 33.0}) {
    const Criteria criteria({.min_angle_deg = bound}, Placement::circumcentre, {});
    EXPECT_FALSE(criteria.bad_shape(isosceles(bound * (1 + 0x1p-36), 1)));
    EXPECT_TRUE(criteria.bad_shape(isosceles(bound * (1 - 0x1p-36), 1)));
  }
}

TEST(BadShape, is_decided_safely_far_from_the_origin_too) {
  samples::Random random(1);
  const Criteria criteria({.min_angle_deg = 20.7}, Placement::circumcentre, {});
  for (int i = 0; i < 20'000; ++i) {
    const Shape s = moved(isosceles(20.7 * (1 + random.uniform(-1e-9, 1e-9)), 1), {654321, 4987654});
    EXPECT_TRUE(criteria.bad_shape(s) || !sharper_than(s, 20.7));
  }
}

TEST(BadShape, is_none_without_a_bound) {
  const Criteria criteria({.min_angle_deg = 0}, Placement::circumcentre, {});
  EXPECT_FALSE(criteria.bad_shape(Shape({0, 0}, {1, 0}, {0.5, 1e-300})));
}

TEST(TooLarge, is_every_triangle_above_a_cap_and_no_other) {
  for (const double cap : {0.1, 1.0, 3e-7}) {
    const Criteria criteria({.max_area = cap}, Placement::circumcentre, {});
    for (int i = -3; i <= 3; ++i) {
      const double leg = std::sqrt(2 * cap) * (1 + i * 0x1p-52);
      const Shape s({0, 0}, {leg, 0}, {0, leg});
      EXPECT_TRUE(criteria.too_large(s) || !larger_than(s, cap));
    }
    const double less = std::sqrt(2 * cap) * (1 - 0x1p-39);
    EXPECT_FALSE(criteria.too_large(Shape({0, 0}, {less, 0}, {0, less})));
  }
}

/// The bounds are stricter by a relative 2^-40. Of these numbers, doubles represent the stricter bound exactly.
TEST(TooLarge, is_nothing_that_is_as_large_as_the_stricter_bound) {
  const Criteria criteria({.max_area = 0x1p40, .max_edge = 0x1p20}, Placement::circumcentre, {});
  const double twice_area = 0x1p41 - 2, square = 0x1p40 - 1;
  EXPECT_FALSE(criteria.too_large(Measure{{1, 1, 1}, twice_area}));
  EXPECT_TRUE(criteria.too_large(Measure{{1, 1, 1}, std::nextafter(twice_area, 0x1p50)}));
  LocalHints none;
  const auto too_long = [&](double squared) {
    return criteria.too_large_locally({{1, squared, 1}, 1}, {0, 0}, {1, 0}, {0, 1}, no_index, none);
  };
  EXPECT_FALSE(too_long(square));
  EXPECT_TRUE(too_long(std::nextafter(square, 0x1p50)));
}

TEST(TooLarge, depends_on_the_place_where_the_goal_does) {
  Goal goal{.max_edge = 2, .region_caps = true};
  goal.size = [](Point p) { return p.x < 0 ? 0.5 : 10.0; };
  const Criteria criteria(goal, Placement::circumcentre, {0.25, 100.0}, [](Point p) { return p.y > 50 ? 0.01 : 1e9; });
  ASSERT_TRUE(criteria.has_local_size());
  const Shape small({0, 0}, {0.9, 0}, {0, 0.8}), large({0, 0}, {1.9, 0}, {0, 1.9}), longer({0, 0}, {2.1, 0}, {0, 0.1});
  EXPECT_FALSE(criteria.too_large_locally(small, no_index));
  EXPECT_TRUE(criteria.too_large_locally(small, 0)) << "region 0 has a cap of 0.25";
  EXPECT_FALSE(criteria.too_large_locally(small, 1));
  EXPECT_FALSE(criteria.too_large_locally(small, 7)) << "no such region, no cap";
  EXPECT_TRUE(criteria.too_large_locally(large, no_index)) << "its hypotenuse is longer than 2";
  EXPECT_TRUE(criteria.too_large_locally(longer, no_index));
  EXPECT_TRUE(criteria.too_large_locally(moved(small, {-5, 0}), no_index)) << "the size there is 0.5";
  EXPECT_TRUE(criteria.too_large_locally(moved(small, {0, 60}), no_index)) << "the cap there is 0.01";

  goal.region_caps = false;
  EXPECT_FALSE(Criteria(goal, Placement::circumcentre, {0.25}).too_large_locally(small, 0));
}

bool encroaches(const Criteria& criteria, Point p, Point a, Point b) {
  const Shape s(p, a, b);
  return criteria.encroaches(s.dot_at(0), s.squared[1], s.squared[2]);
}

TEST(Encroachment, of_a_conforming_goal_is_the_closed_diametral_disk) {
  const Criteria criteria({.conforming = true}, Placement::circumcentre, {});
  EXPECT_TRUE(criteria.conforming());
  EXPECT_TRUE(encroaches(criteria, {0, 1}, {-1, 0}, {1, 0}));
  EXPECT_TRUE(encroaches(criteria, {3, 4}, {-5, 0}, {5, 0}));
  EXPECT_TRUE(encroaches(criteria, {0.3, -0.2}, {-1, 0}, {1, 0}));
  EXPECT_FALSE(encroaches(criteria, {0, 1.0001}, {-1, 0}, {1, 0}));
  EXPECT_FALSE(encroaches(criteria, {1.0001, 0}, {-1, 0}, {1, 0}));
}

/// From every point of the arcs that bound the lens, the segment is seen at 180 degrees minus twice the angle bound.
TEST(Encroachment, of_a_constrained_goal_is_the_diametral_lens) {
  for (const double bound : {20.7, 30.0, 33.0}) {
    const Criteria criteria({.min_angle_deg = bound}, Placement::circumcentre, {});
    EXPECT_FALSE(criteria.conforming());
    const double tip = std::tan(radians(bound));
    EXPECT_TRUE(encroaches(criteria, {0, 0.999 * tip}, {-1, 0}, {1, 0})) << bound;
    EXPECT_FALSE(encroaches(criteria, {0, 1.001 * tip}, {-1, 0}, {1, 0})) << bound;
  }
  const Criteria low({.min_angle_deg = 5}, Placement::circumcentre, {});
  EXPECT_TRUE(encroaches(low, {0, 0.37}, {-1, 0}, {1, 0})) << "the lens is never thinner than with the proven bound";
}

/// A point so close to the middle of the segment that it encroaches for every goal with a bound.
bool encroaches_from_nearby(const Criteria& criteria) { return encroaches(criteria, {0, 0x1p-100}, {-1, 0}, {1, 0}); }

TEST(Encroachment, needs_a_goal_with_a_bound) {
  const Placement off = Placement::off_centre;
  const std::vector<double> no_caps{INFINITY, INFINITY}, one_cap{INFINITY, 1.0};
  for (const bool conforming : {false, true}) {
    const Goal none{.min_angle_deg = 0, .region_caps = true, .conforming = conforming};
    EXPECT_FALSE(encroaches_from_nearby(Criteria(none, off, {})));
    EXPECT_FALSE(encroaches_from_nearby(Criteria(none, off, no_caps)));
    EXPECT_TRUE(encroaches_from_nearby(Criteria(none, off, one_cap))) << "one region has a cap";
    EXPECT_TRUE(encroaches_from_nearby(Criteria(none, off, {}, [](Point) { return 1.0; }))) << "a cap by place";
    EXPECT_EQ(Criteria(none, off, no_caps).conforming(), conforming);

    const auto with = [&](auto Goal::*bound, auto value) {
      Goal goal = none;
      goal.*bound = value;
      return encroaches_from_nearby(Criteria(goal, off, one_cap));
    };
    EXPECT_FALSE(with(&Goal::region_caps, false));
    EXPECT_TRUE(with(&Goal::min_angle_deg, 0.001));
    EXPECT_TRUE(with(&Goal::max_area, 1e9));
    EXPECT_TRUE(with(&Goal::max_edge, 1e9));
    EXPECT_TRUE(with(&Goal::size, [](Point) { return 1e9; }));
  }
}

TEST(SplitPoint, is_the_circumcentre) {
  const Criteria criteria({}, Placement::circumcentre, {});
  EXPECT_EQ(criteria.split_point(Shape({0, 0}, {4, 0}, {0, 2}), no_index), (Point{2, 1}));
  samples::Random random(3);
  for (int i = 0; i < 1000; ++i) {
    std::array<Point, 3> p{};
    for (Point& q : p) q = {random.uniform(-1, 1), random.uniform(-1, 1)};
    const double turn = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (std::abs(turn) < 0.01) continue;
    if (turn < 0) std::swap(p[1], p[2]);
    const Point c = criteria.split_point(Shape(p[0], p[1], p[2]), no_index);
    const double r = std::hypot(c.x - p[0].x, c.y - p[0].y);
    for (const Point q : p) EXPECT_NEAR(std::hypot(c.x - q.x, c.y - q.y), r, 1e-9 * (1 + r * r));
  }
}

/// The off-centre and the shortest side make a triangle that just meets the bound. It never lies beyond the
/// circumcentre.
TEST(SplitPoint, of_an_off_centre_makes_a_triangle_that_just_meets_the_angle_bound) {
  for (const double bound : {0.5, 10.0, 20.7, 30.0, 33.0}) {
    const Criteria off({.min_angle_deg = bound}, Placement::off_centre, {});
    const Criteria centre({.min_angle_deg = bound}, Placement::circumcentre, {});
    for (double top = 0.1; top < bound; top *= 1.3) {
      const Shape s = isosceles(top, 1);
      const Point p = off.split_point(s, no_index), c = centre.split_point(s, no_index);
      const Shape made(s.p[0], s.p[1], p);
      EXPECT_FALSE(sharper_than(made, bound)) << bound << ' ' << top;
      EXPECT_LE(p.y, c.y);
      EXPECT_TRUE(p.y == c.y || sharper_than(made, bound * 1.01))
          << "it is no nearer to the side than the bound demands";
    }
    const Shape needle = isosceles(0.1, 1), fat = isosceles(50, 1);
    EXPECT_LT(off.split_point(needle, no_index).y, centre.split_point(needle, no_index).y);
    EXPECT_EQ(off.split_point(fat, no_index), centre.split_point(fat, no_index)) << "a triangle that is only too large";
  }
}

/// A triangle whose shortest side has length 1. The others have length 2.3, the area is 1.13.
Shape tall() { return isosceles(25, 0.5 / std::tan(radians(12.5))); }
/// The triangle of the shortest side and the split point. The shortest side joins the first two corners.
Shape made_of_the_shortest_side(const Criteria& criteria, const Shape& s, Index region) {
  return {s.p[0], s.p[1], criteria.split_point(s, region)};
}

TEST(SplitPoint, of_a_triangle_that_is_too_large_makes_one_that_fills_the_bound_on_areas) {
  const Shape s = tall();
  for (const double cap : {0.3, 0.4, 0.5}) {
    const auto at_most = [&](Point) { return cap; };
    const std::vector<std::pair<Criteria, Index>> places{
        {{{.max_area = cap}, Placement::off_centre, {}}, no_index},
        {{{.region_caps = true}, Placement::off_centre, {9.0, cap}}, 1},
        {{{}, Placement::off_centre, {}, at_most}, no_index}};
    for (const auto& [criteria, region] : places) {
      const double area = made_of_the_shortest_side(criteria, s, region).twice_area / 2;
      EXPECT_LT(area, cap);
      EXPECT_GT(area, 0.98 * cap);
    }
  }
}

TEST(SplitPoint, of_a_triangle_that_is_too_large_makes_one_that_fills_the_bound_on_lengths) {
  const Shape s = tall();
  for (const double longest : {1.15, 1.0, 0.8}) {
    const auto at_most = [&](Point) { return longest; };
    for (const Criteria& criteria : {Criteria({.max_edge = longest}, Placement::off_centre, {}),
                                     Criteria({.size = at_most}, Placement::off_centre, {})}) {
      const Shape made = made_of_the_shortest_side(criteria, s, no_index);
      EXPECT_LT(made.squared[0], longest * longest);
      EXPECT_GT(made.squared[0], 0.98 * longest * longest);
    }
  }
}

/// The split point lies on the diametral circle of the side, even where it makes a triangle that is too large.
TEST(SplitPoint, of_a_triangle_that_is_too_large_lies_no_lower_than_the_diametral_circle) {
  const Criteria criteria({.max_area = 0.2}, Placement::off_centre, {});
  const Point p = criteria.split_point(tall(), no_index);
  EXPECT_NEAR(p.x, 0, 1e-15);
  EXPECT_NEAR(p.y, 0.5, 1e-15);
}

TEST(SplitPoint, of_a_triangle_that_is_much_too_large_is_the_circumcentre) {
  const Criteria off({.max_area = 0.15}, Placement::off_centre, {});
  const Criteria centre({.max_area = 0.15}, Placement::circumcentre, {});
  const Shape s = tall();
  EXPECT_EQ(off.split_point(s, no_index), centre.split_point(s, no_index));
}

/// The bound on areas is stricter by a relative 2^-40. Doubles represent six times the stricter bound exactly.
TEST(SplitPoint, of_a_triangle_is_the_circumcentre_if_its_area_is_more_than_six_times_the_bound) {
  const Goal goal{.min_angle_deg = 0, .max_area = 1};
  const Criteria off(goal, Placement::off_centre, {}), centre(goal, Placement::circumcentre, {});
  const double height = 12 - 12 * 0x1p-40;
  const auto point = [](const Criteria& criteria, double h) {
    return criteria.split_point(Shape({-0.5, 0}, {0.5, 0}, {0, h}), no_index);
  };
  EXPECT_NEAR(point(off, height).y, 1.98, 1e-9) << "fills 99 % of the bound";
  const double higher = std::nextafter(height, 13);
  EXPECT_EQ(point(off, higher), point(centre, higher));
}

/// Needles towards a source of lengths, and away from it: there the length at the centroid differs from that at the
/// corner as much as it can. Far from the origin, rounding errors are larger, so the corner decides less.
TEST(SizeAround, a_corner_changes_no_answer_in_a_domain_where_lengths_are_rounded_much) {
  constexpr double slope = 0.5, extent = 0x1p41;
  const std::vector<GrowingSize> sources{{{{0, 0}, {0, 0}, 1, 1}, slope}};
  auto grown = std::make_shared<const GradedValues>(
      GradedValues{{}, SizeEnvelope(sources, Box{-extent / 2, -extent / 2, extent / 2, extent / 2})});
  const Criteria criteria({.min_angle_deg = 0, .size = OnBackground<GradedValues>{std::move(grown)}},
                          Placement::circumcentre, {});
  const Point p{10, 0};
  LocalHints hints;
  criteria.look_around(p, hints);
  ASSERT_EQ(hints.around.corner, p);
  const auto check = [&](double towards, double length) {
    const Shape needle(p, {p.x + towards, -towards * 0x1p-20}, {p.x + towards, towards * 0x1p-20});
    const bool large = criteria.too_large_locally(needle, no_index);
    EXPECT_EQ(criteria.too_large_locally(needle, needle.p[0], needle.p[1], needle.p[2], no_index, hints), large)
        << length;
    EXPECT_EQ(large, std::abs(towards) > length);
  };
  for (int i = -400; i < 400; ++i) {
    const double change = i * 0x1p-10 + 0x1p-11;
    check(-4.5 - change, 4.5);  // of 6 at the corner, 4.5 / 3 are lost on the way to the centroid
    check(9 + change, 9);       // and 9 / 3 are gained
  }
}

/// Filled areas would make these meshes larger.
TEST(SplitPoint, above_thirty_one_degrees_fills_lengths_but_no_areas) {
  const Shape s = tall();
  const auto point = [&](double bound, double area, double length) {
    const Goal goal{.min_angle_deg = bound, .max_area = area, .max_edge = length};
    return Criteria(goal, Placement::off_centre, {}).split_point(s, no_index);
  };
  EXPECT_EQ(point(32, 0.4, INFINITY), point(32, INFINITY, INFINITY));
  EXPECT_NE(point(31, 0.4, INFINITY), point(31, INFINITY, INFINITY));
  EXPECT_NE(point(32, INFINITY, 0.9), point(32, INFINITY, INFINITY));
}

TEST(TrianglesWanted, are_more_for_bounds_on_angles_above_twenty_degrees) {
  const auto wanted = [](double angle) {
    LocalHints none;
    const Criteria criteria({.min_angle_deg = angle, .max_area = 0.5}, Placement::off_centre, {});
    return criteria.triangles_wanted(Shape({0, 0}, {1, 0}, {0, 71}), no_index, none);
  };
  EXPECT_NEAR(wanted(20), 100, 1e-9) << "the average triangle has 0.71 times the largest area";
  EXPECT_EQ(wanted(0), wanted(20));
  EXPECT_NEAR(wanted(20.5), 100 * 0.71 / 0.7075, 1e-9);
}

}  // namespace
}  // namespace pardel::engine
