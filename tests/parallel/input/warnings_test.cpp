// find_warnings(): segments with open ends outside the domain.
#include "../../../parallel/warnings.hpp"

#include <gtest/gtest.h>

#include "../shapes.hpp"

namespace pardel {
namespace {

using testing::add_square;
using testing::square;

/// A square and, beside it, an outline of which one side is missing.
Pslg open_beside_closed() {
  Pslg pslg = square(4);
  add_square(pslg, 2, {6, 0});
  pslg.segments.pop_back();
  return pslg;
}

TEST(Warnings, name_an_outline_that_is_not_closed_beside_a_closed_one) {
  const Pslg pslg = open_beside_closed();
  const std::vector<Warning> warnings = find_warnings(*validate(pslg));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].segments, (std::vector<Index>{4, 5, 6}));
  EXPECT_EQ(warnings[0].message(1),
            "3 segments, the first of them segment 5, are joined but have an open end at (6, 2) and lie outside the "
            "domain. They are not in the mesh.");
}

TEST(Warnings, name_a_single_segment_in_a_hole) {
  Pslg pslg = square(8);
  add_square(pslg, 4, {2, 2});
  pslg.holes = {{3, 3}};
  pslg.points.insert(pslg.points.end(), {{4, 4}, {5, 5}});
  pslg.segments.push_back({8, 9});
  const std::vector<Warning> warnings = find_warnings(*validate(pslg));
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_TRUE(warnings[0].message().starts_with("Segment 8 has an open end at (5, 5) and lies outside the domain."));
}

TEST(Warnings, are_not_given_for_cracks_inside_the_domain_nor_for_a_convex_hull) {
  Pslg crack = square(4);
  crack.points.insert(crack.points.end(), {{1, 1}, {2, 2}});
  crack.segments.push_back({4, 5});
  EXPECT_TRUE(find_warnings(*validate(crack)).empty());
  EXPECT_TRUE(find_warnings(*validate(square(4))).empty());
  EXPECT_TRUE(find_warnings(*validate(open_beside_closed(), {.convex_hull = true})).empty());
}

}  // namespace
}  // namespace pardel
