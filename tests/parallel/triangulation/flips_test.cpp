#include "../../../parallel/triangulation/flips.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/arithmetic/predicates.hpp"
#include "../../../parallel/triangulation/in_circumdisk.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

/// A quadrilateral whose Delaunay diagonal is 1-3.
const std::vector<Point> kite{{0, 0}, {4, -1}, {8, 0}, {4, 1}};

TEST(Flip, replaces_a_diagonal_by_the_other_one) {
  Triangulation t = samples::triangulated(kite).triangulation;
  const EdgeRef diagonal = samples::find_edge(t, 1, 3);
  ASSERT_FALSE(diagonal.none());
  const EdgeRef across = t.slot(diagonal).n[diagonal.side()];
  flip(t, diagonal);
  EXPECT_TRUE(samples::find_edge(t, 1, 3).none());
  EXPECT_EQ(samples::twice_area(t), 16);
  const EdgeRef here(diagonal.triangle(), 1), there(across.triangle(), 1);
  EXPECT_EQ(t.slot(here).n[1], there);
  EXPECT_EQ(t.slot(there).n[1], here);
  EXPECT_EQ(std::min(t.slot(here).from(1), t.slot(here).to(1)), 0U);
  EXPECT_EQ(std::max(t.slot(here).from(1), t.slot(here).to(1)), 2U);
}

TEST(Flip, of_a_delaunay_diagonal_makes_an_edge_that_is_locally_delaunay_only_if_it_is_constrained) {
  Triangulation t = samples::triangulated(kite).triangulation;
  const EdgeRef diagonal = samples::find_edge(t, 1, 3);
  EXPECT_TRUE(delaunay_across(t, diagonal));
  flip(t, diagonal);
  const EdgeRef flipped(diagonal.triangle(), 1);
  EXPECT_FALSE(delaunay_across(t, flipped));
  EXPECT_FALSE(locally_delaunay(t, flipped));
  const EdgeRef across = t.slot(flipped).n[1];
  EXPECT_TRUE(in_circumdisk(t, t.slot(flipped), t.points[t.slot(across).apex(1)]));
  t.constrain(flipped);
  EXPECT_FALSE(delaunay_across(t, flipped));
  EXPECT_TRUE(locally_delaunay(t, flipped)) << "a constrained edge";
}

TEST(RestoreDelaunay, lists_the_triangle_of_the_suspect_edge_before_the_one_across) {
  for (const bool other_side : {false, true}) {
    Triangulation t = samples::triangulated(kite).triangulation;
    const EdgeRef diagonal = samples::find_edge(t, 1, 3);
    const EdgeRef across = t.slot(diagonal).n[diagonal.side()];
    flip(t, diagonal);
    const EdgeRef suspect(other_side ? across.triangle() : diagonal.triangle(), 1);
    std::vector<TriangleId> changed;
    restore_delaunay(t, {suspect}, changed);
    const TriangleId beyond = other_side ? diagonal.triangle() : across.triangle();
    EXPECT_EQ(changed, (std::vector{suspect.triangle(), beyond}));
  }
}

/// Disturbs a Delaunay triangulation by random flips, then restores it.
TEST(RestoreDelaunay, undoes_random_flips) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    samples::Random random(seed);
    Triangulation t = samples::triangulated(samples::uniform_points(200, seed)).triangulation;
    const auto expected = samples::triples(t);
    for (int flips = 0; flips < 300;) {
      const EdgeRef e(random.below(t.slots.size()), static_cast<unsigned>(random.below(3)));
      const EdgeRef across = t.slot(e).n[e.side()];
      if (across.none()) continue;
      const Point p = t.points[t.slot(e).apex(e.side())], q = t.points[t.slot(across).apex(across.side())];
      const Point from = t.points[t.slot(e).from(e.side())], to = t.points[t.slot(e).to(e.side())];
      if (!(orient2d(p, from, q) > 0 && orient2d(p, q, to) > 0)) continue;  // not strictly convex
      flip(t, e);
      ++flips;
    }
    EXPECT_NE(samples::triples(t), expected);
    std::vector<EdgeRef> suspects;
    for (TriangleId id = 0; id < t.slots.size(); ++id)
      for (unsigned side = 0; side < 3; ++side)
        if (!t.slots[id].n[side].none()) suspects.push_back(EdgeRef(id, side));
    std::vector<TriangleId> changed;
    restore_delaunay(t, suspects, changed);
    EXPECT_FALSE(changed.empty());
    EXPECT_EQ(samples::fault(t), "");
    EXPECT_EQ(samples::triples(t), expected);
  }
}

}  // namespace
}  // namespace pardel::engine
