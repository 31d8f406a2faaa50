#include "../../../parallel/refinement/insertion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Box everywhere;

/// A triangulation and an Insertion for it.
struct InsertionScene {
  samples::Sample sample;
  Criteria criteria;
  Insertion insertion;

  explicit InsertionScene(const std::vector<Point>& points, std::vector<Constraint> constraints = {},
                          const Goal& goal = {}, double min_edge = 0)
      : sample(samples::triangulated(points, std::move(constraints))),
        criteria(goal, Placement::circumcentre, {}),
        insertion(sample.triangulation, criteria, min_edge) {}

  Triangulation& t() { return sample.triangulation; }
  Outcome insert(Point p, TriangleId first, const Box& box = everywhere) {
    return with_room([&] { return insertion.insert_in_face(p, first, box); });
  }
  Outcome split(Point p, EdgeRef e, Index segment) {
    return with_room([&] { return insertion.split_edge(p, e, segment, everywhere); });
  }
  /// Provides indices for one insertion, and removes the indices that it did not use.
  template <class Attempt>
  Outcome with_room(const Attempt& attempt) {
    const auto vertices = static_cast<Index>(t().points.size()), triangles = static_cast<Index>(t().slots.size());
    t().points.resize(vertices + 1U);
    t().origin.resize(vertices + 1U);
    t().slots.resize(triangles + 2U);
    FreeIndices free{IndexPool({{vertices, vertices + 1}}), IndexPool({{triangles, triangles + 2}})};
    insertion.start(free);
    const Outcome outcome = attempt();
    t().points.resize(vertices + 1 - free.vertices.left());
    t().origin.resize(vertices + 1 - free.vertices.left());
    t().slots.resize(triangles + 2 - free.triangles.left());
    return outcome;
  }
  /// A triangle whose open circumdisk contains p.
  TriangleId conflict(Point p) {
    for (TriangleId id = 0; id < t().slots.size(); ++id) {
      const auto& v = t().slots[id].v;
      if (checker::exactly::in_circle(t().points[v[0]], t().points[v[1]], t().points[v[2]], p) > 0) return id;
    }
    return no_index;
  }
  /// The triangle that contains p.
  TriangleId around(Point p) {
    for (TriangleId id = 0; id < t().slots.size(); ++id) {
      const Slot& slot = t().slots[id];
      bool inside = true;
      for (unsigned side = 0; side < 3; ++side)
        inside =
            inside && checker::exactly::orientation(t().points[slot.from(side)], t().points[slot.to(side)], p) >= 0;
      if (inside) return id;
    }
    return no_index;
  }
};

const std::vector<Point> corners_of_square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};

/// Makes the lower side of the square the border of a patch.
void lay_patch_below_square(InsertionScene& scene) {
  for (VertexId v = 0; v < 4; ++v)
    if (scene.t().points[v].y == 0) scene.t().origin[v] = border_vertex;
}

TEST(FreeIndices, suffice_for_one_vertex_and_two_triangles) {
  const auto suffice = [](Index vertices, Index triangles) {
    return FreeIndices{IndexPool({{5, 5 + vertices}}), IndexPool({{9, 9 + triangles}})}.suffice();
  };
  EXPECT_TRUE(suffice(1, 2));
  EXPECT_FALSE(suffice(0, 2));
  EXPECT_FALSE(suffice(1, 1));
}

TEST(Insertion, is_made_where_only_exact_arithmetic_finds_a_new_triangle_positive) {
  // The point lies 2^-53 above the middle of a side, less than the error of the area of the new triangle.
  InsertionScene scene({{0, 0}, {3, 1}, {0, 3}}, {}, {.min_angle_deg = 0});
  EXPECT_EQ(scene.insert({1.5, 0.5 + 0x1p-53}, 0), Outcome::inserted);
  EXPECT_EQ(samples::fault(scene.t()), "");
  EXPECT_EQ(scene.t().slots.size(), 3U);
  InsertionScene on_side({{0, 0}, {3, 1}, {0, 3}}, {}, {.min_angle_deg = 0});
  EXPECT_EQ(on_side.insert({1.5, 0.5}, 0), Outcome::encroaches);
}

