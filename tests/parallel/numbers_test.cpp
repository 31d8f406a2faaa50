// Who gets which numbers: none twice, none lost, none left unused in the end.
#include "../../parallel/numbers.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "../../parallel/close_ranks.hpp"
#include "samples.hpp"

namespace pardel {
namespace {

/// Phases of tasks that ask for numbers, use some of them and give the rest back.
class Phases {
 public:
  Phases(Index used, Index limit, std::uint64_t seed) : ledger_(used, limit), random_(seed) {
    for (Index n = 0; n < used; ++n) in_use_.insert(n);
  }

  void phase() {
    const std::size_t available = ledger_.available();
    std::vector<Numbers> tasks;
    std::size_t given = 0;
    for (Index task = 0; task < 1 + random_.below(6); ++task) {
      const std::size_t asked = random_.below(40);
      std::vector<NumberRange> ranges;
      ledger_.assign(asked, ranges);
      tasks.emplace_back(ranges);
      EXPECT_EQ(tasks.back().left(), std::min(asked, available - given));
      given += tasks.back().left();
    }
    for (Numbers& numbers : tasks) {
      for (std::size_t left = random_.below(numbers.left() + 1); numbers.left() > left;)
        EXPECT_TRUE(in_use_.insert(numbers.take()).second) << "given out twice";
      ledger_.take_back(numbers);
    }
    ledger_.settle();
  }

  [[nodiscard]] const NumberLedger& ledger() const { return ledger_; }
  [[nodiscard]] const std::set<Index>& in_use() const { return in_use_; }

 private:
  NumberLedger ledger_;
  samples::Random random_;
  std::set<Index> in_use_;
};

std::set<Index> below_end_and_in_no_hole(const NumberLedger& ledger) {
  std::set<Index> result;
  for (Index n = 0; n < ledger.end(); ++n) result.insert(n);
  for (const NumberRange hole : ledger.holes())
    for (Index n = hole.begin; n < hole.end; ++n) EXPECT_EQ(result.erase(n), 1U) << "free twice, or beyond the end";
  return result;
}

TEST(NumberLedger, gives_no_number_twice_and_knows_which_are_free) {
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

TEST(NumberMoves, fill_every_hole_with_what_lies_above) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Phases phases(3, 10'000, seed);
    for (int phase = 0; phase < 10; ++phase) phases.phase();
    std::set<Index> numbers = phases.in_use();
    for (const NumberMove move : moves_into_holes(phases.ledger())) {
      ASSERT_EQ(numbers.erase(move.from), 1U) << "moves what is not there";
      ASSERT_TRUE(numbers.insert(move.to).second) << "moves onto another";
    }
    ASSERT_EQ(numbers.size(), phases.in_use().size());
    EXPECT_TRUE(numbers.empty() || *numbers.rbegin() == numbers.size() - 1);
  }
}

/// Some last vertices and triangles are moved into holes; what the triangulation says stays the same.
TEST(CloseRanks, renumbers_and_changes_nothing_else) {
  const std::vector<Point> points = samples::uniform_points(200, 11);
  Triangulation t = samples::triangulated(points).triangulation;
  for (VertexId v = 0; v < t.points.size(); ++v) t.origin[v] = v;

  // Every third triangle and every fifth vertex moves to the end; what stays behind are holes.
  const auto spread = [](Index count, Index step) {
    NumberLedger ledger(0, 100'000);
    std::vector<NumberRange> all;
    ledger.assign(count + (count + step - 1) / step, all);
    std::vector<NumberRange> holes;
    for (Index n = 0; n < count; n += step) holes.push_back({n, n + 1});
    ledger.take_back(Numbers(holes));
    ledger.settle();
    return ledger;
  };
  const auto vertices_before = static_cast<Index>(t.points.size());
  const auto triangles_before = static_cast<Index>(t.slots.size());
  const NumberLedger vertices = spread(vertices_before, 5), triangles = spread(triangles_before, 3);
  t.points.resize_uninitialised(vertices.end());
  t.origin.resize_uninitialised(vertices.end());
  t.slots.resize_uninitialised(triangles.end());
  for (Index v = 0; v < vertices_before; v += 5) {
    const Index to = vertices_before + v / 5;
    t.points[to] = t.points[v];
    t.origin[to] = v;
    for (Index id = 0; id < triangles_before; ++id)
      for (VertexId& corner : t.slots[id].v)
        if (corner == v) corner = to;
    t.origin[v] = no_index;
  }
  for (Index id = 0; id < triangles_before; id += 3) t.move_triangle(id, triangles_before + id / 3);

  close_ranks(t, vertices, triangles, 1);
  EXPECT_EQ(samples::fault(t), "");
  ASSERT_EQ(t.points.size(), vertices_before);
  ASSERT_EQ(t.slots.size(), triangles_before);
  for (VertexId v = 0; v < t.points.size(); ++v) {
    ASSERT_LT(t.origin[v], points.size());
    EXPECT_EQ(t.points[v], points[t.origin[v]]) << "vertex " << v;
  }
}

}  // namespace
}  // namespace pardel
