// The order of segments along the sweep line, compared with a plain list.
#include "../../../parallel/segments/sweep_status.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace pardel::engine {
namespace {

std::vector<Index> forwards(const SweepStatus& status) {
  std::vector<Index> edges;
  Index node = status.first_not_below([](Index) { return false; });
  for (; node != no_index; node = status.next(node)) edges.push_back(status.edge(node));
  return edges;
}

std::vector<Index> backwards(const SweepStatus& status) {
  std::vector<Index> edges;
  for (Index node = status.last(); node != no_index; node = status.previous(node)) edges.push_back(status.edge(node));
  return {edges.rbegin(), edges.rend()};
}

TEST(SweepStatus, is_the_list_that_the_same_changes_make) {
  constexpr Index most = 300;
  SweepStatus status(most);
  std::vector<Index> list, unused;
  for (Index e = 0; e < most; ++e) unused.push_back(e);
  std::mt19937 random(1);
  for (int step = 0; step < 20'000; ++step) {
    const std::size_t at = random() % (list.size() + 1);
    const Index node = at < list.size() ? status.node_of(list[at]) : no_index;
    if (random() % 2 == 0 && !unused.empty()) {
      status.insert_before(node, unused.back());
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), unused.back());
      unused.pop_back();
    } else if (at < list.size() && random() % 2 == 0) {
      status.forget(list[at]);
      status.erase(node);
      unused.push_back(list[at]);
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
    } else if (at + 1 < list.size()) {
      status.exchange(node, status.next(node));
      std::swap(list[at], list[at + 1]);
    }
    ASSERT_EQ(forwards(status), list);
    ASSERT_EQ(backwards(status), list);
  }
  for (const Index e : list) EXPECT_EQ(status.edge(status.node_of(e)), e);
  for (const Index e : unused) EXPECT_EQ(status.node_of(e), no_index);
}

TEST(SweepStatus, finds_a_place_in_a_sorted_list_of_thousands_with_few_comparisons) {
  constexpr Index n = 1U << 14U;
  SweepStatus status(n);
  for (Index e = 0; e < n; ++e) status.insert_before(no_index, e);  // the worst order for a tree without balance
  std::size_t comparisons = 0;
  for (Index target = 0; target < n; ++target) {
    const Index node = status.first_not_below([&](Index e) { return ++comparisons, e < target; });
    ASSERT_EQ(status.edge(node), target);
  }
  EXPECT_LT(comparisons, n * 14 * 2);
}

}  // namespace
}  // namespace pardel::engine