TEST(InsertInFace, refuses_a_point_in_the_circumdisk_of_a_patch) {
  for (const double angle : {20.7, 30.0}) {
    InsertionScene scene(corners_of_square, {}, {.min_angle_deg = angle});
    lay_patch_below_square(scene);
    const double height = 4 / std::sqrt(3.0);  // sees the lower side at 120 degrees
    ASSERT_EQ(scene.insertion.try_in_face({4, height * 0.999}, scene.around({4, 2}), everywhere), Outcome::encroaches);
    EXPECT_TRUE(scene.t().on_border_of_patch(scene.insertion.blocker()));
    EXPECT_EQ(scene.insertion.try_in_face({4, height * 1.001}, scene.around({4, 2.5}), everywhere), Outcome::inserted);
  }
}

TEST(InsertInFace, refuses_a_point_that_makes_a_narrow_triangle_beside_a_patch) {
  InsertionScene scene(corners_of_square, {}, {.min_angle_deg = 33});
  lay_patch_below_square(scene);
  const double height = 4 * std::tan(33 * std::acos(-1) / 180);
  EXPECT_EQ(scene.insertion.try_in_face({4, height * 0.999}, scene.around({4, 2}), everywhere), Outcome::encroaches);
  EXPECT_EQ(scene.insertion.try_in_face({4, height * 1.001}, scene.around({4, 2.7}), everywhere), Outcome::inserted);
}

TEST(InsertInFace, rather_splits_a_segment_than_it_is_stopped_by_a_patch) {
  InsertionScene scene({{0, 0}, {8, 0}, {8, 2}, {0, 2}}, {}, {.min_angle_deg = 25});
  lay_patch_below_square(scene);
  ASSERT_EQ(scene.insertion.try_in_face({4, 1}, scene.around({4, 1}), everywhere), Outcome::encroaches);
  const EdgeRef blocker = scene.insertion.blocker();
  EXPECT_FALSE(scene.t().on_border_of_patch(blocker));
  EXPECT_EQ(scene.t().points[scene.t().slot(blocker).from(blocker.side())].y, 2);
}

TEST(InsertInFace, inserts_a_point_that_encroaches_on_nothing) {
  InsertionScene scene(corners_of_square);
  ASSERT_EQ(scene.insert({4, 4}, 0), Outcome::inserted);
  EXPECT_EQ(scene.t().points.size(), 5U);
  EXPECT_EQ(scene.t().origin.back(), interior_vertex);
  EXPECT_EQ(scene.t().slots.size(), 4U);
  EXPECT_EQ(scene.insertion.changed().size(), 4U);
  EXPECT_EQ(samples::fault(scene.t()), "");
}

TEST(InsertInFace, measures_the_new_triangles) {
  InsertionScene scene(samples::lattice_points(5));
  ASSERT_EQ(scene.insert({2.25, 2.375}, scene.conflict({2.25, 2.375})), Outcome::inserted);
  ASSERT_EQ(scene.insertion.measures().size(), scene.insertion.changed().size());
  for (std::size_t i = 0; i < scene.insertion.changed().size(); ++i) {
    const Shape shape(scene.t(), scene.t().slots[scene.insertion.changed()[i]]);
    EXPECT_EQ(scene.insertion.measures()[i].squared, shape.squared);
    EXPECT_EQ(scene.insertion.measures()[i].twice_area, shape.twice_area);
  }
}

TEST(InsertInFace, lists_the_new_triangles_that_break_a_bound_whatever_their_number) {
  const Goal goal{.min_angle_deg = 25, .max_area = 0.02};
  InsertionScene scene(samples::lattice_points(5), {}, goal);
  samples::Random random(1);
  std::set<std::size_t> sizes;
  std::size_t breaking = 0, all = 0;
  for (int round = 0; round < 400; ++round) {
    const Point p{random.uniform(0.5, 3.5), random.uniform(0.5, 3.5)};
    if (scene.insert(p, scene.conflict(p)) != Outcome::inserted) continue;
    const Insertion& insertion = scene.insertion;
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < insertion.changed().size(); ++i) {
      const Shape shape(scene.t(), scene.t().slots[insertion.changed()[i]]);
      EXPECT_EQ(insertion.measures()[i].squared, shape.squared);
      EXPECT_EQ(insertion.measures()[i].twice_area, shape.twice_area);
      if (scene.criteria.bad_shape(shape) || scene.criteria.too_large(shape)) expected.push_back(i);
    }
    EXPECT_TRUE(std::ranges::equal(insertion.breaking(), expected));
    sizes.insert(insertion.changed().size());
    breaking += expected.size();
    all += insertion.changed().size();
  }
  EXPECT_GT(sizes.size(), 4U) << "odd and even numbers of triangles";
  EXPECT_GT(breaking, all / 10);
  EXPECT_LT(breaking, all * 9 / 10);
}

