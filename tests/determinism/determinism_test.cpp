// A mesh depends only on its domain, goal and options. It does not depend on the number, order and speed of threads, on
// the compiler, on the level of optimisation or on the machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

#include "problems.hpp"

namespace pardel::determinism {
namespace {

using generators::Family;

class MeshOf : public testing::TestWithParam<Family> {
 protected:
  template <class Test>
  void for_each_problem(const Test& test) {
    for (std::uint64_t number = 0; number < problems_per_family; ++number) {
      const Problem p = problem(GetParam(), number);
      SCOPED_TRACE(p.what.name);
      test(p);
    }
  }
};

TEST_P(MeshOf, is_identical_on_any_number_of_threads_with_any_order_and_delays_of_tasks) {
  for_each_problem([](const Problem& p) {
    const Mesh expected = samples::refined(p.what, p.options, {}).mesh;
    Options options = p.options;
    for (const int threads : {1, 2, 3, 4, 8, 16}) {
      options.threads = threads;
      const engine::Schedule schedule = samples::shuffled(expected.points.size() + static_cast<std::size_t>(threads));
      EXPECT_TRUE(samples::refined(p.what, options, schedule).mesh == expected) << threads << " threads";
    }
  });
}

/// Without tasks that pass triangles to each other, the number of threads and the order of tasks could not matter.
TEST_P(MeshOf, is_made_by_concurrent_tasks_that_hand_triangles_on) {
  std::uint64_t with_such_tasks = 0;
  for_each_problem([&](const Problem& p) {
    std::size_t most_at_once = 0;
    const engine::Schedule schedule{
        .order = [&](const auto& tasks) { most_at_once = std::max(most_at_once, tasks.size()); }};
    std::uint64_t handed_on = 0;
    for (const Sweep& sweep : samples::refined(p.what, p.options, schedule).counts.tiling.sweeps)
      handed_on += sweep.handed_on();
    if (most_at_once >= 3 && handed_on >= 10) ++with_such_tasks;
  });
  EXPECT_GE(with_such_tasks, problems_per_family * 2 / 3);
}

/// The lines of the file `digests`.
const std::set<std::string>& recorded() {
  static const std::set<std::string> lines = [] {
    std::ifstream file(PARDEL_DIGESTS);
    std::set<std::string> read;
    for (std::string line; std::getline(file, line);) read.insert(line);
    return read;
  }();
  return lines;
}

TEST_P(MeshOf, has_the_digest_that_is_recorded) {
  for_each_problem([](const Problem& p) {
    for (const int threads : {1, 2}) {
      const std::string found = line(p, threads);
      EXPECT_TRUE(recorded().contains(found)) << "not in " PARDEL_DIGESTS ": " << found;
    }
  });
}

TEST(GradedMesh, is_identical_on_any_number_of_threads_with_any_order_and_delays_of_tasks) {
  std::uint64_t with_many_tasks = 0;
  for (std::uint64_t number = 0; number < graded_problems; ++number) {
    const Problem p = graded_problem(number);
    SCOPED_TRACE(p.what.name);
    const auto expected = samples::refined(p.what, p.options, {});
    std::uint64_t handed_on = 0;
    for (const Sweep& sweep : expected.counts.tiling.sweeps) handed_on += sweep.handed_on();
    if (expected.counts.tiling.leaves.size() >= 16 && handed_on >= 10) ++with_many_tasks;
    Options options = p.options;
    for (const int threads : {1, 2, 3, 4, 8, 16}) {
      options.threads = threads;
      const engine::Schedule schedule = samples::shuffled(number + static_cast<std::size_t>(threads));
      EXPECT_TRUE(samples::refined(p.what, options, schedule).mesh == expected.mesh) << threads << " threads";
    }
  }
  EXPECT_GE(with_many_tasks, graded_problems / 2);
}

TEST(GradedMesh, has_the_digest_that_is_recorded) {
  for (std::uint64_t number = 0; number < graded_problems; ++number)
    for (const int threads : {1, 2}) {
      const std::string found = line(graded_problem(number), threads);
      EXPECT_TRUE(recorded().contains(found)) << "not in " PARDEL_DIGESTS ": " << found;
    }
}

TEST(FilledMesh, has_the_digest_that_is_recorded) {
  for (std::uint64_t number = 0; number < filled_problems; ++number)
    for (const int threads : {1, 2, 5}) {
      const std::string found = line(filled_problem(number), threads);
      EXPECT_TRUE(recorded().contains(found)) << "not in " PARDEL_DIGESTS ": " << found;
    }
}

INSTANTIATE_TEST_SUITE_P(Every, MeshOf, testing::ValuesIn(generators::all_families()),
                         [](const auto& parameter) { return std::string(generators::name(parameter.param)); });

}  // namespace
}  // namespace pardel::determinism
