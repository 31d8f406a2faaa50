// The polylines of a domain: where they begin, and which vertices are corners.
#include "../../../parallel/sizing/polylines.hpp"

#include <gtest/gtest.h>

#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_polygon;
using testing::regular_polygon;

TEST(Polylines, end_at_corners_and_go_on_where_the_direction_turns_little) {
  Pslg pslg;
  add_polygon(pslg, {{0, 0}, {4, 0}, {6, 1}, {6, 5}, {0, 5}});
  const Polylines lines = find_polylines(pslg, {});
  EXPECT_EQ(lines.is_corner, (std::vector<bool>{true, false, true, true, true}));
  ASSERT_EQ(lines.all.size(), 4U);
  EXPECT_EQ(lines.all[0].vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_FALSE(lines.all[0].closed);
}

TEST(Polylines, are_closed_without_a_corner_and_begin_at_their_least_vertex) {
  const Polylines lines = find_polylines(regular_polygon(8), {});
  ASSERT_EQ(lines.all.size(), 1U);
  EXPECT_TRUE(lines.all[0].closed);
  EXPECT_EQ(lines.all[0].vertices.front(), 4U);
  EXPECT_EQ(lines.all[0].vertices.back(), 4U);
  EXPECT_EQ(lines.all[0].vertices.size(), 9U);
}

TEST(Polylines, of_a_heptagon_are_its_sides) { EXPECT_EQ(find_polylines(regular_polygon(7), {}).all.size(), 7U); }

}  // namespace
}  // namespace pardel::engine
