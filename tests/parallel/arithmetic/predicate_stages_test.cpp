// Tests every stage of the predicates with an input that no earlier stage can decide.
#include "../../../parallel/arithmetic/predicate_stages.hpp"

#include <array>
#include <utility>

#include "../../../parallel/arithmetic/predicates.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "predicate_inputs.hpp"

namespace pardel::engine::exact {
namespace {

using engine::incircle;
using engine::orient2d;
using testing::sign;

// Neither 0.9 - 0.1 nor 0.7 - 0.2 is a double.
constexpr Point a{0.1, 0.2}, b{0.9, 0.2}, c{0.9, 0.7}, d{0.1, 0.7};

TEST(Orient2dStages, an_exact_determinant_decides_if_differences_are_exact) {
  const Decision on_the_line = decide_orient2d({0, 0}, {1e8, 1e8}, {3, 3});
  EXPECT_EQ(on_the_line.value, 0);
  EXPECT_EQ(on_the_line.stage, Stage::exact_differences);
}

TEST(Orient2dStages, rounded_differences_decide_clear_cases) {
  const Decision clear = decide_orient2d(a, b, c);
  EXPECT_GT(clear.value, 0);
  EXPECT_EQ(clear.stage, Stage::rounded_differences);
}

TEST(Orient2dStages, a_correction_decides_if_a_point_is_one_rounding_away) {
  const Point p{0.1, 0.1}, q{0.2, 0.2}, next_to_it{0.4, std::nextafter(0.4, 0.0)};
  const Decision close = decide_orient2d(p, q, next_to_it);
  EXPECT_LT(close.value, 0);
  EXPECT_EQ(close.stage, Stage::corrected);
}

PARDEL_FACT(Orient2dStages, expansions_settle_the_rest,
            {.statement = "orient2d is exact, by expansions, where rounded differences leave the sign open",
             .source = "parallel/arithmetic/predicate_stages.hpp",
             .families = "three points on a line whose differences are no doubles"}) {
  const Decision on_the_line = decide_orient2d({0.1, 0.1}, {0.9, 0.9}, {0.3, 0.3});
  EXPECT_EQ(on_the_line.value, 0);
  EXPECT_EQ(on_the_line.stage, Stage::expansions);
  facts.cases = 1;
}

/// Half a unit in the last place of numbers from 1 to 2, or a little less: added to such a number, it is rounded away.
constexpr double rounded_away = 0x1p-53 * (1 - 0x1p-10);
constexpr double ulp_of_one = 0x1p-52;

TEST(Orient2dStages, are_right_where_all_roundings_add_up) {
  // The point c lies between a and b, next to the origin. All four differences round to the coordinates of a and b, and
  // each of these errors turns the three points further in one direction. a and b turn around the origin in the other
  // direction, by an amount that is up to 63/64 of the sum of the errors, and more than half of it.
  for (const double scale : {1.0, 0x1p40, 0x1p-40})
    for (const double offset : {rounded_away, -rounded_away})
      for (int n = 1; n < 32; ++n) {
        const double far = 0x1p33 * ulp_of_one, near = n * 0x1p14 * ulp_of_one;
        const Point first{scale * (1 + ulp_of_one), scale * (1 + ulp_of_one + near)};
        const Point second{-scale * (1 + far - near + ulp_of_one), -scale * (1 + far)};
        const Point between{-scale * offset, scale * offset};
        for (const auto& [p, q] : {std::pair{first, second}, std::pair{second, first}}) {
          if (offset > 0) {
            ASSERT_EQ(testing::true_orientation(p, q, between), -testing::true_orientation(p, q, {0, 0}));
          }
          EXPECT_EQ(sign(decide_orient2d(p, q, between).value), testing::true_orientation(p, q, between)) << scale;
          EXPECT_EQ(sign(orient2d(p, q, between)), testing::true_orientation(p, q, between)) << scale;
        }
      }
}

/// x moved by `steps` doubles.
double beside(double x, int steps) {
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps > 0 ? 1.0 : -1.0);
  return x;
}

TEST(Orient2dStages, a_correction_decides_only_beyond_the_bound_of_Shewchuk) {
  // The bound is (9 e^2) M + (3 e) |D| plus terms of higher order, where e is 2^-53, D the determinant of the rounded
  // differences and M the sum of the magnitudes of its two products (Shewchuk 1997, ccwerrboundC and resulterrbound).
  // The points lie as above, but the errors nearly cancel D. `between` moves from one side of the line to the other.
  int corrections = 0, expansions = 0;
  const double far = 0x1p33 * ulp_of_one, near = 31 * 0x1p14 * ulp_of_one;
  const Point p{1 + ulp_of_one, 1 + ulp_of_one + near}, q{-(1 + far - near + ulp_of_one), -(1 + far)};
  const auto left = CGAL::Gmpq(p.x) * CGAL::Gmpq(q.y), right = CGAL::Gmpq(p.y) * CGAL::Gmpq(q.x);
  const CGAL::Gmpq e(0x1p-53),
      bound = 9 * e * e * (CGAL::abs(left) + CGAL::abs(right)) + 3 * e * CGAL::abs(left - right);
  const CGAL::Gmpq width = CGAL::Gmpq(p.x) - CGAL::Gmpq(q.x), height = CGAL::Gmpq(p.y) - CGAL::Gmpq(q.y);
  const double balanced = CGAL::to_double((left - right) / (width + height));
  for (int steps = -100; steps <= 100; ++steps) {
    const Point between{-balanced, beside(balanced, steps)};
    const Decision decision = decide_orient2d(p, q, between);
    EXPECT_EQ(sign(decision.value), testing::true_orientation(p, q, between)) << steps;
    if (decision.stage == Stage::expansions) ++expansions;
    if (decision.stage != Stage::corrected) continue;
    ++corrections;
    EXPECT_GT(CGAL::abs(CGAL::Gmpq(decision.value)), bound) << steps;
  }
  EXPECT_GT(corrections, 20);
  EXPECT_GT(expansions, 20);
}

PARDEL_FACT(IncircleStages, doubles_settle_a_small_lattice_wherever_it_lies,
            {.statement = "doubles settle the in-circle test if the differences are integers of at most 4096, wherever "
                          "the points lie; beyond 4096 they are not asked",
             .source = "parallel/arithmetic/predicate_stages.hpp",
             .families = "squares of three sizes at three places, quadrangles of 4096 and 4097 units"}) {
  for (const double x : {0.0, 1e9, -4987654.0})
    for (const double unit : {1.0, 0x1p-40, 0x1p40}) {
      const double left = unit * x, right = unit * (x + 1);
      const Decision square = decide_incircle({left, 0}, {right, 0}, {right, unit}, {left, unit});
      EXPECT_EQ(square.value, 0);
      EXPECT_EQ(square.stage, Stage::lattice);
      ++facts.cases;
    }
  EXPECT_EQ(decide_incircle({0, 0}, {4096, 0}, {4096, 4096}, {0, 4096}).stage, Stage::lattice);
  EXPECT_EQ(decide_incircle({0, 0}, {4096, 0}, {4097, 4096}, {0, 4096}).stage, Stage::exact_differences);
  facts.cases += 2;
}

PARDEL_PROPERTY(IncircleStages, up_to_4095_units_doubles_make_no_error_at_all,
                {.statement = "for differences of at most 4095 units, doubles give the in-circle determinant exactly",
                 .source = "parallel/arithmetic/predicate_stages.hpp",
                 .families = "lattice points"}) {
  const auto [p, q, r, unused] = *testing::four(testing::multiple_of(1, 4095), testing::multiple_of(1, 4095));
  const auto lift = [](Point u) { return CGAL::Gmpq(u.x) * CGAL::Gmpq(u.x) + CGAL::Gmpq(u.y) * CGAL::Gmpq(u.y); };
  const auto determinant = CGAL::determinant<CGAL::Gmpq>(p.x, p.y, lift(p), q.x, q.y, lift(q), r.x, r.y, lift(r));
  const Decision decision = decide_incircle(p, q, r, {0, 0});
  RC_ASSERT(decision.stage == Stage::lattice);
  RC_ASSERT(CGAL::Gmpq(decision.value) == determinant);
}

TEST(IncircleStages, an_exact_determinant_decides_if_differences_are_exact) {
  const Decision square = decide_incircle({0, 0}, {1e8, 0}, {1e8, 1e8}, {0, 1e8});
  EXPECT_EQ(square.value, 0);
  EXPECT_EQ(square.stage, Stage::exact_differences);
}

TEST(IncircleStages, rounded_differences_decide_clear_cases) {
  const Decision clear = decide_incircle(a, b, c, {0.3, 0.4});
  EXPECT_GT(clear.value, 0);
  EXPECT_EQ(clear.stage, Stage::rounded_differences);
}

TEST(IncircleStages, a_correction_decides_if_a_point_is_one_rounding_away) {
  const Point next_to_it{std::nextafter(0.1, 1.0), 0.7};
  const Decision close = decide_incircle(a, b, c, next_to_it);
  EXPECT_GT(close.value, 0);
  EXPECT_EQ(close.stage, Stage::corrected);
}

TEST(IncircleStages, expansions_settle_the_rest) {
  const Decision rectangle = decide_incircle(a, b, c, d);
  EXPECT_EQ(rectangle.value, 0);
  EXPECT_EQ(rectangle.stage, Stage::expansions);
}

TEST(IncircleStages, are_right_where_the_roundings_of_a_far_point_add_up) {
  // Three points nearly on a line through the fourth point d, which lies next to the origin. All differences round to
  // the coordinates themselves. The rounded points lie on one side of a circle, the points on the other: the error is
  // half of the bound. Nearly all of the bound belongs to one of its three terms, that of the far point.
  for (const double scale : {1.0, 0x1p20, 0x1p-20})
    for (const double offset : {rounded_away, -rounded_away}) {
      const Point near{scale * (1 + 2 * ulp_of_one), scale * (1 + ulp_of_one)};
      const Point opposite{-scale * (1 + ulp_of_one), -scale * (1 + ulp_of_one)};
      const Point far{scale * 1024, scale * 1024};
      const Point origin{scale * offset, -scale * offset};
      if (offset > 0) {
        ASSERT_EQ(testing::true_incircle(near, opposite, far, origin),
                  -testing::true_incircle(near, opposite, far, {0, 0}));
      }
      for (const auto& [p, q, r] :
           {std::array{near, opposite, far}, std::array{opposite, far, near}, std::array{far, near, opposite},
            std::array{far, opposite, near}, std::array{near, far, opposite}, std::array{opposite, near, far}}) {
        EXPECT_EQ(sign(decide_incircle(p, q, r, origin).value), testing::true_incircle(p, q, r, origin)) << scale;
        EXPECT_EQ(sign(incircle(p, q, r, origin)), testing::true_incircle(p, q, r, origin)) << scale;
      }
    }
}

TEST(IncircleStages, a_correction_decides_only_beyond_the_bound_of_Shewchuk) {
  // The bound is (44 e^2) M + (3 e) |D| plus terms of higher order, with e, D and M as for orient2d (Shewchuk 1997,
  // iccerrboundC). The points lie as above, but the errors nearly cancel D.
  int corrections = 0, expansions = 0;
  const Point p{1 + 2 * ulp_of_one, 1 + ulp_of_one}, q{-(1 + ulp_of_one), -(1 + ulp_of_one)}, r{1024, 1024};
  const auto times = [](double x, double y) { return CGAL::Gmpq(x) * CGAL::Gmpq(y); };
  CGAL::Gmpq determinant = 0, magnitude = 0;
  for (const auto& [u, v, w] : {std::array{p, q, r}, std::array{q, r, p}, std::array{r, p, q}}) {
    const CGAL::Gmpq square = times(u.x, u.x) + times(u.y, u.y);
    determinant += square * (times(v.x, w.y) - times(v.y, w.x));
    magnitude += square * (CGAL::abs(times(v.x, w.y)) + CGAL::abs(times(v.y, w.x)));
  }
  const CGAL::Gmpq e(0x1p-53), bound = 44 * e * e * magnitude + 3 * e * CGAL::abs(determinant);
  const double balanced = 0x1.0040100401003p-54;  // the determinant is nearly 0
  for (int steps = -400; steps <= 400; ++steps) {
    const Point origin{balanced, -beside(balanced, steps)};
    const Decision decision = decide_incircle(p, q, r, origin);
    EXPECT_EQ(sign(decision.value), testing::true_incircle(p, q, r, origin)) << steps;
    if (decision.stage == Stage::expansions) ++expansions;
    if (decision.stage != Stage::corrected) continue;
    ++corrections;
    EXPECT_GT(CGAL::abs(CGAL::Gmpq(decision.value)), bound) << steps;
  }
  EXPECT_GT(corrections, 20);
  EXPECT_GT(expansions, 20);
}

PARDEL_PROPERTY(
    Stages, exact_differences_are_told_from_rounded_ones,
    {.statement = "a stage for exact differences decides if and only if all coordinate differences are doubles",
     .source = "parallel/arithmetic/predicate_stages.hpp",
     .families = testing::hard_families}) {
  const auto [p, q, r, s] = *testing::hard_points();
  const auto is_exact = [](double x, double y) { return CGAL::Gmpq(x) - CGAL::Gmpq(y) == CGAL::Gmpq(x - y); };
  bool exact = true;
  for (const Point& u : {p, q, r}) exact &= is_exact(u.x, s.x) && is_exact(u.y, s.y);
  const Stage stage = decide_incircle(p, q, r, s).stage;
  RC_ASSERT(exact == (stage == Stage::lattice || stage == Stage::exact_differences));
}

PARDEL_PROPERTY(Stages, the_value_is_near_the_determinant,
                {.statement = "the value of orient2d is the determinant up to 1e-15 of it, on a lattice",
                 .source = "parallel/arithmetic/predicate_stages.hpp",
                 .families = "a large lattice"}) {
  // Differences on a lattice are exact, so the value differs from the determinant by rounding only.
  const auto [p, q, r, s] = *testing::large_lattice();
  const CGAL::Gmpq det =
      CGAL::determinant(testing::rational(q) - testing::rational(p), testing::rational(r) - testing::rational(p));
  const double value = decide_orient2d(p, q, r).value;
  RC_ASSERT(std::abs(value - CGAL::to_double(det)) <= 1e-15 * std::abs(value));
}

}  // namespace
}  // namespace pardel::engine::exact
