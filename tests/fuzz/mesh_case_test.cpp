// Bytes decode to cases with constraints, and the committed corpus contains all parts of a Pslg. Without these tests, a
// decoder that drops all constraints would make the fuzz target useless, and nobody would notice.
#include "../../fuzz/mesh_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../fuzz/stored_inputs.hpp"
#include "../../parallel/validate.hpp"

namespace pardel::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> corpus() {
  std::vector<Bytes> inputs;
  for (const auto& file : files_below(PARDEL_CORPUS "/mesh")) inputs.push_back(bytes_of(file));
  return inputs;
}

/// The number of segments of the outline. An empty input gives an outline only.
std::size_t outline_segments() { return decode_mesh_case({}).pslg.segments.size(); }

TEST(MeshCase, no_bytes_at_all_still_draw_an_outline) {
  const Prepared prepared = prepare(decode_mesh_case({}));
  ASSERT_TRUE(prepared.usable);
  EXPECT_EQ(prepared.pslg.segments.size(), outline_segments());
  EXPECT_TRUE(find_problems(prepared.pslg).empty());
}

TEST(MeshCase, the_same_bytes_mean_the_same_case) {
  const Bytes bytes{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20};
  EXPECT_EQ(decode_mesh_case(bytes).pslg, decode_mesh_case(bytes).pslg);
}

TEST(MeshCase, a_stroke_adds_to_the_domain_and_leaves_the_goal_alone) {
  Bytes bytes(header_bytes);
  const MeshCase without = decode_mesh_case(bytes);
  bytes.insert(bytes.end(), {1, 1, 1, 2, 3, 0, 0, 0});  // a segment from (1, 1) to (2, 3)
  const MeshCase with = decode_mesh_case(bytes);
  ASSERT_EQ(with.pslg.points.size(), without.pslg.points.size() + 2);
  EXPECT_EQ(with.pslg.points.back(), (Point{2, 3}));
  EXPECT_EQ(with.pslg.segments.size(), without.pslg.segments.size() + 1);
  EXPECT_EQ(with.goal.min_angle_deg, without.goal.min_angle_deg);
  EXPECT_FALSE(with.nudged);
}

TEST(MeshCase, every_family_draws_a_domain) {
  for (std::uint8_t family = 0; family < 11; ++family) {
    Bytes bytes(header_bytes);
    bytes[6] = 3;  // the outline: a domain of a family
    bytes[7] = family;
    bytes[8] = 20;  // its size
    const Prepared prepared = prepare(decode_mesh_case(bytes));
    EXPECT_TRUE(prepared.usable) << int(family);
    EXPECT_GE(prepared.pslg.points.size(), 3U) << int(family);
  }
}

TEST(MeshCase, mixtures_of_scales_are_valid_domains_that_differ_from_those_without) {
  Bytes bytes(header_bytes);
  bytes[6] = 3;
  bytes[8] = 20;
  int mixed = 0;
  for (std::uint8_t seed = 0; seed < 200; ++seed) {
    bytes[7] = seed;
    bytes[27] = seed;
    bytes[28] = 0;
    const Prepared without = prepare(decode_mesh_case(bytes));
    bytes[28] = 100;
    const Prepared with = prepare(decode_mesh_case(bytes));
    ASSERT_TRUE(with.usable);
    EXPECT_TRUE(find_problems(with.pslg).empty()) << int(seed);
    mixed += with.pslg != without.pslg ? 1 : 0;
  }
  EXPECT_GT(mixed, 150);
}

TEST(MeshCase, repairing_keeps_what_was_drawn) {
  for (const Bytes& bytes : corpus()) {
    const MeshCase drawn = decode_mesh_case(bytes);
    const Prepared prepared = prepare(drawn);
    // The last test limits the number of the unusable ones. Mixed domains are moved.
    if (!prepared.usable || drawn.mixture != 0) continue;
    // Repair may split a drawn segment, but it keeps both ends.
    for (const Segment& segment : drawn.pslg.segments) {
      for (const Index end : {segment.a, segment.b}) {
        const Point p = drawn.pslg.points[end];
        EXPECT_NE(std::find(prepared.pslg.points.begin(), prepared.pslg.points.end(), p), prepared.pslg.points.end());
      }
    }
    EXPECT_GE(prepared.pslg.segments.size(), 3U);
  }
}

TEST(MeshCase, the_corpus_exercises_constraints_holes_and_regions) {
  const std::vector<Bytes> inputs = corpus();
  std::size_t usable = 0, whole = 0, constraints = 0, holes = 0, regions = 0, crossings = 0, caps = 0, conforming = 0;
  for (const Bytes& bytes : inputs) {
    const MeshCase drawn = decode_mesh_case(bytes);
    const Prepared prepared = prepare(drawn);
    if (!prepared.usable) continue;
    ++usable;
    whole += !prepared.reduced;
    constraints += prepared.pslg.segments.size() >= outline_segments() + 3;
    holes += !prepared.pslg.holes.empty();
    regions += !prepared.pslg.regions.empty();
    crossings += prepared.pslg.points.size() > drawn.pslg.points.size();
    caps += drawn.goal.max_area < std::numeric_limits<double>::infinity();
    conforming += drawn.goal.conforming;
  }
  // Each feature must occur in a minimum share of the corpus, not only once.
  const std::size_t n = inputs.size();
  EXPECT_GE(n, 60u);
  EXPECT_GE(usable, n * 95 / 100);
  EXPECT_GE(whole, n * 80 / 100);
  EXPECT_GE(constraints, n * 70 / 100);
  EXPECT_GE(holes, n * 40 / 100);
  EXPECT_GE(regions, n * 25 / 100);
  EXPECT_GE(crossings, n / 20);
  EXPECT_GE(caps, n * 20 / 100);
  EXPECT_GE(conforming, n / 10);
}

}  // namespace
}  // namespace pardel::fuzz
