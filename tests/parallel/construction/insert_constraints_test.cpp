// Insertion of constraints, compared with the definition of a constrained Delaunay triangulation.
#include "../../../parallel/construction/insert_constraints.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../core/support/point_order.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::delaunay_of;
using samples::Random;

void expect_constrained(const Triangulation& t, const std::vector<Constraint>& constraints) {
  std::size_t marked = 0;
  for (const Slot& slot : t.slots)
    for (const EdgeRef out : slot.n) marked += out.constrained() ? 1 : 0;
  EXPECT_EQ(marked, 2 * constraints.size());
  for (const Constraint c : constraints) {
    const EdgeRef e = samples::find_edge(t, c.a, c.b);
    ASSERT_FALSE(e.none());
    EXPECT_TRUE(t.slot(e).n[e.side()].constrained());
  }
}

/// fault() tests that every unconstrained edge is locally Delaunay. Then the triangulation is constrained Delaunay (Lee
/// and Lin 1986).
TEST(InsertConstraints, makes_a_constrained_delaunay_triangulation_of_points_in_any_position) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const samples::Family& family : samples::families(150, seed)) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      Random random(seed);
      const std::vector<Constraint> constraints = samples::random_constraints(family.points, 200, random);
      ASSERT_FALSE(constraints.empty());
      Triangulation t = delaunay_of(family.points);
      const Status inserted = insert_constraints(t, constraints);
      ASSERT_TRUE(inserted) << inserted.error().message;
      EXPECT_EQ(samples::fault(t), "");
      EXPECT_EQ(t.slots.size(), 2 * family.points.size() - 2);
      expect_constrained(t, constraints);
    }
}

/// The definition: no vertex that is visible from the interior of a triangle lies inside its circumcircle. Visibility
/// is tested from the centroid. The points are multiples of 3, so centroids are exact.
TEST(InsertConstraints, satisfies_the_definition) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<Point> points = samples::lattice_points(7);
    for (Point& p : points) p = {3 * p.x + 3 * random.below(2), 3 * p.y};
    std::sort(points.begin(), points.end(), lexicographically_less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const std::vector<Constraint> constraints = samples::random_constraints(points, 60, random);
    Triangulation t = delaunay_of(points);
    ASSERT_TRUE(insert_constraints(t, constraints));
    for (const Slot& slot : t.slots) {
      if (slot.is_ghost()) continue;
      const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
      const Point centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
      for (const Point p : points) {
        if (checker::exactly::in_circle(a, b, c, p) <= 0) continue;
        EXPECT_TRUE(std::any_of(constraints.begin(), constraints.end(),
                                [&](Constraint o) {
                                  return checker::exactly::orientation(points[o.a], points[o.b], centre) *
                                                 checker::exactly::orientation(points[o.a], points[o.b], p) <=
                                             0 &&
                                         checker::exactly::orientation(centre, p, points[o.a]) *
                                                 checker::exactly::orientation(centre, p, points[o.b]) <=
                                             0;
                                }))
            << "seed " << seed;
      }
    }
  }
}

TEST(InsertConstraints, inserts_segments_that_cross_thousands_of_triangles) {
  std::vector<Point> points = samples::uniform_points(10'000, 3);
  points.insert(points.end(), {{-1, 0.50001}, {2, 0.50002}, {-1, -1}, {2, -1.5}});
  const std::vector<Constraint> constraints{{10'000, 10'001}, {10'001, 10'003}, {10'003, 10'002}};
  Triangulation t = delaunay_of(points);
  ASSERT_TRUE(insert_constraints(t, constraints));
  EXPECT_EQ(samples::fault(t), "");
  expect_constrained(t, constraints);
}

TEST(InsertConstraints, inserts_long_segments_between_lattice_points) {
  constexpr int n = 20;
  std::vector<Point> points = samples::lattice_points(n);
  // Long segments between lattice points, all of which are cocircular with their neighbours.
  const auto at = [](int x, int y) { return static_cast<Index>(y * n + x); };
  const std::vector<Constraint> constraints{{at(0, 0), at(19, 1)},
                                            {at(0, 2), at(19, 3)},
                                            {at(0, 4), at(19, 18)},
                                            {at(0, 5), at(17, 19)},
                                            {at(19, 1), at(0, 1)}};
  Triangulation t = delaunay_of(points);
  const Status inserted = insert_constraints(t, std::span(constraints).first(4));
  ASSERT_TRUE(inserted) << inserted.error().message;
  EXPECT_EQ(samples::fault(t), "");
}

TEST(InsertConstraints, accepts_a_segment_several_times_and_in_both_directions) {
  Triangulation t = delaunay_of(samples::lattice_points(4));
  const std::vector<Constraint> constraints{{0, 7}, {7, 0}, {0, 7}};
  EXPECT_TRUE(insert_constraints(t, constraints));
  expect_constrained(t, {{0, 7}});
}

TEST(InsertConstraints, refuses_a_segment_that_crosses_another_and_names_both) {
  Triangulation t = delaunay_of({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 3}, {1, -1}});
  const std::vector<Constraint> constraints{{4, 5}, {1, 3}};
  const Status inserted = insert_constraints(t, constraints);
  ASSERT_FALSE(inserted);
  EXPECT_EQ(inserted.error().kind, ErrorKind::invalid_input);
  EXPECT_NE(inserted.error().message.find("crosses"), std::string::npos) << inserted.error().message;
}

TEST(InsertConstraints, refuses_a_segment_through_a_point) {
  for (const auto& [a, b] : {std::pair{0U, 2U}, std::pair{2U, 0U}, std::pair{0U, 8U}, std::pair{3U, 5U}}) {
    Triangulation t = delaunay_of(samples::lattice_points(3));
    const std::vector<Constraint> constraints{{a, b}};
    const Status inserted = insert_constraints(t, constraints);
    ASSERT_FALSE(inserted) << a << '-' << b;
    EXPECT_EQ(inserted.error().kind, ErrorKind::invalid_input);
    EXPECT_NE(inserted.error().message.find("through"), std::string::npos) << inserted.error().message;
  }
}

/// The text of the coordinates identifies the point, even if the coordinates are tiny.
TEST(InsertConstraints, prints_coordinates_with_all_their_digits) {
  Triangulation t = delaunay_of({{0, 0}, {2e-9, 0}, {1e-9, 0}, {0, 1}});
  const std::vector<Constraint> constraints{{0, 1}};
  const Status inserted = insert_constraints(t, constraints);
  ASSERT_FALSE(inserted);
  EXPECT_EQ(inserted.error().message, "the segment from (0, 0) to (2e-09, 0) passes through the point (1e-09, 0)");
}

}  // namespace
}  // namespace pardel::engine
