// Tests every stage of the predicates with an input that no earlier stage can decide.
#include "../../../parallel/arithmetic/predicate_stages.hpp"

#include "../../../properties/theorems/framework/property.hpp"
#include "predicate_inputs.hpp"

namespace pardel::engine::exact {
namespace {

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
