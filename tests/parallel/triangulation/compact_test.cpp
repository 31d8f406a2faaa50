// Compaction renumbers vertices and triangles and changes nothing else.
#include "../../../parallel/triangulation/compact.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

/// A triangulation with unused indices: every third triangle and every other vertex was moved to an index beyond all
/// others.
struct WithHoles {
  Triangulation t;
  IndexAllocator vertices, triangles;

  /// The origin of a vertex is its original index. The region of a triangle is the original index of its first corner.
  explicit WithHoles(Triangulation whole)
      : t(std::move(whole)),
        vertices(with_holes(static_cast<Index>(t.points.size()), 2)),
        triangles(with_holes(static_cast<Index>(t.slots.size()), 3)) {
    const auto points = static_cast<Index>(t.points.size()), slots = static_cast<Index>(t.slots.size());
    for (VertexId v = 0; v < points; ++v) t.origin[v] = v;
    t.region.resize(slots);
    for (TriangleId id = 0; id < slots; ++id) t.region[id] = t.slots[id].v[0];
    t.points.resize_uninitialised(vertices.end());
    t.origin.resize_uninitialised(vertices.end());
    t.slots.resize_uninitialised(triangles.end());
    t.region.resize_uninitialised(triangles.end());
    for (TriangleId id = 0; id < slots; ++id)
      for (VertexId& v : t.slots[id].v)
        if (v % 2 == 0) v = points + v / 2;
    for (VertexId v = 0; v < points; v += 2) {
      t.points[points + v / 2] = t.points[v];
      t.origin[points + v / 2] = std::exchange(t.origin[v], no_index);
    }
    for (TriangleId id = 0; id < slots; id += 3) {
      t.move_triangle(id, slots + id / 3);
      t.region[slots + id / 3] = t.region[id];
    }
  }

 private:
  static IndexAllocator with_holes(Index count, Index step) {
    IndexAllocator indices(0, max_engine_triangles);
    std::vector<IndexRange> all;
    indices.allocate(count + (count + step - 1) / step, all);
    std::vector<IndexRange> holes;
    for (Index n = 0; n < count; n += step) holes.push_back({n, n + 1});
    indices.release(IndexPool(holes));
    indices.settle();
    return indices;
  }
};

TEST(Compact, renumbers_and_changes_nothing_else) {
  for (const std::size_t n : {200U, 35'000U}) {  // for one block and for several blocks
    const std::vector<Point> points = samples::uniform_points(n, 11);
    const Triangulation whole = samples::triangulated(points).triangulation;
    WithHoles moved(whole);
    Triangulation& t = moved.t;
    compact(t, IndexMoves(moved.vertices), IndexMoves(moved.triangles), 1);
    EXPECT_EQ(samples::fault(t), "");
    ASSERT_EQ(t.points.size(), whole.points.size());
    ASSERT_EQ(t.slots.size(), whole.slots.size());
    for (VertexId v = 0; v < t.points.size(); ++v) {
      ASSERT_LT(t.origin[v], points.size());
      ASSERT_EQ(t.points[v], whole.points[t.origin[v]]) << "vertex " << v;
    }
    for (TriangleId id = 0; id < t.slots.size(); ++id)
      ASSERT_EQ(t.region[id], t.origin[t.slots[id].v[0]]) << "triangle " << id;

    WithHoles again(whole);
    compact(again.t, IndexMoves(again.vertices), IndexMoves(again.triangles), 3);
    EXPECT_EQ(again.t.points, t.points);
    EXPECT_EQ(again.t.origin, t.origin);
    EXPECT_EQ(again.t.region, t.region);
    for (TriangleId id = 0; id < t.slots.size(); ++id) {
      ASSERT_EQ(again.t.slots[id].v, t.slots[id].v) << "triangle " << id;
      ASSERT_EQ(again.t.slots[id].n, t.slots[id].n) << "triangle " << id;
    }
  }
}

}  // namespace
}  // namespace pardel::engine
