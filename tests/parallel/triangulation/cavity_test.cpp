// The cavity is the set of triangles whose open circumdisk contains the point. Its boundary is one closed walk,
// counter-clockwise.
#include "../../../parallel/triangulation/cavity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <tuple>

#include "../../../parallel/construction/delaunay.hpp"
#include "../../../parallel/triangulation/paired_disk_query.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

bool is_hit(const Triangulation& t, TriangleId id, Point p) {
  const auto& v = t.slots[id].v;
  return checker::exactly::in_circle(t.points[v[0]], t.points[v[1]], t.points[v[2]], p) > 0;
}

/// True if p lies in the triangle or on its boundary.
bool holds(const Triangulation& t, TriangleId id, Point p) {
  const Slot& slot = t.slots[id];
  for (unsigned side = 0; side < 3; ++side)
    if (checker::exactly::orientation(t.points[slot.from(side)], t.points[slot.to(side)], p) < 0) return false;
  return true;
}

/// A query that uses exact arithmetic, one triangle at a time.
struct ExactQuery {
  const Triangulation& t;
  Point p;
  bool owns_all = true;

  [[nodiscard]] bool is_own(VertexId) const { return owns_all; }
  [[nodiscard]] Corner corner(VertexId) const { return {}; }
  [[nodiscard]] bool behind(EdgeRef e) const { return is_hit(t, e.triangle(), p); }
  [[nodiscard]] InDisks first_and_behind(const Slot& first, const std::array<Corner, 3>&, EdgeRef e) const {
    return InDisks::of(
        checker::exactly::in_circle(t.points[first.v[0]], t.points[first.v[1]], t.points[first.v[2]], p) > 0,
        behind(e));
  }
  [[nodiscard]] DisksAndCorners both(Corner, Corner, Corner, EdgeRef right, EdgeRef left) const {
    return {InDisks::of(behind(right), behind(left)), {}};
  }
};

