// Tests carving: it determines which triangles remain, and the region of each.
#include "../../../parallel/construction/carve.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/construction/delaunay.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::delaunay_of;

/// A square of side 8 around a square of side 2, which may be a hole; and a crack that goes inwards from the outline.
struct Frame {
  std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {3, 3}, {5, 3}, {5, 5}, {3, 5}, {0, 4}, {1, 4}};
  std::vector<Constraint> constraints{{0, 1}, {1, 2}, {2, 3}, {3, 8}, {8, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {8, 9}};

  [[nodiscard]] Triangulation constrained() const {
    Triangulation t = delaunay_of(points);
    EXPECT_TRUE(insert_constraints(t, constraints));
    return t;
  }
};

TEST(Carve, keeps_all_triangles_inside_the_outline) {
  Triangulation t = Frame().constrained();
  EXPECT_TRUE(carve(t, {}).empty());
  EXPECT_EQ(samples::fault(t), "");
  EXPECT_EQ(samples::twice_area(t), 2 * 64);
  EXPECT_TRUE(t.region.empty());
}

TEST(Carve, removes_holes) {
  Triangulation t = Frame().constrained();
  DomainRules rules;
  rules.holes = {{4, 4}};
  (void)carve(t, rules);
  EXPECT_EQ(samples::fault(t), "");
  EXPECT_EQ(samples::twice_area(t), 2 * 60);
}

TEST(Carve, removes_a_hole_on_both_sides_of_a_crack) {
  Triangulation t = Frame().constrained();
  DomainRules rules;
  rules.holes = {{0.5, 3}};
  (void)carve(t, rules);
  EXPECT_EQ(samples::twice_area(t), 2 * 4);
}

TEST(Carve, labels_a_region_on_both_sides_of_a_crack) {
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

/// The triangulation is large enough for several blocks of triangles.
TEST(Carve, gives_the_same_numbering_on_any_number_of_threads) {
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

TEST(Carve, removes_all_triangles_if_no_segment_encloses_an_area) {
  Triangulation t = delaunay_of(samples::lattice_points(3));
  (void)carve(t, {});
  EXPECT_TRUE(t.slots.empty());
}

}  // namespace
}  // namespace pardel::engine
