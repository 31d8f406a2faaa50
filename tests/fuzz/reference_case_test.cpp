// The fuzz target `reference` asks both refiners to reach the goal. So its cases must fulfil what Ruppert's proof asks.
#include "../../fuzz/reference_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
