// Segments forced into a triangulation, and what is then the domain.
#include "../../../parallel/triangulation/insert_constraints.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/triangulation/delaunay.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

Triangulation delaunay_of(const std::vector<Point>& points) {
  Result<Delaunay> made = delaunay(points);
  EXPECT_TRUE(made);
  Triangulation& t = made->triangulation;
  for (Slot& slot : t.slots)
    for (VertexId& v : slot.v)
      if (v != ghost) v = made->input_of_vertex[v];
  t.points = Array<Point>(std::span<const Point>(points));
  return std::move(t);
}

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

/// Locally Delaunay on every unconstrained edge is constrained Delaunay (Lee and Lin 1986), which fault() tests.
TEST(InsertConstraints, makes_a_constrained_delaunay_triangulation_whatever_the_position) {
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

/// No vertex that a triangle sees lies inside its circle: the definition, where seeing is from its centroid on
/// a lattice fine enough for that to be exact.
TEST(InsertConstraints, satisfies_the_definition) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<Point> points = samples::lattice_points(7);
    for (Point& p : points) p = {3 * p.x + 3 * random.below(2), 3 * p.y};
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
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

TEST(InsertConstraints, cuts_across_ten_thousand_points_both_ways) {
  std::vector<Point> points = samples::uniform_points(10'000, 3);
  points.insert(points.end(), {{-1, 0.50001}, {2, 0.50002}, {-1, -1}, {2, -1.5}});
  const std::vector<Constraint> constraints{{10'000, 10'001}, {10'001, 10'003}, {10'003, 10'002}};
  Triangulation t = delaunay_of(points);
  ASSERT_TRUE(insert_constraints(t, constraints));
  EXPECT_EQ(samples::fault(t), "");
  expect_constrained(t, constraints);
}

TEST(InsertConstraints, runs_between_the_rows_of_a_lattice) {
  constexpr int n = 20;
  std::vector<Point> points = samples::lattice_points(n);
  // Knight's moves of growing length through everything cocircular.
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

TEST(InsertConstraints, accepts_a_segment_twice_and_in_either_direction) {
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

/// A square of side 8 with a square hole of side 2 in it, and a crack into it from the outline.
struct Frame {
  std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {3, 3}, {5, 3}, {5, 5}, {3, 5}, {0, 4}, {1, 4}};
  std::vector<Constraint> constraints{{0, 1}, {1, 2}, {2, 3}, {3, 8}, {8, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {8, 9}};

  [[nodiscard]] Triangulation constrained() const {
    Triangulation t = delaunay_of(points);
    EXPECT_TRUE(insert_constraints(t, constraints));
    return t;
  }
};

TEST(Carve, leaves_everything_inside_the_outline) {
  Triangulation t = Frame().constrained();
  EXPECT_TRUE(carve(t, {}).empty());
  EXPECT_EQ(samples::fault(t), "");
  EXPECT_EQ(samples::twice_area(t), 2 * 64);
  EXPECT_TRUE(t.region.empty());
}

TEST(Carve, takes_out_holes) {
  Triangulation t = Frame().constrained();
  DomainRules rules;
  rules.holes = {{4, 4}};
  (void)carve(t, rules);
  EXPECT_EQ(samples::fault(t), "");
  EXPECT_EQ(samples::twice_area(t), 2 * 60);
}

TEST(Carve, takes_out_a_hole_that_the_crack_does_not_stop) {
  Triangulation t = Frame().constrained();
  DomainRules rules;
  rules.holes = {{0.5, 3}};
  (void)carve(t, rules);
  EXPECT_EQ(samples::twice_area(t), 2 * 4);
}

TEST(Carve, labels_regions_on_both_sides_of_a_crack) {
  Triangulation t = Frame().constrained();
  DomainRules rules;
  rules.region_seeds = {{4, 4}, {0.5, 3}};
  (void)carve(t, rules);
  ASSERT_EQ(t.region.size(), t.slots.size());
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const auto& v = t.slots[id].v;
    const Point a = t.points[v[0]], b = t.points[v[1]], c = t.points[v[2]];
    const double x = (a.x + b.x + c.x) / 3, y = (a.y + b.y + c.y) / 3;
    EXPECT_EQ(t.region[id], x > 3 && x < 5 && y > 3 && y < 5 ? 0U : 1U);
  }
}

TEST(Carve, leaves_a_face_without_a_seed_unlabelled) {
  Triangulation t = Frame().constrained();
  DomainRules rules;
  rules.region_seeds = {{4, 4}};
  (void)carve(t, rules);
  EXPECT_EQ(std::count(t.region.begin(), t.region.end(), 0U), 2);
  EXPECT_EQ(std::count(t.region.begin(), t.region.end(), no_index), static_cast<std::ptrdiff_t>(t.slots.size()) - 2);
}

TEST(Carve, keeps_the_convex_hull_and_returns_its_edges) {
  for (const samples::Family& family : samples::families(200, 3)) {
    Triangulation t = delaunay_of(family.points);
    const std::size_t faces = static_cast<std::size_t>(
        std::count_if(t.slots.begin(), t.slots.end(), [](const Slot& slot) { return !slot.is_ghost(); }));
    const std::size_t ghosts = t.slots.size() - faces;
    DomainRules rules;
    rules.convex_hull = true;
    const std::vector<Constraint> hull = carve(t, rules);
    EXPECT_EQ(t.slots.size(), faces) << family.name;
    EXPECT_EQ(hull.size(), ghosts) << family.name;
    EXPECT_EQ(samples::fault(t), "") << family.name;
    for (const Constraint c : hull) {
      const EdgeRef e = samples::find_edge(t, c.a, c.b);
      ASSERT_FALSE(e.none());
      EXPECT_EQ(t.slot(e).from(e.side()), c.a) << "hull edges run counter-clockwise";
      EXPECT_TRUE(t.slot(e).n[e.side()].none());
    }
  }
}

/// Large enough for several blocks.
TEST(Carve, is_the_same_on_any_number_of_threads_numbers_included) {
  std::vector<Point> points = Frame().points;
  for (const Point p : samples::uniform_points(30'000, 4)) points.push_back({8 * p.x, 8 * p.y});
  const auto carved = [&](int threads) {
    Result<Delaunay> made = delaunay(points);
    Triangulation t = std::move(made->triangulation);
    std::vector<VertexId> vertex_of(points.size());
    for (VertexId v = 0; v < points.size(); ++v) vertex_of[made->input_of_vertex[v]] = v;
    std::vector<Constraint> constraints = Frame().constraints;
    for (Constraint& c : constraints) c = {vertex_of[c.a], vertex_of[c.b]};
    EXPECT_TRUE(insert_constraints(t, constraints));
    DomainRules rules;
    rules.holes = {{4.001, 4.003}};
    rules.region_seeds = {{0.501, 3.003}};
    (void)carve(t, rules, threads);
    EXPECT_EQ(samples::fault(t), "");
    EXPECT_NEAR(samples::twice_area(t), 2 * 60, 1e-9);
    return t;
  };
  const Triangulation expected = carved(1);
  for (const int threads : {2, 7}) {
    const Triangulation t = carved(threads);
    EXPECT_TRUE(std::ranges::equal(t.slots, expected.slots,
                                   [](const Slot& a, const Slot& b) { return a.v == b.v && a.n == b.n; }));
    EXPECT_EQ(t.region, expected.region);
  }
}

TEST(Carve, leaves_nothing_where_nothing_is_enclosed) {
  Triangulation t = delaunay_of(samples::lattice_points(3));
  (void)carve(t, {});
  EXPECT_TRUE(t.slots.empty());
}

}  // namespace
}  // namespace pardel::engine
