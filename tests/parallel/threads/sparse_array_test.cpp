// An array of which few parts are used.
#include "../../../parallel/threads/sparse_array.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace pardel::engine {
namespace {

TEST(SparseArray, has_zeroes_where_nothing_was_set) {
  SparseArray<int> array;
  EXPECT_EQ(array.get(0), 0);
  EXPECT_EQ(array.get(no_index), 0);
  array.set(5000, 7);
  EXPECT_EQ(array.get(4999), 0);
  EXPECT_EQ(array.get(5000), 7);
  EXPECT_EQ(array.get(5001), 0);
  EXPECT_EQ(array.get(1'000'000), 0);
}

TEST(SparseArray, keeps_the_last_value) {
  SparseArray<int> array;
  for (Index i = 1020; i < 1030; ++i) array.set(i, static_cast<int>(i));
  array.set(1024, -1);
  EXPECT_EQ(array.get(1023), 1023);
  EXPECT_EQ(array.get(1024), -1);
  EXPECT_EQ(array.get(1025), 1025);
}

TEST(SparseArray, says_in_which_runs_nothing_was_set) {
  SparseArray<int> array;
  array.set(3000, 7);
  for (const auto& [first, last] : {std::pair<Index, Index>{0, 10'000}, {2500, 3001}, {3000, 3000}, {9000, 9001}}) {
    Index next = first;
    array.for_each_run(first, last, [&](Index begin, Index end, bool may_be_set) {
      EXPECT_EQ(begin, next);
      EXPECT_LT(begin, end);
      EXPECT_TRUE(may_be_set || end <= 3000 || begin > 3000) << begin << " to " << end;
      EXPECT_TRUE(!may_be_set || (end > 2000 && begin < 4100)) << begin << " to " << end;  // not far around it
      next = end;
    });
    EXPECT_EQ(next, last);
  }
}

}  // namespace
}  // namespace pardel::engine
