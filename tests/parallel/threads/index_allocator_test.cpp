// No index is allocated twice, and none is lost.
#include "../../../parallel/threads/index_allocator.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "../../../parallel/threads/parallel_arrays.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

/// Simulates phases of tasks that get indices, use some of them and return the others.
class Phases {
 public:
  Phases(Index used, Index limit, std::uint64_t seed) : allocator_(used, limit), random_(seed) {
    for (Index n = 0; n < used; ++n) in_use_.insert(n);
  }

  void phase() {
    const std::size_t available = allocator_.available();
    std::vector<IndexPool> tasks;
    std::size_t given = 0;
    for (Index task = 0; task < 1 + random_.below(6); ++task) {
      const std::size_t requested = random_.below(40);
      std::vector<IndexRange> ranges;
      allocator_.allocate(requested, ranges);
      tasks.emplace_back(ranges);
      EXPECT_EQ(tasks.back().left(), std::min(requested, available - given));
      given += tasks.back().left();
    }
    for (IndexPool& pool : tasks) {
      std::vector<Index> taken, recorded;
      for (std::size_t left = random_.below(pool.left() + 1); pool.left() > left;) {
        taken.push_back(pool.take());
        EXPECT_TRUE(in_use_.insert(taken.back()).second) << "allocated twice";
      }
      pool.for_each_taken([&](IndexRange r) {
        for (Index n = r.begin; n < r.end; ++n) recorded.push_back(n);
      });
      EXPECT_EQ(recorded, taken);
      allocator_.release(pool);
    }
    allocator_.settle();
  }

  [[nodiscard]] const IndexAllocator& allocator() const { return allocator_; }
  [[nodiscard]] const std::set<Index>& in_use() const { return in_use_; }

 private:
  IndexAllocator allocator_;
  samples::Random random_;
  std::set<Index> in_use_;
};

/// The indices below end() that lie in no hole.
std::set<Index> below_end_and_in_no_hole(const IndexAllocator& allocator) {
  std::set<Index> result;
  for (Index n = 0; n < allocator.end(); ++n) result.insert(n);
  for (const IndexRange hole : allocator.holes())
    for (Index n = hole.begin; n < hole.end; ++n) EXPECT_EQ(result.erase(n), 1U) << "free twice, or beyond the end";
  return result;
}

TEST(IndexAllocator, gives_no_index_twice_and_records_which_are_free) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Phases phases(Index(seed % 7), 500, seed);
    for (int phase = 0; phase < 10; ++phase) {
      phases.phase();
      ASSERT_EQ(below_end_and_in_no_hole(phases.allocator()), phases.in_use());
      ASSERT_EQ(phases.allocator().in_use(), phases.in_use().size());
      ASSERT_EQ(phases.allocator().available(), 500 - phases.in_use().size());
      ASSERT_LE(phases.allocator().end(), 500U);
    }
  }
}

TEST(IndexMoves, fill_every_hole_with_an_element_from_above) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Phases phases(3, 10'000, seed);
    for (int phase = 0; phase < 10; ++phase) phases.phase();
    std::set<Index> numbers = phases.in_use();
    for (Index n = 0; n < phases.allocator().end(); ++n) ASSERT_EQ(phases.allocator().uses(n), numbers.contains(n));
    const IndexMoves moves(phases.allocator());
    Index last = 0;
    for_each_move(Threads(1), moves, [&](Index from, Index to) {
      EXPECT_EQ(numbers.erase(from), 1U) << "moves an index that is not in use";
      EXPECT_TRUE(numbers.insert(to).second) << "moves to an index that is in use";
      EXPECT_EQ(moves.now(from), to);
      EXPECT_GT(from, last);
      last = from;
    });
    ASSERT_EQ(numbers.size(), phases.in_use().size());
    EXPECT_TRUE(numbers.empty() || *numbers.rbegin() == numbers.size() - 1);
  }
}

}  // namespace
}  // namespace pardel::engine
