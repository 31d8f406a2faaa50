// Who gets which numbers: none twice, none lost, none left unused in the end.
#include "../../../parallel/concurrency/index_allocator.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "../../../parallel/scheduling/compact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

/// Phases of tasks that ask for numbers, use some of them and give the rest back.
class Phases {
 public:
  Phases(Index used, Index limit, std::uint64_t seed) : ledger_(used, limit), random_(seed) {
    for (Index n = 0; n < used; ++n) in_use_.insert(n);
  }

  void phase() {
    const std::size_t available = ledger_.available();
    std::vector<IndexPool> tasks;
    std::size_t given = 0;
    for (Index task = 0; task < 1 + random_.below(6); ++task) {
      const std::size_t asked = random_.below(40);
      std::vector<IndexRange> ranges;
      ledger_.assign(asked, ranges);
      tasks.emplace_back(ranges);
      EXPECT_EQ(tasks.back().left(), std::min(asked, available - given));
      given += tasks.back().left();
    }
    for (IndexPool& numbers : tasks) {
      for (std::size_t left = random_.below(numbers.left() + 1); numbers.left() > left;)
        EXPECT_TRUE(in_use_.insert(numbers.take()).second) << "given out twice";
      ledger_.take_back(numbers);
    }
    ledger_.settle();
  }

  [[nodiscard]] const IndexAllocator& ledger() const { return ledger_; }
  [[nodiscard]] const std::set<Index>& in_use() const { return in_use_; }

 private:
  IndexAllocator ledger_;
  samples::Random random_;
  std::set<Index> in_use_;
};

std::set<Index> below_end_and_in_no_hole(const IndexAllocator& ledger) {
  std::set<Index> result;
  for (Index n = 0; n < ledger.end(); ++n) result.insert(n);
  for (const IndexRange hole : ledger.holes())
    for (Index n = hole.begin; n < hole.end; ++n) EXPECT_EQ(result.erase(n), 1U) << "free twice, or beyond the end";
  return result;
}

TEST(IndexAllocator, gives_no_index_twice_and_records_which_are_free) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Phases phases(Index(seed % 7), 500, seed);
    for (int phase = 0; phase < 10; ++phase) {
      phases.phase();
      ASSERT_EQ(below_end_and_in_no_hole(phases.ledger()), phases.in_use());
      ASSERT_EQ(phases.ledger().in_use(), phases.in_use().size());
      ASSERT_EQ(phases.ledger().available(), 500 - phases.in_use().size());
      ASSERT_LE(phases.ledger().end(), 500U);
    }
  }
}

TEST(IndexMoves, fill_every_hole_with_what_lies_above) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Phases phases(3, 10'000, seed);
    for (int phase = 0; phase < 10; ++phase) phases.phase();
    std::set<Index> numbers = phases.in_use();
    for (const IndexMove move : moves_into_holes(phases.ledger())) {
      ASSERT_EQ(numbers.erase(move.from), 1U) << "moves what is not there";
      ASSERT_TRUE(numbers.insert(move.to).second) << "moves onto another";
    }
    ASSERT_EQ(numbers.size(), phases.in_use().size());
    EXPECT_TRUE(numbers.empty() || *numbers.rbegin() == numbers.size() - 1);
  }
}

/// A triangulation with holes among its numbers: every third triangle and every other vertex has one beyond the rest.
struct Spread {
  Triangulation t;
  IndexAllocator vertices, triangles;

  /// Vertices have their first number for an origin, triangles that of their first corner for a region.
  explicit Spread(Triangulation whole)
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
    IndexAllocator ledger(0, max_engine_triangles);
    std::vector<IndexRange> all;
    ledger.assign(count + (count + step - 1) / step, all);
    std::vector<IndexRange> holes;
    for (Index n = 0; n < count; n += step) holes.push_back({n, n + 1});
    ledger.take_back(IndexPool(holes));
    ledger.settle();
    return ledger;
  }
};

TEST(CloseRanks, renumbers_and_changes_nothing_else) {
  for (const std::size_t n : {200U, 35'000U}) {  // a few, and several blocks
    const std::vector<Point> points = samples::uniform_points(n, 11);
    const Triangulation whole = samples::triangulated(points).triangulation;
    Spread spread(whole);
    Triangulation& t = spread.t;
    close_ranks(t, spread.vertices, spread.triangles, 1);
    EXPECT_EQ(samples::fault(t), "");
    ASSERT_EQ(t.points.size(), whole.points.size());
    ASSERT_EQ(t.slots.size(), whole.slots.size());
    for (VertexId v = 0; v < t.points.size(); ++v) {
      ASSERT_LT(t.origin[v], points.size());
      ASSERT_EQ(t.points[v], whole.points[t.origin[v]]) << "vertex " << v;
    }
    for (TriangleId id = 0; id < t.slots.size(); ++id)
      ASSERT_EQ(t.region[id], t.origin[t.slots[id].v[0]]) << "triangle " << id;

    Spread again(whole);
    close_ranks(again.t, again.vertices, again.triangles, 3);
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
