// Tests the insertion of single points. delaunay_test.cpp tests whole triangulations.
#include "../../../parallel/construction/bowyer_watson.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

struct Insertion {
  Triangulation t = samples::delaunay_of(samples::lattice_points(9));
  BowyerWatson worker{t};

  /// Inserts p in the box; the walk starts at a triangle near the corner (1, 1) of the lattice.
  Inserted insert(Point p, const Box& box) {
    TriangleId near = 0;
    while (t.slots[near].is_ghost() || !std::ranges::all_of(t.slots[near].v, [&](VertexId v) {
             return (Box{0, 0, 3, 3}).contains_half_open(t.points[v]);
           }))
      ++near;
    worker.start(box, near);
    const auto fresh = static_cast<TriangleId>(t.slots.size());
    t.points.push_back(p);
    t.slots.resize(fresh + 2U);
    const Inserted inserted = worker.insert(static_cast<VertexId>(t.points.size() - 1), fresh);
    if (inserted != Inserted::yes) {
      t.points.resize(t.points.size() - 1);
      t.slots.resize(fresh);
    }
    return inserted;
  }
};

TEST(BowyerWatson, inserts_a_point_inside_an_edge_or_beyond_the_hull) {
  Insertion insertion;
  for (const Point p : {Point{4.3, 5.6}, Point{3.5, 2}, Point{7, 0.5}, Point{2.5, 0}, Point{12, 3}, Point{-5, -5}}) {
    EXPECT_EQ(insertion.insert(p, Box{}), Inserted::yes);
    EXPECT_EQ(samples::fault(insertion.t), "") << p.x << ' ' << p.y;
    EXPECT_EQ(insertion.t.slots.size(), 2 * insertion.t.points.size() - 2);
  }
}

TEST(BowyerWatson, reports_a_point_that_is_a_vertex_already) {
  Insertion insertion;
  EXPECT_EQ(insertion.insert({3, 4}, Box{}), Inserted::duplicate);
  EXPECT_EQ(insertion.insert({0, 0}, Box{}), Inserted::duplicate);
}

/// A vertex is an end of two hull edges. It lies on their lines, and so on the border of their outer half-planes.
TEST(BowyerWatson, reports_a_point_that_is_a_vertex_of_the_hull_whatever_the_directions_of_its_edges) {
  const std::vector<Point> hull{{4, 0}, {7, 2}, {8, 5}, {5, 8}, {2, 7}, {0, 3}};
  for (const Point p : hull) {
    Triangulation t = samples::delaunay_of(hull);
    const auto fresh = static_cast<TriangleId>(t.slots.size());
    t.points.push_back(p);
    t.slots.resize(fresh + 2U);
    for (TriangleId start = 0; start < fresh; ++start) {
      if (t.slots[start].is_ghost()) continue;
      BowyerWatson worker(t);
      worker.start(Box{}, start);
      EXPECT_EQ(worker.insert(static_cast<VertexId>(hull.size()), fresh), Inserted::duplicate) << p.x << ' ' << p.y;
    }
  }
}

TEST(BowyerWatson, changes_nothing_if_the_insertion_leaves_the_box) {
  Insertion insertion;
  const Box box{0, 0, 4.5, 4.5};
  const auto before = samples::triples(insertion.t);
  EXPECT_EQ(insertion.insert({6.3, 6.4}, box), Inserted::leaves_box) << "the point lies outside";
  EXPECT_EQ(insertion.insert({4.3, 2.4}, box), Inserted::leaves_box) << "a triangle of the cavity leaves the box";
  EXPECT_EQ(insertion.insert({2.5, -1}, box), Inserted::leaves_box) << "the vertex at infinity is in no bounded box";
  EXPECT_EQ(samples::triples(insertion.t), before);
  EXPECT_EQ(insertion.insert({2.3, 2.4}, box), Inserted::yes);
  EXPECT_EQ(samples::fault(insertion.t), "");
}

TEST(BowyerWatson, ends_its_walk_before_the_first_triangle_that_leaves_the_box) {
  Insertion insertion;
  const Box left{-1, -1, 4.5, 9};
  EXPECT_EQ(insertion.insert({7.25, 3.5}, left), Inserted::leaves_box);
  EXPECT_EQ(insertion.insert({3.25, 6.5}, left), Inserted::yes);
  const auto fresh = static_cast<VertexId>(insertion.t.points.size() - 1);
  for (const Slot& slot : insertion.t.slots) {
    if (std::ranges::find(slot.v, fresh) == slot.v.end()) continue;
    for (const VertexId v : slot.v) EXPECT_TRUE(left.contains_half_open(insertion.t.points[v]));
  }
}

}  // namespace
}  // namespace pardel::engine