std::vector<TriangleId> sorted(std::span<const TriangleId> ids) {
  std::vector<TriangleId> result(ids.begin(), ids.end());
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<TriangleId> all_in_conflict(const Triangulation& t, Point p) {
  std::vector<TriangleId> ids;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (is_hit(t, id, p)) ids.push_back(id);
  return ids;
}

/// True if both have the same triangles, the same boundary in the same order, and the same constrained edges.
bool same(const Cavity& a, const Cavity& b) {
  const auto key = [](const CavityEdge& e) { return std::tuple(e.from, e.inner.triangle(), e.inner.side()); };
  return std::ranges::equal(a.triangles(), b.triangles()) &&
         std::ranges::equal(a.boundary(), b.boundary(), {}, key, key) && a.left_count() == b.left_count() &&
         a.touches_constraint() == b.touches_constraint();
}

void expect_boundary(const Triangulation& t, const Cavity& cavity, Point p) {
  for (std::size_t i = 0; i < cavity.boundary().size(); ++i) {
    const CavityEdge& edge = cavity.boundary()[i];
    const Slot& slot = t.slot(edge.inner);
    EXPECT_EQ(slot.from(edge.inner.side()), edge.from);
    EXPECT_EQ(slot.to(edge.inner.side()), cavity.to(i)) << "the boundary is a closed walk";
    EXPECT_EQ(slot.n[edge.inner.side()], edge.outer);
    EXPECT_EQ(std::count(cavity.triangles().begin(), cavity.triangles().end(), edge.inner.triangle()), 1);
    EXPECT_GT(checker::exactly::orientation(t.points[edge.from], t.points[cavity.to(i)], p), 0) << "p sees every edge";
  }
}

TriangleId fresh_slot(Triangulation& t) {
  t.slots.push_back({});
  return static_cast<TriangleId>(t.slots.size() - 1);
}

/// A random point within the hull that is not a vertex.
Point inner_point(const Triangulation& t, Random& random) {
  const Slot& slot = t.slots[random.below(t.slots.size())];
  const double f = random.uniform(0.1, 0.5), g = random.uniform(0.1, 0.4);
  const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
  return {a.x + f * (b.x - a.x) + g * (c.x - a.x), a.y + f * (b.y - a.y) + g * (c.y - a.y)};
}

/// A triangulation, a point, and the triangles (at least one) whose disk contains the point.
struct Case {
  const Triangulation& t;
  Point p;
  std::vector<TriangleId> conflict;
  TriangleId first;  ///< any one of them
};

/// Checks 100 points of each family. Skips points that rounding moved outside the hull and that lie in no disk; other
/// points may lie outside the hull.
void for_many_points(std::uint64_t seed, const std::function<void(const Case&)>& check) {
  std::size_t rounds = 0, cases = 0;
  for (const samples::Family& family : samples::families(100, seed)) {
    SCOPED_TRACE(family.name);
    Random random(seed + 1);
    const Triangulation t = samples::triangulated(family.points).triangulation;
    for (int round = 0; round < 100; ++round) {
      ++rounds;
      const Point p = inner_point(t, random);
      std::vector<TriangleId> conflict = all_in_conflict(t, p);
      if (conflict.empty()) continue;
      ++cases;
      const TriangleId first = conflict[random.below(conflict.size())];
      check({t, p, std::move(conflict), first});
    }
  }
  EXPECT_GT(cases, rounds * 9 / 10);
}

TEST(Cavity, is_the_set_of_triangles_whose_disk_contains_the_point) {
  Cavity cavity;
  int inside = 0;
  for_many_points(1, [&](const Case& c) {
    if (std::ranges::none_of(c.conflict, [&](TriangleId id) { return holds(c.t, id, c.p); })) return;
    ++inside;
    ASSERT_EQ(cavity.find(c.t, c.first, ExactQuery{c.t, c.p}), Walk::complete);
    EXPECT_EQ(sorted(cavity.triangles()), c.conflict);
    EXPECT_EQ(cavity.boundary().size(), c.conflict.size() + 2) << "the dual graph of the cavity is a tree";
    expect_boundary(c.t, cavity, c.p);
  });
  EXPECT_GT(inside, 500);
}

TEST(Cavity, retriangulated_again_and_again_leaves_a_delaunay_triangulation) {
  Random random(3);
  Triangulation t = samples::triangulated(samples::lattice_points(5)).triangulation;
  Cavity cavity;
  for (int round = 0; round < 300; ++round) {
    const Point p = inner_point(t, random);
    const std::vector<TriangleId> conflict = all_in_conflict(t, p);
    ASSERT_EQ(cavity.find(t, conflict.front(), ExactQuery{t, p}), Walk::complete);
    const std::size_t before = t.slots.size();
    t.points.push_back(p);
    const auto fan =
        retriangulate(t, cavity, static_cast<VertexId>(t.points.size() - 1), [&] { return fresh_slot(t); });
    EXPECT_EQ(t.slots.size(), before + 2) << "no slot is lost";
    ASSERT_EQ(samples::fault(t), "");
    for (const TriangleId id : fan) EXPECT_EQ(t.slots[id].v[0], t.points.size() - 1);
  }
  EXPECT_NEAR(samples::twice_area(t), 2 * 16, 1e-12);
}

TEST(Cavity, stops_at_a_foreign_triangle) {
  const Triangulation t = samples::triangulated(samples::lattice_points(6)).triangulation;
  const Point p{2.4, 2.3};
  const std::vector<TriangleId> conflict = all_in_conflict(t, p);
  ASSERT_GE(conflict.size(), 2U);
  Cavity cavity;
  EXPECT_EQ(cavity.find(t, conflict.front(), ExactQuery{t, p, /*owns_all=*/false}), Walk::foreign);
}

TEST(Cavity, is_not_found_from_a_triangle_whose_disk_does_not_contain_the_point) {
  const Triangulation t = samples::triangulated(samples::lattice_points(6)).triangulation;
  const Point p{2.4, 2.3};
  const std::vector<TriangleId> conflict = all_in_conflict(t, p);
  Cavity cavity;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const bool is_in = std::count(conflict.begin(), conflict.end(), id) > 0;
    EXPECT_EQ(cavity.find(t, id, ExactQuery{t, p}), is_in ? Walk::complete : Walk::elsewhere);
    EXPECT_EQ(cavity.find(t, id, PairedDiskQuery{t, {p.x, p.y}, {}}), is_in ? Walk::complete : Walk::elsewhere);
  }
}

