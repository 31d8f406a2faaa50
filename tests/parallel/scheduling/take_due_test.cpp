// The triangles that are due are taken out in order, and the others stay in order, on any number of threads.
#include "../../../parallel/scheduling/take_due.hpp"

#include <gtest/gtest.h>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

TEST(TakeDue, keeps_the_order_of_both_lists_on_any_number_of_threads) {
  constexpr unsigned last_key = 2000;
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, items_in_block, 5 * items_in_block + 7}) {
    Random random(n);
    Array<Deferred> all;
    std::vector<TriangleId> early, late;
    for (TriangleId id = 0; id < n; ++id) {
      const Assessment a{Assessment::Need::split_triangle, 0, static_cast<unsigned>(random.below(4000)), 1, false};
      all.push_back({{EdgeRef(id, 0), 0}, a});
      (a.key <= last_key ? early : late).push_back(id);
    }
    for (const int threads : {1, 2, 7}) {
      Array<Deferred> deferred = all;
      const Array<TriangleId> due = take_due(threads, deferred, {.longest_squared = 0, .last_key = last_key},
                                             [](const Deferred& d) { return d.triangle.id(); });
      EXPECT_EQ(std::vector<TriangleId>(due.begin(), due.end()), early);
      std::vector<TriangleId> stayed;
      for (const Deferred& d : deferred) stayed.push_back(d.triangle.id());
      EXPECT_EQ(stayed, late);
    }
  }
}

}  // namespace
}  // namespace pardel::engine
