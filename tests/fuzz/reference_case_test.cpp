// The fuzz target `reference` asks both refiners to reach the goal. So its cases must fulfil what Ruppert's proof asks.
#include "../../fuzz/reference_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "../../fuzz/stored_inputs.hpp"
#include "../../parallel/validate.hpp"

namespace pardel::fuzz {
namespace {

std::vector<ReferenceCase> cases_of_the_corpus() {
  std::vector<ReferenceCase> cases;
  for (const auto& file : files_below(PARDEL_CORPUS "/reference"))
    cases.push_back(decode_reference_case(bytes_of(file)));
  return cases;
}

/// The directions in which segments leave a point.
std::vector<double> directions_from(const Pslg& pslg, std::size_t point) {
  std::vector<double> directions;
  for (const Segment& s : pslg.segments)
    for (const auto& [from, to] : {std::pair(s.a, s.b), std::pair(s.b, s.a)})
      if (from == point)
        directions.push_back(
            std::atan2(pslg.points[to].y - pslg.points[from].y, pslg.points[to].x - pslg.points[from].x));
  return directions;
}

TEST(ReferenceCase, is_a_valid_domain_for_all_inputs_of_the_corpus) {
  const std::vector<ReferenceCase> cases = cases_of_the_corpus();
  ASSERT_GT(cases.size(), 10U);
  for (const auto& [pslg, goal] : cases) EXPECT_TRUE(find_problems(pslg).empty());
}

/// The largest coordinate, divided by the shortest segment.
double range_of_lengths(const Pslg& pslg) {
  double largest = 0, shortest = std::numeric_limits<double>::infinity();
  for (const Point p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a], b = pslg.points[s.b];
    shortest = std::min(shortest, std::hypot(a.x - b.x, a.y - b.y));
  }
  return largest / shortest;
}

TEST(ReferenceCase, is_a_valid_domain_where_scales_are_mixed_and_scales_differ_much) {
  int different = 0;
  for (std::uint8_t first = 140; first < 204; ++first)
    for (std::uint8_t kind = 0; kind < 4; ++kind) {
      const std::vector<std::uint8_t> bytes{first, 0, 0, kind, 1, 2, 3, 0, 7, 9, 1};
      const Pslg pslg = decode_reference_case(bytes).pslg;
      EXPECT_TRUE(find_problems(pslg).empty());
      different += range_of_lengths(pslg) > 0x1p20 ? 1 : 0;
    }
  EXPECT_GT(different, 100);
}

TEST(ReferenceCase, has_no_segments_that_meet_at_less_than_60_degrees) {
  for (const auto& [pslg, goal] : cases_of_the_corpus())
    for (std::size_t point = 0; point < pslg.points.size(); ++point) {
      const std::vector<double> directions = directions_from(pslg, point);
      for (std::size_t i = 0; i < directions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GE(std::abs(std::remainder(directions[i] - directions[j], 2 * std::numbers::pi)),
                    std::numbers::pi / 3 * (1 - 1e-12));
    }
}

TEST(ReferenceCase, no_bytes_at_all_are_a_square) {
  const Pslg square = decode_reference_case({}).pslg;
  EXPECT_EQ(square.segments.size(), 4U);
  EXPECT_TRUE(square.holes.empty());
}

}  // namespace
}  // namespace pardel::fuzz
