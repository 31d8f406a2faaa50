// The triangles that miss the goal, of parts of a mesh together.
#include "../../cli/exempt_triangles.hpp"

#include <gtest/gtest.h>

#include "../../cli/verdict.hpp"

namespace pardel::cli {
namespace {

/// Misses triangles for the floor: so many, from a number on.
ExemptTriangles part(std::uint64_t first_number, std::uint64_t count) {
  ExemptTriangles part;
  part.counts[static_cast<std::size_t>(ExemptReason::min_edge)] = count;
  for (std::uint64_t i = 0; i < count && i < most_listed; ++i)
    part.first.push_back({first_number + i, ExemptReason::min_edge, {}});
  return part;
}

TEST(ExemptTriangles, of_parts_in_any_order_list_the_first_of_the_whole_mesh) {
  ExemptTriangles all = part(500, most_listed + 3);
  all.add(part(20, 2));
  all.add(part(100, 1));
  EXPECT_EQ(all.missed(), most_listed + 6);
  ASSERT_EQ(all.first.size(), most_listed);
  EXPECT_EQ(all.first[0].number, 20U);
  EXPECT_EQ(all.first[1].number, 21U);
  EXPECT_EQ(all.first[2].number, 100U);
  EXPECT_EQ(all.first[3].number, 500U);
}

TEST(ExemptTriangles, are_missed_for_every_reason_that_is_not_a_small_angle_of_the_input) {
  for (int i = 0; i < exempt_reasons; ++i) {
    ExemptTriangles one;
    one.counts[static_cast<std::size_t>(i)] = 1;
    EXPECT_EQ(one.missed(), justified(static_cast<ExemptReason>(i)) ? 0U : 1U);
  }
}

}  // namespace
}  // namespace pardel::cli