/// The diametral circle of the bottom side of the square reaches up to (4, 4). The lens for 20.7 degrees does not.
TEST(InsertInFace, rejects_a_point_in_the_lens_of_a_segment_or_for_a_conforming_goal_in_its_circle) {
  const Point low{4, 0.5}, high{4, 3.5};
  for (const bool conforming : {false, true})
    for (const Point p : {low, high}) {
      InsertionScene scene(corners_of_square, {}, {.conforming = conforming});
      const Outcome outcome = scene.insert(p, scene.conflict(p));
      EXPECT_EQ(outcome, conforming || p == low ? Outcome::encroaches : Outcome::inserted);
      if (outcome != Outcome::encroaches) continue;
      const EdgeRef e = scene.insertion.blocker();
      const Slot& slot = scene.t().slot(e);
      EXPECT_EQ(slot.from(e.side()), 0U);
      EXPECT_EQ(slot.to(e.side()), 1U);
      EXPECT_EQ(scene.t().points.size(), 4U) << "the triangulation has not changed";
    }
}

TEST(InsertInFace, rejects_a_point_beyond_a_segment_and_returns_the_segment) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {4, 1}};
  InsertionScene scene(points);
  const Point circumcentre{4, -7.5};
  ASSERT_EQ(scene.insert(circumcentre, 0), Outcome::encroaches);
  const EdgeRef e = scene.insertion.blocker();
  EXPECT_EQ(scene.t().slot(e).apex(e.side()), 2U);
}

TEST(InsertInFace, refuses_a_point_outside_the_disk_of_its_first_triangle) {
  InsertionScene scene(samples::lattice_points(9));
  const TriangleId far = scene.around({7.5, 7.25});
  EXPECT_EQ(scene.insert({0.5, 0.25}, far), Outcome::refused);
}

TEST(InsertInFace, refuses_a_vertex) {
  InsertionScene scene(samples::lattice_points(3));
  for (TriangleId id = 0; id < scene.t().slots.size(); ++id) EXPECT_EQ(scene.insert({1, 1}, id), Outcome::refused);
}

TEST(InsertInFace, changes_nothing_outside_its_box) {
  InsertionScene scene(samples::lattice_points(9));
  const Point p{4.25, 4.5};
  const TriangleId first = scene.conflict(p);
  EXPECT_EQ(scene.insert(p, first, {4, 4, 5, 5}), Outcome::leaves_box) << "the box is half-open";
  EXPECT_EQ(scene.insert(p, first, {5, 4, 8, 8}), Outcome::leaves_box) << "p lies outside the box";
  EXPECT_EQ(scene.t().points.size(), 81U);
  EXPECT_EQ(scene.insert(p, first, {3, 3, 6.5, 6.5}), Outcome::inserted);
}

TEST(InsertInFace, inserts_no_point_that_is_not_finite) {
  InsertionScene scene(corners_of_square);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Point p : {Point{nan, 1}, Point{1, nan}, Point{infinity, 1}, Point{1, -infinity}})
    EXPECT_NE(scene.insert(p, 0), Outcome::inserted);
  EXPECT_EQ(scene.t().points.size(), 4U);
}

TEST(InsertInFace, keeps_the_minimum_distance_to_every_vertex) {
  InsertionScene scene(samples::lattice_points(5), {}, {.min_angle_deg = 0}, 0.75);
  const Point centre{2.5, 2.5};
  EXPECT_EQ(scene.insert(centre, scene.conflict(centre)), Outcome::too_close);
  InsertionScene lower(samples::lattice_points(5), {}, {.min_angle_deg = 0}, 0.7);
  EXPECT_EQ(lower.insert(centre, lower.conflict(centre)), Outcome::inserted);
}

