// An array of which few parts are used.
#include "../../../parallel/concurrency/sparse_array.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace pardel::engine
