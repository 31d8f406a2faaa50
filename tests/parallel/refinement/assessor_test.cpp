// Assessments: encroached edges are split first, then bad triangles; some triangles are not split.
#include "../../../parallel/refinement/assessor.hpp"

#include <gtest/gtest.h>

#include "assessed_sample.hpp"

namespace pardel::engine {
namespace {

using Need = Assessment::Need;

/// One triangle with the base from (0, 0) to (8, 0) and the corner `apex`. All its edges are constrained.
struct AssessorScene : samples::AssessedSample {
  AssessorScene(Point apex, const Goal& goal, const Options& with = {})
      : AssessedSample({{0, 0}, {8, 0}, apex}, goal, Placement::circumcentre, with) {}
  [[nodiscard]] const Slot& slot() const { return sample.triangulation.slots[0]; }
  /// The side opposite the apex.
  [[nodiscard]] unsigned base() const {
    unsigned side = 0;
    while (slot().v[side] != 2) ++side;
    return side;
  }
};

TEST(Assessor, splits_an_encroached_edge_before_the_triangle) {
  const AssessorScene scene({4, 1}, {.min_angle_deg = 30, .max_area = 0.1});
  const Assessment a = scene.assessor.assess(0);
  EXPECT_EQ(a.need, Need::split_edge);
  EXPECT_EQ(a.side, scene.base());
  EXPECT_EQ(a.key, BucketQueue::urgent);
  EXPECT_EQ(scene.assessor.point_for(0, a), (Point{4, 0}));
  const Assessment inside = scene.assessor.assess_inside(0);
  EXPECT_EQ(inside.need, Need::split_triangle);
  EXPECT_NE(inside.side, scene.base()) << "the shortest side is another one";
}

TEST(Assessor, splits_no_edge_on_the_border_of_a_patch) {
  AssessorScene scene({4, 1}, {.min_angle_deg = 30, .max_area = 0.1});
  const EdgeRef base(0, scene.base());
  EXPECT_FALSE(scene.assessor.forbidden(base));
  Array<Index>& origin = scene.sample.triangulation.origin;
  origin[0] = border_vertex;
  EXPECT_FALSE(scene.assessor.forbidden(base)) << "only one end is on a border";
  origin[1] = border_vertex;
  EXPECT_TRUE(scene.assessor.forbidden(base));
  const Assessment a = scene.assessor.assess(0);
  EXPECT_TRUE(a.need != Need::split_edge || a.side != scene.base());
}

TEST(Assessor, does_nothing_where_the_triangle_keeps_the_goal) {
  const AssessorScene scene({4, 7}, {.min_angle_deg = 30});
  EXPECT_EQ(scene.assessor.assess(0).need, Need::nothing);
  EXPECT_FALSE(scene.assessor.assess(0).left_alone);
  EXPECT_FALSE(scene.assessor.breaks_goal(0));
}

TEST(Assessor, orders_bad_triangles_by_their_shortest_side) {
  const AssessorScene scene({4, 7}, {.max_area = 10});
  const Assessment a = scene.assessor.assess(0);
  EXPECT_EQ(a.need, Need::split_triangle);
  EXPECT_EQ(a.side, scene.base());
  EXPECT_EQ(a.key, BucketQueue::key(64));
  EXPECT_EQ(a.longest_squared, 65);
  const QueuedTriangle entry = scene.assessor.entry(0, a);
  EXPECT_EQ(entry.side, EdgeRef(0, scene.base()));
  EXPECT_TRUE(entry.is_current(scene.sample.triangulation));
}

TEST(Assessor, leaves_a_triangle_between_two_segments_alone_unless_it_is_too_large) {
  const AssessorScene sharp({8, 1}, {.min_angle_deg = 30});
  EXPECT_EQ(sharp.assessor.assess_inside(0).need, Need::nothing);
  EXPECT_TRUE(sharp.assessor.assess_inside(0).left_alone);
  EXPECT_TRUE(sharp.assessor.breaks_goal(0));
  const AssessorScene large({8, 1}, {.min_angle_deg = 30, .max_area = 1});
  EXPECT_EQ(large.assessor.assess_inside(0).need, Need::split_triangle);
}

TEST(Assessor, leaves_a_triangle_with_an_edge_shorter_than_the_minimum_alone) {
  const AssessorScene scene({4, 7}, {.max_area = 10}, {.min_edge = 8.001});
  EXPECT_EQ(scene.assessor.assess(0).need, Need::nothing);
  EXPECT_TRUE(scene.assessor.assess(0).left_alone);
}

/// Measured from its far corner, the shortest side has length 0.
TEST(Assessor, splits_a_triangle_with_a_short_side_far_from_its_third_corner) {
  const double far = 0x1p60;
  for (const std::vector<Point>& corners :
       {std::vector<Point>{{0, 0}, {8, 0}, {far, far}}, {{-far, -far}, {0, 0}, {0, 8}}}) {
    const samples::AssessedSample scene(corners, {.max_area = 1}, Placement::circumcentre);
    EXPECT_EQ(scene.assessor.assess_inside(0).need, Need::split_triangle);
  }
}

TEST(Assessor, splits_no_edge_that_is_forbidden_or_too_short) {
  const Goal goal{.min_angle_deg = 5};
  for (const Options& options :
       {Options{.no_boundary_splits = true}, Options{.no_segment_splits = true}, Options{.min_edge = 4.001}}) {
    const AssessorScene scene({4, 1}, goal, options);
    const EdgeRef base(0, scene.base());
    EXPECT_TRUE(scene.assessor.forbidden(base) || scene.assessor.below_floor(base));
    EXPECT_EQ(scene.assessor.assess(0).need, Need::nothing);
  }
  const AssessorScene scene({4, 1}, goal, {.min_edge = 3.999});
  EXPECT_EQ(scene.assessor.assess(0).need, Need::split_edge);
}

}  // namespace
}  // namespace pardel::engine