TEST(SplitEdge, makes_two_constrained_halves_of_a_hull_edge_and_of_an_inner_one) {
  for (const Constraint c : {Constraint{0, 1}, Constraint{0, 2}}) {
    InsertionScene scene(corners_of_square, {{0, 2}});
    const EdgeRef e = samples::find_edge(scene.t(), c.a, c.b);
    const Point p{(corners_of_square[c.a].x + corners_of_square[c.b].x) / 2,
                  (corners_of_square[c.a].y + corners_of_square[c.b].y) / 2};
    ASSERT_EQ(scene.split(p, e, 3), Outcome::inserted);
    EXPECT_EQ(scene.t().origin.back(), origin_on_segment(3));
    EXPECT_EQ(samples::fault(scene.t()), "");
    for (const Index end : {c.a, c.b}) {
      const EdgeRef half = samples::find_edge(scene.t(), end, 4);
      ASSERT_FALSE(half.none());
      EXPECT_TRUE(scene.t().slot(half).n[half.side()].constrained());
    }
  }
}

TEST(SplitEdge, keeps_the_minimum_distance) {
  InsertionScene scene(corners_of_square, {}, {}, 4.5);
  EXPECT_EQ(scene.split({4, 0}, samples::find_edge(scene.t(), 0, 1), 0), Outcome::too_close);
  EXPECT_EQ(scene.t().points.size(), 4U);
}

TEST(SplitEdge, refuses_a_point_that_rounding_put_beyond_a_neighbour) {
  // The apex lies an ulp above the edge. The split point lies beyond a segment that leads to it.
  const double ulp = 0x1p-52;
  InsertionScene scene({{1, 1}, {3, 1}, {2.5, 1 + ulp}, {2, 9}}, {{0, 2}});
  const EdgeRef e = samples::find_edge(scene.t(), 0, 1);
  EXPECT_EQ(scene.split({2, 1 + ulp}, e, 0), Outcome::refused);
  EXPECT_EQ(scene.t().points.size(), 4U);
  EXPECT_EQ(scene.split({2, 1}, e, 0), Outcome::inserted);
  EXPECT_EQ(samples::fault(scene.t()), "");
}

/// Two triangles with apexes far away. Their disks reach only 0.05 beyond their common edge, which is split at a point
/// 0.2 beside it, as rounding may do far from the origin. This point lies outside the disk of one triangle: the new
/// edge to its apex is not Delaunay.
TEST(SplitEdge, flips_edges_where_rounding_put_the_point_outside_the_disk_of_a_triangle_at_the_edge) {
  const std::vector<Point> points{{-1, 0}, {1, 0}, {0, 20}, {30, 3}, {-30, 3}, {0, -20}, {30, -3}, {-30, -3}};
  for (const bool on_hull : {false, true})
    for (const double beside : {0.2, -0.2}) {
      if (on_hull && beside > 0) continue;
      InsertionScene scene({points.begin(), points.end() - (on_hull ? 3 : 0)}, {{0, 1}});
      ASSERT_EQ(samples::fault(scene.t()), "");
      const double area = samples::twice_area(scene.t());
      ASSERT_EQ(scene.split({0, beside}, samples::find_edge(scene.t(), 0, 1), 0), Outcome::inserted);
      EXPECT_TRUE(scene.insertion.has_flipped());
      EXPECT_TRUE(scene.insertion.measures().empty());
      EXPECT_EQ(samples::fault(scene.t()), "");
      EXPECT_NEAR(samples::twice_area(scene.t()), area + (on_hull ? 0.4 : 0), 1e-12);
      const auto added = static_cast<VertexId>(scene.t().points.size() - 1);
      for (const VertexId end : {0U, 1U}) {
        const EdgeRef half = samples::find_edge(scene.t(), end, added);
        ASSERT_FALSE(half.none());
        EXPECT_TRUE(scene.t().slot(half).n[half.side()].constrained());
      }
      const EdgeRef whole = samples::find_edge(scene.t(), 0, 1);
      ASSERT_FALSE(whole.none()) << "the triangle with the far apex is back";
      EXPECT_FALSE(scene.t().slot(whole).n[whole.side()].constrained());
    }
}

/// A corner far away sees a piece of a slanted segment at an angle that is smaller than the bend caused by rounding.
TEST(SplitEdge, leaves_the_triangulation_valid_where_rounding_bends_the_edge) {
  const Point far{654321.03, 4987654.28};
  InsertionScene scene({{654320.528, 4987654.303}, {654321.000307, 4987654.000437}, far, {654320.0, 4987653.5}},
                       {{0, 1}});
  VertexId a = 0, b = 1;
  for (int i = 0; i < 16; ++i) {
    const Point pa = scene.t().points[a], pb = scene.t().points[b];
    const Point middle{(pa.x + pb.x) / 2, (pa.y + pb.y) / 2};
    ASSERT_EQ(scene.split(middle, samples::find_edge(scene.t(), a, b), 0), Outcome::inserted);
    ASSERT_EQ(samples::fault(scene.t()), "") << "after split " << i;
    (i % 2 == 0 ? a : b) = static_cast<VertexId>(scene.t().points.size() - 1);
  }
}

