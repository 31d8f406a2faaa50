// Tests progress: the numbers that the caller gets, and the three ways to stop a refinement.
#include "../../../parallel/scheduling/progress_monitor.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pardel::engine {
namespace {

TEST(ProgressMonitor, shows_two_triangles_per_vertex_and_the_exact_number_after_a_phase) {
  std::vector<std::uint64_t> shown;
  Options options;
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.estimate, 500);
    shown.push_back(progress.triangles);
    return true;
  };
  ProgressMonitor monitor(options);
  monitor.start(500, 60, 100);
  EXPECT_TRUE(monitor.report(0, 10));
  EXPECT_TRUE(monitor.report(0, 5));
  monitor.phase_ended(80, 140);
  EXPECT_EQ(shown, (std::vector<std::uint64_t>{120, 130, 140}));
  EXPECT_EQ(monitor.vertices(), 80U);
}

TEST(ProgressMonitor, never_shows_fewer_triangles_than_before) {
  std::uint64_t last = 0;
  Options options;
  options.progress = [&](const Progress& progress) {
    EXPECT_GE(progress.triangles, last);
    last = progress.triangles;
    return true;
  };
  ProgressMonitor monitor(options);
  monitor.start(0, 3, 1);
  EXPECT_TRUE(monitor.report(0, 10));
  monitor.phase_ended(13, 11);  // ten splits of boundary edges
  EXPECT_EQ(last, 21U);
}

TEST(ProgressMonitor, calls_the_caller_from_thread_0_only) {
  int calls = 0;
  Options options;
  options.progress = [&](const Progress&) { return ++calls > 0; };
  ProgressMonitor monitor(options);
  monitor.start(0, 3, 1);
  EXPECT_TRUE(monitor.report(1, 10));
  EXPECT_TRUE(monitor.report(7, 10));
  EXPECT_EQ(calls, 0);
  EXPECT_TRUE(monitor.report(0, 10));
  EXPECT_EQ(calls, 1);
}

TEST(ProgressMonitor, is_cancelled_by_the_caller_by_cancel_and_by_memory) {
  Options options;
  options.progress = [](const Progress&) { return false; };
  ProgressMonitor by_caller(options);
  EXPECT_FALSE(by_caller.report(0, 1));
  EXPECT_TRUE(by_caller.cancelled());
  EXPECT_FALSE(by_caller.report(1, 1)) << "all threads have to end";

  const Options none;
  ProgressMonitor by_cancel(none);
  EXPECT_FALSE(by_cancel.cancelled());
  by_cancel.cancel();
  EXPECT_FALSE(by_cancel.report(0, 0));

  const Options limited{.max_memory = 80 * 1000};
  ProgressMonitor by_memory(limited);
  by_memory.start(0, 900, 1800);
  EXPECT_TRUE(by_memory.report(1, 100));
  EXPECT_FALSE(by_memory.report(2, 1)) << "80 bytes per vertex";
}

TEST(ProgressMonitor, expects_no_more_triangles_than_the_budget_of_vertices_allows) {
  double estimate = 0;
  Options options{.max_vertices = 30};
  options.progress = [&](const Progress& progress) {
    estimate = progress.estimate;
    return true;
  };
  ProgressMonitor monitor(options);
  monitor.start(500, 3, 1);
  EXPECT_TRUE(monitor.report(0, 0));
  EXPECT_EQ(estimate, 60);
}

}  // namespace
}  // namespace pardel::engine
