#include "../../../parallel/construction/hairlines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../parallel/construction/hairlines_outside.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

constexpr double ulp = 0x1p-52;
constexpr double tiny = 0x1p-138;

/// A unit square, and another one to the right of it at this distance, shifted upwards.
Pslg two_squares(double gap, double shift) {
  Pslg pslg;
  testing::add_polygon(pslg, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  testing::add_polygon(pslg, {{1 + gap, shift}, {2, shift}, {2, shift + 1}, {1 + gap, shift + 1}});
  return pslg;
}

DomainTriangulation triangulated(const Pslg& pslg) {
  Result<DomainTriangulation> domain = triangulate_domain(pslg, false);
  EXPECT_TRUE(domain);
  return std::move(domain).value();
}

/// The clearances of an input segment that a gap causes, not a wedge.
std::vector<Clearance> at_gaps(const DomainTriangulation& domain, Index input_segment) {
  const auto found = std::ranges::find(domain.input_segment, input_segment);
  const auto all = domain.segments.clearances(static_cast<Index>(found - domain.input_segment.begin()));
  return {all.begin(), all.end()};
}

TEST(Hairlines, are_known_to_the_segments_on_both_sides) {
  const DomainTriangulation domain = triangulated(two_squares(2 * ulp, 0.5));
  const std::vector<Clearance> right = at_gaps(domain, 1), left = at_gaps(domain, 7);
  ASSERT_EQ(right.size(), 2U) << "its upper end, and the lower end of the other side";
  ASSERT_EQ(left.size(), 2U);
  for (const std::vector<Clearance>& side : {right, left}) {
    EXPECT_EQ(std::ranges::count(side, true, &Clearance::is_passed), 1);
    for (const Clearance& each : side) {
      EXPECT_EQ(each.gap, 2 * ulp);
      EXPECT_LE(each.slope, ulp);
    }
  }
  const std::vector<Clearance> lower_side = at_gaps(domain, 4);
  ASSERT_EQ(lower_side.size(), 1U) << "it begins at the gap";
  EXPECT_NEAR(lower_side[0].slope, 1, 1e-9);
  EXPECT_TRUE(at_gaps(domain, 3).empty());
}

TEST(Hairlines, are_gaps_that_rounding_could_close) {
  for (const double gap : {1e-9, 1e-12, 0x1p-45}) {
    const DomainTriangulation domain = triangulated(two_squares(gap, 0.5));
    for (Index s = 0; s < 8; ++s) EXPECT_TRUE(at_gaps(domain, s).empty()) << gap;
  }
  // At larger coordinates, a wider gap is as few units in the last place.
  Pslg far = two_squares(1e-12, 0.5);
  for (Point& p : far.points) p.y += 1024;
  EXPECT_FALSE(at_gaps(triangulated(far), 1).empty());
}

TEST(Hairlines, lie_outside_the_domain) {
  Pslg joined = two_squares(2 * ulp, 0.5);
  testing::add_polygon(joined, {{-1, -1}, {3, -1}, {3, 3}, {-1, 3}});
  const DomainTriangulation domain = triangulated(joined);
  for (Index s = 0; s < domain.segments.size(); ++s) EXPECT_TRUE(domain.segments.clearances(s).empty());
}

TEST(Hairlines, end_where_corners_face_each_other) {
  Pslg pslg;
  testing::add_polygon(pslg, {{0, 0}, {-1, 1}, {-1, -1}});
  testing::add_polygon(pslg, {{tiny, 0}, {1, -1}, {1, 1}});
  const DomainTriangulation domain = triangulated(pslg);
  for (const Index s : {0U, 2U, 3U, 5U}) {
    ASSERT_FALSE(at_gaps(domain, s).empty()) << s;
    EXPECT_EQ(at_gaps(domain, s)[0].gap, tiny);
    EXPECT_FALSE(at_gaps(domain, s)[0].is_passed);
  }
}

TEST(Hairlines, of_a_mesh_are_those_of_its_boundary) {
  Pslg pslg = two_squares(2 * ulp, 0.5);
  const auto triangulation = triangulated(pslg).triangulation;
  const std::vector<Hairline> found = hairlines_outside(triangulation, {});
  ASSERT_EQ(found.size(), 2U);
  for (const Hairline& line : found) EXPECT_EQ(gap_of(line), 2 * ulp);
  EXPECT_TRUE(hairlines_outside(triangulated(two_squares(1e-3, 0.5)).triangulation, {}).empty());
}

TEST(Hairlines, between_many_flat_triangles_are_found) {
  // A square beside three others, all of which are one unit in the last place away from it.
  Pslg pslg;
  testing::add_polygon(pslg, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const double low : {0.0625, 0.375, 0.6875})
    testing::add_polygon(pslg, {{1 + ulp, low}, {2, low}, {2, low + 0.25}, {1 + ulp, low + 0.25}});
  const DomainTriangulation domain = triangulated(pslg);
  std::set<double> passed;
  for (const Clearance& each : at_gaps(domain, 1))
    if (each.is_passed) passed.insert(each.at.y);
  EXPECT_EQ(passed, (std::set<double>{0.0625, 0.3125, 0.375, 0.625, 0.6875, 0.9375}));
}

}  // namespace
}  // namespace pardel::engine
