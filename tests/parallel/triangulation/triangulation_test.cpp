#include "../../../parallel/triangulation/triangulation.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

TEST(EdgeRef, holds_the_largest_triangle_each_side_and_the_constraint) {
  for (const TriangleId triangle : {TriangleId{0}, TriangleId{77}, max_engine_triangles - 1})
    for (unsigned side = 0; side < 3; ++side)
      for (const bool constrained : {false, true}) {
        const EdgeRef e(triangle, side, constrained);
        EXPECT_FALSE(e.none());
        EXPECT_EQ(e.triangle(), triangle);
        EXPECT_EQ(e.side(), side);
        EXPECT_EQ(e.constrained(), constrained);
        EXPECT_EQ(e.with_constraint(!constrained), EdgeRef(triangle, side, !constrained));
      }
}

TEST(EdgeRef, that_refers_to_nothing_counts_as_constrained) {
  EXPECT_TRUE(EdgeRef().none());
  EXPECT_TRUE(EdgeRef().constrained());
  EXPECT_TRUE(EdgeRef().with_constraint(false).none());
}

TEST(Slot, has_sides_that_run_counter_clockwise) {
  const Slot slot{{10, 20, 30}, {}};
  EXPECT_EQ(slot.apex(0), 10U);
  EXPECT_EQ(slot.from(0), 20U);
  EXPECT_EQ(slot.to(0), 30U);
  EXPECT_EQ(slot.from(2), 10U);
  EXPECT_EQ(slot.corner_of(10), 0U);
  EXPECT_EQ(slot.corner_of(30), 2U);
}

TEST(Slot, is_a_ghost_triangle_if_any_corner_is_the_vertex_at_infinity) {
  const Slot finite{{0, 1, 2}, {}};
  EXPECT_FALSE(finite.is_ghost());
  for (const unsigned corner : {0, 1, 2}) {
    Slot slot = finite;
    slot.v[corner] = ghost;
    EXPECT_TRUE(slot.is_ghost()) << corner;
  }
}

TEST(Triangulation, constrains_an_edge_on_both_sides) {
  samples::Sample sample = samples::triangulated({{0, 0}, {2, 0}, {2, 2}, {0, 3}});
  Triangulation& t = sample.triangulation;
  ASSERT_EQ(t.slots.size(), 2U);
  unsigned side = 0;
  while (t.slots[0].n[side].none()) ++side;
  EXPECT_FALSE(t.slots[0].n[side].constrained());
  t.constrain(EdgeRef(0, side));
  EXPECT_TRUE(t.slots[0].n[side].constrained());
  EXPECT_TRUE(t.slots[1].n[t.slots[0].n[side].side()].constrained());
  EXPECT_EQ(samples::fault(t), "");
}

TEST(Triangulation, has_borders_of_patches_only_where_no_triangle_lies_beyond) {
  samples::Sample sample = samples::triangulated({{0, 0}, {2, 0}, {2, 2}, {0, 3}});
  Triangulation& t = sample.triangulation;
  const auto borders = [&] {
    int found = 0;
    for (TriangleId id = 0; id < t.slots.size(); ++id)
      for (unsigned side = 0; side < 3; ++side) found += t.on_border_of_patch(EdgeRef(id, side)) ? 1 : 0;
    return found;
  };
  EXPECT_EQ(borders(), 0);
  for (const VertexId v : {0, 1, 2}) t.origin[v] = border_vertex;
  EXPECT_EQ(borders(), 2) << "an edge needs two such ends";
  t.origin[3] = border_vertex;
  EXPECT_EQ(borders(), 4) << "not the diagonal";
}

TEST(Triangulation, moves_a_triangle_and_updates_its_neighbours) {
  samples::Sample sample = samples::triangulated(samples::lattice_points(4));
  Triangulation& t = sample.triangulation;
  const auto before = samples::triples(t);
  const auto last = static_cast<TriangleId>(t.slots.size());
  t.slots.resize(last + 1U);
  t.move_triangle(3, last);
  t.move_triangle(last - 1, 3);
  t.move_triangle(last, last - 1);
  t.slots.resize(last);
  EXPECT_EQ(samples::fault(t), "");
  EXPECT_EQ(samples::triples(t), before);
}

}  // namespace
}  // namespace pardel::engine
