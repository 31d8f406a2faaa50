// The rule for stale entries: after an insertion exactly the entries of the triangles that it destroyed are stale.
#include "../../../parallel/refinement/queued_triangle.hpp"

#include <gtest/gtest.h>

#include <array>

#include "../../../parallel/triangulation/cavity.hpp"
#include "../../../parallel/triangulation/paired_disk_query.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

std::vector<QueuedTriangle> entries_for_all(const Triangulation& t) {
  std::vector<QueuedTriangle> entries;
  for (TriangleId id = 0; id < t.slots.size(); ++id) entries.push_back(QueuedTriangle::now(t, EdgeRef(id, id % 3)));
  return entries;
}

/// The centroid of a random triangle.
Point some_point(const Triangulation& t, samples::Random& random) {
  const auto [a, b, c] = t.slots[random.below(t.slots.size())].v;
  return {(t.points[a].x + t.points[b].x + t.points[c].x) / 3, (t.points[a].y + t.points[b].y + t.points[c].y) / 3};
}

TEST(QueuedTriangle, is_current_until_an_insertion_destroys_the_triangle) {
  samples::Random random(1);
  Triangulation t = samples::triangulated(samples::uniform_points(50, 2)).triangulation;
  Cavity cavity;
  for (int round = 0; round < 100; ++round) {
    const std::vector<QueuedTriangle> entries = entries_for_all(t);
    std::vector<std::array<VertexId, 3>> before;
    for (const Slot& slot : t.slots) before.push_back(slot.v);
    const Point p = some_point(t, random);
    const PairedDiskQuery query{t, {p.x, p.y}, {}};
    for (TriangleId first = 0; cavity.find(t, first, query) == Walk::elsewhere;) ++first;
    t.points.push_back(p);
    (void)retriangulate(t, cavity, static_cast<VertexId>(t.points.size() - 1), [&] {
      t.slots.push_back({});
      return static_cast<TriangleId>(t.slots.size() - 1);
    });
    int stale = 0;
    for (const QueuedTriangle entry : entries) {
      EXPECT_EQ(entry.is_current(t), t.slots[entry.id()].v == before[entry.id()]);
      stale += entry.is_current(t) ? 0 : 1;
    }
    EXPECT_GT(stale, 0);
  }
}

TEST(QueuedTriangle, keeps_the_side_for_which_it_was_queued) {
  const Triangulation t = samples::triangulated(samples::lattice_points(3)).triangulation;
  for (unsigned side = 0; side < 3; ++side) {
    const QueuedTriangle entry = QueuedTriangle::now(t, EdgeRef(4, side));
    EXPECT_EQ(entry.id(), 4U);
    EXPECT_EQ(entry.side.side(), side);
    EXPECT_EQ(entry.first_corner, t.slots[4].v[0]);
    EXPECT_TRUE(entry.is_current(t));
  }
}

}  // namespace
}  // namespace pardel::engine
