// The size function of a goal is the least of all its bounds that depend on the place.
#include "../../../parallel/sizing/graded_size.hpp"

#include <gtest/gtest.h>

#include "../../../parallel/sizing/local_bound.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

TEST(GradedSize, is_needed_for_a_limit_on_gradation_or_for_edges_across_narrow_places) {
  EXPECT_FALSE(is_graded({}));
  EXPECT_FALSE(is_graded({.size = [](Point) { return 1.0; }}));
  EXPECT_TRUE(is_graded({.grading = 2}));
  EXPECT_TRUE(is_graded({.feature_edges = 0.5}));
}

TEST(GradedSize, of_a_square_is_its_side_and_grows_inside) {
  const auto size = graded_size({.grading = 0.5}, testing::square(4), {});
  EXPECT_DOUBLE_EQ(size({0, 0}), 4);
  EXPECT_DOUBLE_EQ(size({2, 2}), 5);
}

TEST(GradedSize, grows_by_the_reciprocal_of_the_number_of_edges_or_by_the_limit_if_that_is_less) {
  const Pslg square = testing::square(4);
  EXPECT_DOUBLE_EQ(graded_size({.feature_edges = 4}, square, {})({2, 2}), 1.5);
  EXPECT_DOUBLE_EQ(graded_size({.grading = 0.125, .feature_edges = 4}, square, {})({2, 2}), 1.25);
  EXPECT_DOUBLE_EQ(graded_size({.grading = 8, .feature_edges = 4}, square, {})({2, 2}), 1.5);
}

TEST(GradedSize, is_never_more_than_the_size_function_or_a_source_allows) {
  Goal goal{.size = [](Point p) { return p.x; }, .grading = 0.25};
  goal.sources = {{{3, 2}, {3, 2}, 0.5, 0.5}};
  const auto size = graded_size(goal, testing::square(4), {});
  EXPECT_DOUBLE_EQ(size({0.25, 2}), 0.25);
  EXPECT_DOUBLE_EQ(size({3, 2}), 0.5);
  EXPECT_DOUBLE_EQ(size({3, 3}), 0.75);
  goal.grading = std::numeric_limits<double>::infinity();
  goal.feature_edges = 1;
  EXPECT_DOUBLE_EQ(graded_size(goal, testing::square(4), {})({3, 2}), 3) << "sources count with a limit only";
}

TEST(GradedSize, changes_as_fast_as_the_fastest_of_its_bounds) {
  Goal goal{.size = [](Point p) { return 1 + 3 * p.x; }, .size_slope = 3, .grading = 0.25};
  const auto slope = [&] { return local_bound(graded_size(goal, testing::square(4), {})).steepness().slope; };
  EXPECT_GE(slope(), 3);
  EXPECT_LT(slope(), 3.1);
  goal.grading = 5;
  EXPECT_GE(slope(), 5);
  goal.size_slope = std::numeric_limits<double>::infinity();
  EXPECT_EQ(slope(), std::numeric_limits<double>::infinity());
}

TEST(GradedSize, is_known_to_the_engine_as_a_bound_with_hints) {
  const auto size = graded_size({.grading = 0.5}, testing::square(4), {});
  EXPECT_NE(size.target<OnBackground<GradedValues>>(), nullptr);
  LocationHint hint;
  EXPECT_EQ(local_bound(size)({1, 1}, hint), size({1, 1}));
}

}  // namespace
}  // namespace pardel::engine
