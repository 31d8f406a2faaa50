// Patches give way around stuck triangles, become smaller, and are given up after a bounded number of rounds.
#include "../../../parallel/filling/rounds.hpp"

#include <gtest/gtest.h>

#include <array>

#include "../../../parallel/triangulation/triangle_shape.hpp"
#include "../patches/distance_to.hpp"
#include "../patches/domains_to_fill.hpp"

namespace pardel::engine {
namespace {

TEST(Rounds, clear_a_disk_around_each_stuck_triangle) {
  Rounds rounds({0.25, INFINITY});
  EXPECT_EQ(rounds.failed(), 0U);
  EXPECT_TRUE(rounds.clearings().empty());
  const DomainTriangulation square = coarse(domains::square());
  Triangulation t = square.triangulation;
  t.region.resize(t.slots.size(), 0);
  ASSERT_TRUE(rounds.go_on(t, std::array<TriangleId, 2>{0, 1}, 1000));
  ASSERT_EQ(rounds.clearings().size(), 2U);
  EXPECT_EQ(rounds.clearings()[1].centre, Shape(t, t.slots[1]).centroid());
  const double first = rounds.clearings()[1].radius;
  EXPECT_NEAR(first, 0.25, 0.05) << "about one edge";
  ASSERT_TRUE(rounds.go_on(t, std::array<TriangleId, 1>{1}, 1000));
  ASSERT_EQ(rounds.clearings().size(), 3U);
  EXPECT_GT(rounds.clearings()[2].radius, first) << "a place that comes again needs a larger disk";
  EXPECT_LT(rounds.clearings()[2].radius, 1.1 * first);
  EXPECT_EQ(rounds.failed(), 2U);
}

TEST(Rounds, shorten_the_edges_if_clearing_does_not_help) {
  Rounds rounds({0.25, 0.5});
  const Triangulation t = coarse(domains::square()).triangulation;
  const auto failures_until = [&](double edge, std::size_t stuck) {
    const std::vector<TriangleId> same(stuck, 0);
    int failures = 0;
    for (; rounds.edges()[0] > edge; ++failures) EXPECT_TRUE(rounds.go_on(t, same, 1000));
    return failures;
  };
  EXPECT_EQ(failures_until(0.2499, 17), 5) << "four without progress";
  EXPECT_TRUE(rounds.clearings().empty()) << "the old clearings do not belong to the new lattice";
  EXPECT_DOUBLE_EQ(rounds.edges()[0], 0.25 * 0.995);
  EXPECT_EQ(rounds.edges()[1], 2 * rounds.edges()[0]);
  EXPECT_EQ(failures_until(0.2487, 16), 7) << "a few stuck triangles come and go";
  EXPECT_DOUBLE_EQ(rounds.edges()[0], 0.25 * 0.995 * 0.995 * 0.995);
}

TEST(Rounds, end_soon_if_they_cost_more_than_they_can_save) {
  const Triangulation small = coarse(domains::square()).triangulation;
  const auto rounds_until_end = [&](std::uint64_t laid, std::size_t vertices) {
    Rounds rounds({0.25});
    Triangulation t = small;
    t.points.resize(vertices);
    while (rounds.go_on(t, std::array<TriangleId, 1>{0}, laid)) EXPECT_LT(rounds.failed(), 100U);
    return rounds.failed();
  };
  EXPECT_GE(rounds_until_end(1'000'000, 1000), 20U);
  EXPECT_LE(rounds_until_end(1'000'000, 400'000), 6U);
  EXPECT_EQ(rounds_until_end(10, 1'000'000), 1U);
}

TEST(Rounds, may_make_one_and_a_half_vertices_for_each_laid_triangle_and_some_thousands_more) {
  Triangulation t = coarse(domains::square()).triangulation;
  t.points.resize(900'000);
  Rounds exact({0.25}), too_many({0.25});
  EXPECT_TRUE(exact.go_on(t, std::array<TriangleId, 1>{0}, 1'000'000));
  EXPECT_TRUE(exact.go_on(t, std::array<TriangleId, 1>{0}, 1'000'000)) << "1,800,000 vertices in all rounds";
  EXPECT_TRUE(too_many.go_on(t, std::array<TriangleId, 1>{0}, 1'000'000));
  t.points.resize(900'001);
  EXPECT_FALSE(too_many.go_on(t, std::array<TriangleId, 1>{0}, 1'000'000));
}

}  // namespace
}  // namespace pardel::engine
