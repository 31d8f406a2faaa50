#include "../../../parallel/construction/domain_triangulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

/// A square of side 8 with a square hole of side 2.
Pslg frame() {
  Pslg pslg = testing::square(8);
  pslg.segments[1].marker = 5;
  testing::add_square(pslg, 2, {3, 3});
  pslg.holes = {{4, 4}};
  return pslg;
}

TEST(TriangulateDomain, triangulates_what_the_segments_enclose_without_the_holes) {
  const Result<DomainTriangulation> domain = triangulate_domain(frame(), /*convex_hull=*/false);
  ASSERT_TRUE(domain) << domain.error().message;
  const Triangulation& t = domain->triangulation;
  EXPECT_EQ(samples::fault(t), "");
  EXPECT_EQ(samples::twice_area(t), 2 * 60);
  EXPECT_TRUE(std::ranges::all_of(t.origin, [](Index origin) { return origin == input_vertex; }));
}

TEST(TriangulateDomain, records_the_input_segment_and_the_marker_of_each_segment) {
  const Pslg pslg = frame();
  const Result<DomainTriangulation> domain = triangulate_domain(pslg, /*convex_hull=*/false);
  ASSERT_TRUE(domain);
  ASSERT_EQ(domain->segments.size(), pslg.segments.size());
  for (Index s = 0; s < domain->segments.size(); ++s) {
    const Segment& segment = pslg.segments[domain->input_segment[s]];
    const DomainSegment& found = domain->segments[s];
    EXPECT_EQ(std::minmax(segment.a, segment.b),
              std::minmax(domain->input_of_vertex[found.a], domain->input_of_vertex[found.b]));
    EXPECT_EQ(domain->segments[s].marker, segment.marker);
  }
}

TEST(TriangulateDomain, adds_hull_edges_that_have_no_input_segment) {
  const Pslg pslg = testing::points_only({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}});
  const Result<DomainTriangulation> domain = triangulate_domain(pslg, /*convex_hull=*/false);
  ASSERT_TRUE(domain);
  EXPECT_EQ(samples::twice_area(domain->triangulation), 2 * 16);
  EXPECT_EQ(domain->input_segment, std::vector<Index>(4, no_index));
  for (Index s = 0; s < 4; ++s) EXPECT_EQ(domain->segments[s].marker, 0);
}

TEST(TriangulateDomain, rejects_an_empty_domain) {
  Pslg open = testing::points_only({{0, 0}, {4, 0}, {4, 4}});
  open.segments = {{0, 1, 0}, {1, 2, 0}};
  const Result<DomainTriangulation> domain = triangulate_domain(open, /*convex_hull=*/false);
  ASSERT_FALSE(domain);
  EXPECT_EQ(domain.error().kind, ErrorKind::invalid_input);
}

TEST(InputCorners, are_the_corners_in_the_numbers_of_the_input) {
  const Pslg pslg = frame();
  const Result<DomainTriangulation> domain = triangulate_domain(pslg, /*convex_hull=*/false);
  ASSERT_TRUE(domain);
  const Triangulation& t = domain->triangulation;
  const auto corners = input_corners(*domain);
  ASSERT_EQ(corners.size(), t.slots.size());
  for (TriangleId id = 0; id < corners.size(); ++id)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(pslg.points[corners[id][i]], t.points[t.slots[id].v[i]]);
}

}  // namespace
}  // namespace pardel::engine
