// The initial assessment of all triangles finds the bad triangles, in order, and estimates the size of the mesh.
#include "../../../parallel/scheduling/initial_assessment.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "../../../parallel/threads/parallel_for.hpp"
#include "../refinement/assessed_sample.hpp"

namespace pardel::engine {
namespace {

struct AssessmentScene : samples::AssessedSample {
  AssessmentScene(const std::vector<Point>& points, const Goal& goal)
      : AssessedSample(points, goal, Placement::off_centre) {}
  [[nodiscard]] InitialAssessment assessment(int threads) const {
    return assess_all(sample.triangulation, criteria, assessor, threads);
  }
};

TEST(InitialAssessment, lists_the_bad_triangles_in_order_on_any_number_of_threads) {
  const AssessmentScene scene(samples::uniform_points(20'000, 9), {.min_angle_deg = 30});
  ASSERT_GT(scene.sample.triangulation.slots.size(), 2 * items_in_block);
  std::vector<TriangleId> expected;
  for (TriangleId id = 0; id < scene.sample.triangulation.slots.size(); ++id)
    if (scene.assessor.assess(id).need != Assessment::Need::nothing) expected.push_back(id);
  for (const int threads : {1, 2, 5}) {
    std::vector<TriangleId> found;
    for (const Deferred& d : scene.assessment(threads).bad) found.push_back(d.triangle.id());
    EXPECT_EQ(found, expected) << threads << " threads";
  }
}

TEST(InitialAssessment, estimates_the_number_of_triangles_from_the_bounds) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const TriangleEstimates by_area =
      AssessmentScene(square, {.min_angle_deg = 25, .max_area = 0.001}).assessment(1).estimates;
  EXPECT_NEAR(by_area.lower_bound, 1000, 1e-6);
  EXPECT_GT(by_area.without_angle_bound, 1300);
  EXPECT_LT(by_area.without_angle_bound, 1700);
  EXPECT_EQ(by_area.with_angle_bound, by_area.without_angle_bound) << "the bound on areas demands more than the angles";
  const TriangleEstimates by_angle = AssessmentScene(square, {.min_angle_deg = 33}).assessment(1).estimates;
  EXPECT_EQ(by_angle.lower_bound, 0);
  EXPECT_GT(by_angle.with_angle_bound, by_angle.without_angle_bound);
}

TEST(InitialAssessment, tells_whether_a_triangle_is_left_alone) {
  EXPECT_FALSE(AssessmentScene({{0, 0}, {1, 0}, {0.5, 0.8}}, {.min_angle_deg = 25}).assessment(1).left_alone);
  EXPECT_TRUE(AssessmentScene({{0, 0}, {1, 0}, {1, 0.1}}, {.min_angle_deg = 25}).assessment(1).left_alone)
      << "a triangle between two segments";
}

/// The same domain, with even sizes and with small sizes in one corner.
TEST(InitialAssessment, predicts_how_unevenly_a_lattice_divides_the_work) {
  const Lattice lattice({0, 0, 1, 1}, 16, 16);
  const auto overload_of = [&](std::function<double(Point)> size) {
    const samples::AssessedSample scene(samples::uniform_points(2000, 3), {.size = std::move(size)},
                                        Placement::off_centre);
    return overload(scene.sample.triangulation, scene.criteria, scene.assessor, lattice, 1);
  };
  EXPECT_NEAR(overload_of([](Point) { return 0.001; }), 1, 0.1);
  EXPECT_GT(overload_of([](Point p) { return 1e-4 + 0.01 * (p.x + p.y); }), 10);
}

/// Two triangles in four cells. The first triangle is to be divided into many, the second into few.
TEST(InitialAssessment, compares_the_work_of_cells_exactly) {
  Triangulation t = samples::triangulated({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).triangulation;
  ASSERT_EQ(t.slots.size(), 2U);
  const auto overload_with = [&](double first, double second, const Lattice& lattice) {
    const Options options;
    const Criteria criteria({.min_angle_deg = 0, .region_caps = true}, Placement::off_centre, {first, second});
    t.region.resize(2);
    t.region[0] = 0;
    t.region[1] = 1;
    const DomainSegments none;
    const Assessor assessor(t, none, criteria, options);
    return overload(t, criteria, assessor, lattice, 1);
  };
  const Lattice four({0, 0, 1, 1}, 2, 2), one({0, 0, 1, 1}, 1, 1);
  const double even = overload_with(0.01, 0.01, four), uneven = overload_with(0.01, 0.1, four);
  EXPECT_DOUBLE_EQ(even, 1) << "triangles of more than a cell count in several cells";
  EXPECT_DOUBLE_EQ(overload_with(0.02, 0.02, four), even) << "only the shares matter";
  EXPECT_DOUBLE_EQ(overload_with(30, 30, four), even) << "also if there is little work";
  EXPECT_DOUBLE_EQ(overload_with(0.1, 0.01, four), uneven) << "the order does not matter";
  EXPECT_GT(uneven, 1.5);
  EXPECT_DOUBLE_EQ(overload_with(0.01, 0.1, one), 1) << "in one cell, all work is even";
  t.slots.resize(0);
  EXPECT_EQ(overload_with(0.01, 0.1, four), 1) << "without triangles, all work is even, too";
  t = samples::triangulated({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).triangulation;
  const Lattice halves({-0.25, 0, 1.25, 1}, 3, 1);
  EXPECT_DOUBLE_EQ(overload_with(0.01, 0.01, halves), 3)
      << "triangles as large as a cell count in the cells of their centroids, here one of three";
}

}  // namespace
}  // namespace pardel::engine
