// The mesh does not depend on the schedule of the tasks of a phase: on their order, on delays, on the number of
// threads, or on the order in which single insertions of different tasks are interleaved.
#include <gtest/gtest.h>

#include <tuple>

#include "../../../core/digest.hpp"
#include "../samples.hpp"
#include "many_tasks.hpp"

namespace pardel::engine {
namespace {

using samples::Case;
using samples::cases;
using samples::options_for;
using samples::refined;

/// A schedule can make a difference only if several tasks hand triangles on (pass them to other cells).
std::uint64_t handed_on(const RefineCounts& counts) {
  std::uint64_t sum = 0;
  for (const Sweep& sweep : counts.tiling.sweeps) sum += sweep.to_other_cells + sweep.beyond_box;
  return sum;
}

class Schedules : public testing::TestWithParam<std::size_t> {
 protected:
  const Case& case_ = cases()[GetParam()];
};

TEST_P(Schedules, have_tasks_that_meet) {
  const RefineCounts counts = refined(case_, options_for(case_), {}).counts;
  EXPECT_GT(2 * (counts.inserted + counts.segment_splits), 3 * counts.tiling.vertices_before);
  EXPECT_GE(handed_on(counts), 5U);
}

TEST_P(Schedules, in_any_order_and_with_delays_give_one_mesh_on_any_number_of_threads) {
  const Mesh expected = refined(case_, options_for(case_), {}).mesh;
  samples::Random random(7);
  for (const int threads : {1, 2, 3, 4, 8, 16}) {
    const Schedule schedule = samples::shuffled(random.next());
    const Mesh found = refined(case_, options_for(case_, Decomposition::automatic, threads), schedule).mesh;
    EXPECT_TRUE(found == expected) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Schedules, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& parameter) { return cases()[parameter.param].name; });

/// The parameters are a domain and one tenth of its 1530 schedules, so that each test stays short under sanitizers.
class Interleavings : public testing::TestWithParam<std::tuple<std::size_t, int>> {
 protected:
  const Case& case_ = cases()[std::get<0>(GetParam())];

  /// Tasks take turns after single insertions, and sometimes after long runs of insertions.
  void expect_one_mesh(const Case& c, const Options& options, int schedules) {
    const Digest expected = digest(refined(c, options, {}).mesh);
    for (int i = 0; i < schedules; ++i) {
      const std::size_t sticky = 1 + random_.below(4);
      std::size_t turn = 0;
      const Schedule schedule{.next = [&](std::size_t n) {
        if (turn >= n || random_.below(sticky) == 0) turn = random_.below(n);
        return turn;
      }};
      ASSERT_EQ(digest(refined(c, options, schedule).mesh), expected) << "schedule " << i;
    }
  }

 private:
  samples::Random random_{20040626 + static_cast<std::uint64_t>(std::get<1>(GetParam()))};
};

TEST_P(Interleavings, of_single_insertions_give_one_mesh) {
  expect_one_mesh(case_, options_for(case_), 100);
  expect_one_mesh(case_, options_for(case_, Decomposition::paper), 43);
}

TEST_P(Interleavings, of_single_insertions_on_the_leaves_of_a_quadtree_give_one_mesh) {
  const Case graded = samples::graded(case_);
  const Options options = samples::options_for_leaves(graded);
  EXPECT_GE(handed_on(refined(graded, options, {}).counts), 20U);
  expect_one_mesh(graded, options, 10);
  expect_one_mesh(graded, samples::options_for_leaves(graded, 1, Decomposition::paper_quadtree), 5);
}

INSTANTIATE_TEST_SUITE_P(Every, Interleavings,
                         testing::Combine(testing::Range(std::size_t{0}, cases().size()), testing::Range(0, 10)),
                         [](const auto& parameter) {
                           return cases()[std::get<0>(parameter.param)].name + "_" +
                                  std::to_string(std::get<1>(parameter.param));
                         });

}  // namespace
}  // namespace pardel::engine