TEST(Cavity, is_the_same_by_pairs_of_triangles_as_by_exact_arithmetic) {
  Cavity by_pairs, exact;
  for_many_points(4, [&](const Case& c) {
    ASSERT_EQ(exact.find(c.t, c.first, ExactQuery{c.t, c.p}), Walk::complete);
    ASSERT_EQ(by_pairs.find(c.t, c.first, PairedDiskQuery{c.t, {c.p.x, c.p.y}, {}}), Walk::complete);
    EXPECT_TRUE(same(by_pairs, exact));
    for (std::size_t i = 0; i < by_pairs.boundary().size(); ++i) {
      const Corner corner = by_pairs.corner(i);
      const Point v = c.t.points[by_pairs.boundary()[i].from];
      EXPECT_EQ(corner.at[0], v.x - c.p.x) << "the cavity keeps the corners that the query returned";
      EXPECT_EQ(corner.at[1], v.y - c.p.y);
      EXPECT_EQ(corner.square, corner.at[0] * corner.at[0] + corner.at[1] * corner.at[1]);
    }
  });
}

TEST(Cavity, of_a_split_edge_and_at_constrained_edges_is_the_same_by_pairs_as_by_exact_arithmetic) {
  Random random(6);
  const std::vector<Point> points = samples::uniform_points(200, 7);
  const Triangulation t = samples::triangulated(points, samples::random_constraints(points, 400, random)).triangulation;
  Cavity by_pairs, exact;
  int splits = 0, at_constraints = 0;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
    const Point centroid{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
    const PairedDiskQuery pairs{t, {centroid.x, centroid.y}, {}};
    ASSERT_EQ(by_pairs.find(t, id, pairs), exact.find(t, id, ExactQuery{t, centroid}));
    EXPECT_TRUE(same(by_pairs, exact));
    at_constraints += by_pairs.touches_constraint() ? 1 : 0;
    for (unsigned side = 0; side < 3; ++side) {
      if (!slot.n[side].constrained()) continue;
      const Point from = t.points[slot.from(side)], to = t.points[slot.to(side)];
      const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
      const Walk walk = exact.find_on_edge(t, EdgeRef(id, side), ExactQuery{t, middle});
      ASSERT_EQ(by_pairs.find_on_edge(t, EdgeRef(id, side), PairedDiskQuery{t, {middle.x, middle.y}, {}}), walk);
      EXPECT_TRUE(same(by_pairs, exact));
      ++splits;
    }
  }
  EXPECT_GT(splits, 50);
  EXPECT_GT(at_constraints, 50);
}

TEST(Cavity, stays_in_the_box) {
  const Triangulation t = samples::triangulated(samples::lattice_points(6)).triangulation;
  const Point p{2.4, 2.3};
  Cavity cavity;
  const TriangleId first = all_in_conflict(t, p).front();
  EXPECT_EQ(cavity.find(t, first, PairedDiskQuery{t, {p.x, p.y}, {2, 2, 3.5, 3.5}}), Walk::complete);
  EXPECT_EQ(cavity.find(t, first, PairedDiskQuery{t, {p.x, p.y}, {2, 2, 3, 3}}), Walk::foreign);
}

