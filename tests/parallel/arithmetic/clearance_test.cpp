#include "../../../parallel/arithmetic/clearance.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pardel::engine {
namespace {

constexpr EndPoints segment{{0, 0}, {16, 0}};
constexpr double off = 0x1p-10;  // how far the split point lies from the line

bool keeps(const Clearance& beside, Point p, const EndPoints& edge = segment) {
  return keeps_clear(std::vector{beside}, segment, edge, p);
}

TEST(Clearance, lets_a_split_point_use_less_than_half_of_the_gap) {
  EXPECT_TRUE(keeps_clear({}, segment, segment, {8, off}));
  const auto gap_of = [](double times) { return Clearance{{2, 0}, times * off, 0}; };
  for (const double side : {off, -off}) {
    EXPECT_TRUE(keeps(gap_of(2.3), {8, side}));
    EXPECT_FALSE(keeps(gap_of(2.1), {8, side}));
  }
  EXPECT_TRUE(keeps(gap_of(0), {8, 0})) << "a point on the line is clear of everything";
}

TEST(Clearance, grows_with_the_distance_along_the_segment) {
  const Clearance wedge{{0, 0}, 0, off};
  EXPECT_TRUE(keeps(wedge, {3, off}));
  EXPECT_FALSE(keeps(wedge, {2, off}));
  const Clearance both{{0, 0}, off, off};
  EXPECT_TRUE(keeps(both, {2, off}));
  EXPECT_FALSE(keeps(both, {1, off}));
}

TEST(Clearance, has_to_hold_for_everything_beside_the_segment) {
  const Clearance wide{{0, 0}, 1, 0}, narrow{{0, 0}, off, 0};
  EXPECT_FALSE(keeps_clear(std::vector{wide, narrow}, segment, segment, {8, off}));
  EXPECT_FALSE(keeps_clear(std::vector{narrow, wide}, segment, segment, {8, off}));
}

TEST(Clearance, keeps_a_point_that_is_passed_on_its_side) {
  // The gap would allow all of these points; the path to them must not pass beyond the point.
  const auto tip = [](double y) { return Clearance{{4, y}, 16 * off, 1, true}; };
  for (const EndPoints& edge : {segment, EndPoints{segment.b, segment.a}}) {
    EXPECT_TRUE(keeps(tip(0.6 * off), {8, off}, edge)) << "the path is half as far from the line there";
    EXPECT_FALSE(keeps(tip(0.4 * off), {8, off}, edge));
    EXPECT_FALSE(keeps(tip(0.5 * off), {8, off}, edge)) << "nor through it";
    EXPECT_TRUE(keeps(tip(0.4 * off), {8, -off}, edge));
    EXPECT_FALSE(keeps(tip(-0.4 * off), {8, -off}, edge));
    EXPECT_TRUE(keeps(tip(0.4 * off), {2, -off}, edge)) << "behind the split point";
  }
  EXPECT_TRUE(keeps(tip(0.4 * off), {12, off}, {{8, 0}, {16, 0}})) << "it is not beside this part of the segment";
}

}  // namespace
}  // namespace pardel::engine