/// A free segment with points in its diametral circle on both sides is not Delaunay. The disks of the triangles next to
/// it reach through it and around its ends.
TEST(FreeSegment, leaves_the_triangulation_valid_wherever_a_point_is_inserted_next_to_it) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    samples::Random random(seed);
    std::vector<Point> points{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}, {-1, 0}, {1, 0}};
    for (int i = 0; i < 6; ++i)
      points.push_back({random.uniform(-0.9, 0.9), random.uniform(0.15, 0.6) * (i % 2 == 0 ? 1 : -1)});
    InsertionScene scene(points, {{4, 5}});
    for (int i = 0; i < 40; ++i) {
      const Point p{random.uniform(-1.6, 1.6), random.uniform(-0.8, 0.8)};
      const std::size_t before = scene.t().points.size();
      const Outcome outcome = scene.insert(p, scene.around(p));
      EXPECT_TRUE(outcome == Outcome::inserted || outcome == Outcome::encroaches) << "seed " << seed;
      EXPECT_EQ(scene.t().points.size(), before + (outcome == Outcome::inserted ? 1 : 0));
      ASSERT_EQ(samples::fault(scene.t()), "") << "seed " << seed << ", point " << i;
    }
    EXPECT_NEAR(samples::twice_area(scene.t()), 2 * 256, 1e-9);
  }
}

/// Rounding produces such points far from the origin. The walk would reach the sliver at the edge a second time, around
/// the vertex.
TEST(SplitEdge, refuses_a_point_beyond_a_vertex_next_to_the_edge) {
  for (const double beyond : {0.0011, 0.002, 0.01}) {
    InsertionScene scene({{0, 0}, {8, 0}, {4, 10}, {4, 0.001}});
    EXPECT_EQ(scene.split({4, beyond}, samples::find_edge(scene.t(), 0, 1), 0), Outcome::refused);
    EXPECT_EQ(samples::fault(scene.t()), "");
  }
}

/// Points of a bent chain, of which three form a sliver below the edge that is split; all other points are far away.
/// Rounding has put the split point on or beyond the line of the next edge of the chain.
TEST(SplitEdge, makes_room_where_vertices_of_the_chain_form_a_sliver) {
  for (const double left : {1.0, -1.0})
    for (const double y : {0.6, 0.625, 0.66}) {
      InsertionScene scene({{0, 0}, {left * 8, 1}, {left * 12, 1.4}, {left * 50, -4000}, {left * 6, 50}},
                           {{0, 1}, {1, 2}});
      ASSERT_FALSE(samples::find_edge(scene.t(), 0, 2).none()) << "no sliver";
      ASSERT_EQ(scene.split({left * 4, y}, samples::find_edge(scene.t(), 0, 1), 0), Outcome::inserted);
      EXPECT_EQ(samples::fault(scene.t()), "");
      EXPECT_EQ(scene.t().points.size(), 6U);
      for (const VertexId end : {0U, 1U}) EXPECT_FALSE(samples::find_edge(scene.t(), end, 5).none());
    }
}

TEST(FreeSegment, leaves_the_triangulation_valid_wherever_it_is_split) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    samples::Random random(seed);
    std::vector<Point> points{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}, {-1, 0}, {1, 0}};
    for (int i = 0; i < 8; ++i)
      points.push_back({random.uniform(-1.5, 1.5), random.uniform(0.01, 0.3) * (i % 2 == 0 ? 1 : -1)});
    InsertionScene scene(points, {{4, 5}}, {});
    VertexId from = 4;
    for (const double x : {-0.5, 0.0, 0.25, 0.75}) {
      const EdgeRef e = samples::find_edge(scene.t(), from, 5);
      ASSERT_FALSE(e.none());
      ASSERT_EQ(scene.split({x, 0}, e, 0), Outcome::inserted) << "seed " << seed;
      ASSERT_EQ(samples::fault(scene.t()), "") << "seed " << seed;
      from = static_cast<VertexId>(scene.t().points.size() - 1);
    }
  }
}

}  // namespace
}  // namespace pardel::engine
