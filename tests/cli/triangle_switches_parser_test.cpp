// The parser of Triangle's switches alone. triangle_switches_test.cpp tests the whole program.
#include <gtest/gtest.h>

#include "../../cli/triangle_switches.hpp"

namespace pardel::cli {
namespace {

TEST(SwitchParser, reads_numbers_up_to_the_next_letter) {
  const auto parsed = parse_triangle_switches({"-pq30.5a0.125S12D", "square"});
  ASSERT_TRUE(parsed.ok()) << parsed.error().message;
  EXPECT_TRUE(parsed->poly);
  EXPECT_EQ(parsed->min_angle_deg, 30.5);
  EXPECT_EQ(parsed->max_area, 0.125);
  EXPECT_EQ(parsed->max_steiner_points, 12U);
  EXPECT_TRUE(parsed->conforming);
}

TEST(SwitchParser, reads_exponents_as_python_writes_them) {
  const TriangleSwitches s = parse_triangle_switches({"-pa1e-05q2.5E1e", "square"}).value();
  EXPECT_EQ(s.max_area, 1e-5);
  EXPECT_EQ(s.min_angle_deg, 25);
  EXPECT_TRUE(s.edges) << "an e without digits is a switch";
  EXPECT_EQ(parse_triangle_switches({"-pa1e", "square"}).value().max_area, 1);
}

TEST(SwitchParser, an_integer_ends_before_a_point) { EXPECT_FALSE(parse_triangle_switches({"-pS1.5", "square"}).ok()); }

}  // namespace
}  // namespace pardel::cli