TEST(Cavity, ends_at_constrained_edges) {
  // The diagonal of a square is constrained. p is close to the diagonal, but its cavity does not extend across it.
  const std::vector<Point> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Triangulation t = samples::triangulated(points, {{0, 2}}).triangulation;
  const Point p{2.25, 2};
  EXPECT_EQ(all_in_conflict(t, p).size(), 2U);
  const EdgeRef diagonal = samples::find_edge(t, 0, 2);
  const TriangleId below = checker::exactly::orientation(points[0], points[2], p) < 0
                               ? samples::find_edge(t, 2, 0).triangle()
                               : diagonal.triangle();
  Cavity cavity;
  ASSERT_EQ(cavity.find(t, below, ExactQuery{t, p}), Walk::complete);
  EXPECT_EQ(cavity.triangles().size(), 1U);
  EXPECT_EQ(cavity.boundary().size(), 3U);
}

TEST(Cavity, of_a_split_edge_is_closed_inside_and_open_at_the_hull) {
  const std::vector<Point> points = samples::lattice_points(5);
  for (const auto& [u, v, inside] : {std::tuple{6U, 7U, true}, std::tuple{0U, 1U, false}, std::tuple{4U, 9U, false}}) {
    Triangulation t = samples::triangulated(points, {{u, v}}).triangulation;
    const EdgeRef e = samples::find_edge(t, u, v);
    const Point p{(points[u].x + points[v].x) / 2, (points[u].y + points[v].y) / 2};
    Cavity cavity;
    ASSERT_EQ(cavity.find_on_edge(t, e, ExactQuery{t, p}), Walk::complete);
    EXPECT_TRUE(cavity.splits_edge());
    EXPECT_EQ(cavity.open(), !inside);
    EXPECT_EQ(sorted(cavity.triangles()), all_in_conflict(t, p));
    EXPECT_EQ(cavity.boundary().size(), cavity.triangles().size() + (inside ? 2 : 1));
    EXPECT_EQ(cavity.boundary().front().from, t.slot(e).to(e.side())) << "it starts at the end of the edge";
    EXPECT_EQ(cavity.to(cavity.left_count() - 1), t.slot(e).from(e.side()));
    expect_boundary(t, cavity, p);

    t.points.push_back(p);
    (void)retriangulate(t, cavity, static_cast<VertexId>(t.points.size() - 1), [&] { return fresh_slot(t); });
    EXPECT_EQ(samples::fault(t), "");
    EXPECT_TRUE(samples::find_edge(t, u, v).none());
    for (const Index end : {u, v}) {
      const EdgeRef half = samples::find_edge(t, end, static_cast<Index>(points.size()));
      ASSERT_FALSE(half.none());
      EXPECT_TRUE(t.slot(half).n[half.side()].constrained());
    }
    EXPECT_EQ(samples::twice_area(t), 2 * 16);
  }
}

TEST(Cavity, gives_each_side_of_a_split_edge_its_own_region) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  Triangulation t = samples::triangulated(points, {{0, 2}}).triangulation;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const auto& v = t.slots[id].v;
    t.region.push_back(std::find(v.begin(), v.end(), 1U) != v.end() ? 7 : 9);
  }
  const EdgeRef e = samples::find_edge(t, 0, 2);
  Cavity cavity;
  ASSERT_EQ(cavity.find_on_edge(t, e, ExactQuery{t, {2, 2}}), Walk::complete);
  t.points.push_back({2, 2});
  const auto allocate = [&] {
    t.region.push_back(no_index);
    return fresh_slot(t);
  };
  (void)retriangulate(t, cavity, 4, allocate);
  ASSERT_EQ(t.slots.size(), 4U);
  for (TriangleId id = 0; id < 4; ++id) {
    const auto& v = t.slots[id].v;
    EXPECT_EQ(t.region[id], std::find(v.begin(), v.end(), 1U) != v.end() ? 7U : 9U);
  }
}

}  // namespace
}  // namespace pardel::engine
