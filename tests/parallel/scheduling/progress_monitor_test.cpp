// Tests progress: the numbers that the caller gets, and the ways to stop a run.
#include "../../../parallel/scheduling/progress_monitor.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <thread>
#include <vector>

namespace pardel::engine {
namespace {

using namespace std::chrono_literals;

/// Options that keep every progress that is shown.
Options recorded_in(std::vector<Progress>& shown) {
  Options options;
  options.progress = [&shown](const Progress& progress) {
    shown.push_back(progress);
    return true;
  };
  return options;
}

/// Expects these numbers of triangles, all with this estimate.
void expect_shown(const std::vector<Progress>& shown, double estimate, const std::vector<std::uint64_t>& triangles) {
  std::vector<std::uint64_t> found;
  for (const Progress& progress : shown) {
    EXPECT_EQ(progress.estimate, estimate);
    found.push_back(progress.triangles);
  }
  EXPECT_EQ(found, triangles);
}

TEST(ProgressMonitor, shows_two_triangles_per_vertex_and_the_exact_number_after_a_phase) {
  std::vector<Progress> shown;
  const Options options = recorded_in(shown);
  ProgressMonitor monitor(options, 0s);
  monitor.start(500, 60, 100);
  monitor.report(10);
  monitor.report(5);
  monitor.phase_ended(80, 140);
  expect_shown(shown, 500, {120, 130, 140});
  EXPECT_EQ(monitor.vertices(), 80U);
}

TEST(ProgressMonitor, counts_what_is_set_aside_for_later) {
  std::vector<Progress> shown;
  const Options options = recorded_in(shown);
  ProgressMonitor monitor(options, 0s);
  monitor.set_aside(600, 1000);
  EXPECT_EQ(monitor.triangles_aside(), 1000U);
  monitor.start(500, 60, 100);
  monitor.report(10);
  monitor.phase_ended(80, 140);
  expect_shown(shown, 1500, {1120, 1140});
  EXPECT_EQ(monitor.vertices(), 680U);
}

TEST(ProgressMonitor, passes_any_positive_estimate_on_and_nothing_aside_without_one) {
  std::vector<Progress> shown;
  const Options options = recorded_in(shown);
  ProgressMonitor monitor(options, 0s);
  monitor.set_aside(600, 1000);
  for (const double estimate : {0.0, 0.5, 1.0}) {
    monitor.start(estimate, 3, 1);
    monitor.phase_ended(3, 1);
    EXPECT_EQ(shown.back().estimate, estimate > 0 ? estimate + 1000 : 0);
  }
}

TEST(ProgressMonitor, never_shows_fewer_triangles_than_before) {
  std::uint64_t last = 0;
  Options options;
  options.progress = [&](const Progress& progress) {
    EXPECT_GE(progress.triangles, last);
    last = progress.triangles;
    return true;
  };
  ProgressMonitor monitor(options, 0s);
  monitor.start(0, 3, 1);
  monitor.report(10);
  monitor.phase_ended(13, 11);  // ten splits of boundary edges
  EXPECT_EQ(last, 21U);
}

TEST(ProgressMonitor, calls_the_caller_from_its_own_thread_only) {
  int calls = 0;
  Options options;
  options.progress = [&](const Progress&) { return ++calls > 0; };
  ProgressMonitor monitor(options, 0s);
  monitor.start(0, 3, 1);
  std::thread([&] { monitor.report(10); }).join();
  EXPECT_EQ(calls, 0);
  monitor.report(10);
  EXPECT_EQ(calls, 1);
}

TEST(ProgressMonitor, calls_the_caller_at_once_and_then_once_per_interval) {
  int calls = 0;
  Options options;
  options.progress = [&](const Progress&) { return ++calls > 0; };
  ProgressMonitor monitor(options, 24h);
  for (int i = 0; i < 1000; ++i) monitor.report(1);
  EXPECT_EQ(calls, 1);
  monitor.phase_ended(1000, 2000);
  EXPECT_EQ(calls, 2) << "the end of a phase does not wait for the interval";
}

TEST(ProgressMonitor, stops_all_threads_if_the_caller_says_so) {
  int calls = 0;
  Options options;
  options.progress = [&](const Progress&) { return ++calls < 3; };
  ProgressMonitor monitor(options, 0s);
  monitor.report(1);
  monitor.report(1);
  try {
    monitor.report(1);
    FAIL() << "must throw";
  } catch (const Stopped& stopped) {
    EXPECT_EQ(stopped.error.kind, ErrorKind::cancelled);
  }
  std::thread([&] { EXPECT_THROW(monitor.report(1), Stopped); }).join();
  EXPECT_THROW(monitor.threads().ask(), Stopped);
  EXPECT_EQ(calls, 3) << "the caller is not asked again";
}

TEST(ProgressMonitor, stops_a_mesh_that_outgrows_the_memory) {
  const Options limited{.max_memory = 80 * 1000};
  ProgressMonitor monitor(limited);
  monitor.start(0, 900, 1800);
  monitor.report(100);
  try {
    monitor.report(1);
    FAIL() << "80 bytes per vertex";
  } catch (const Stopped& stopped) {
    EXPECT_EQ(stopped.error.kind, ErrorKind::resources);
    EXPECT_NE(stopped.error.message.find("78.13 KiB"), std::string::npos) << stopped.error.message;
  }
}

TEST(ProgressMonitor, uses_one_thread_for_little_work_unless_the_caller_says_how_many) {
  omp_set_num_threads(3);
  const Options automatic, two{.threads = 2};
  ProgressMonitor of_automatic(automatic), of_two(two);
  EXPECT_EQ(of_automatic.threads().count, 3) << "the work is not known yet";
  for (ProgressMonitor* monitor : {&of_automatic, &of_two}) monitor->expect(4);
  EXPECT_EQ(of_automatic.threads().count, 1);
  EXPECT_EQ(of_two.threads().count, 2);
  of_automatic.set_aside(50'000, 100'000);
  of_automatic.start(500, 4, 2);
  EXPECT_EQ(of_automatic.threads().count, 3) << "the triangles set aside are work, too";
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
  monitor.report(0);
  EXPECT_EQ(estimate, 60);
}

}  // namespace
}  // namespace pardel::engine
