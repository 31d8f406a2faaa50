// A test of the user (Goal::user_test): what it is asked, when the run ends, and what the report says then.
#include "../../core/user_test.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "../../core/digest.hpp"
#include "../../core/support/point_order.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

using Corners = std::array<Point, 3>;

/// Triangles near the origin must be small.
bool is_large_here(const Corners& corners, double area) {
  const double distance = std::hypot(corners[0].x + corners[1].x + corners[2].x,  //
                                     corners[0].y + corners[1].y + corners[2].y);
  return area > 1e-4 + 1e-3 * distance;
}
Goal goal_near_origin() { return {.user_test = is_large_here, .user_test_is_free_of_state = true}; }

Meshed meshed(const Pslg& pslg, const Goal& goal, const Options& options = {}) {
  Result<Meshed> made = mesh(pslg, goal, options);
  EXPECT_TRUE(made) << made.error().message;
  return std::move(made).value();
}

std::uint64_t failures(const Pslg& pslg, const Mesh& mesh, const Goal& goal) {
  return check(pslg, mesh, goal).violation_counts[static_cast<std::size_t>(ViolationKind::user_test)];
}

TEST(UserTest, refines_triangles_until_they_pass) {
  const Goal goal = goal_near_origin();
  const Meshed fine = meshed(domains::key(), goal), coarse = meshed(domains::key(), {});
  EXPECT_TRUE(fine.report.goal_met());
  EXPECT_EQ(fine.report.fail_user_test, 0U);
  EXPECT_GT(fine.mesh.triangles.size(), 2 * coarse.mesh.triangles.size());
  EXPECT_TRUE(check(domains::key(), fine.mesh, goal).valid);
  EXPECT_GT(failures(domains::key(), coarse.mesh, goal), 0U);
}

TEST(UserTest, alone_without_a_bound_on_angles_is_kept) {
  Goal goal = goal_near_origin();
  goal.min_angle_deg = 0;
  const Meshed made = meshed(domains::pipe(), goal);
  EXPECT_TRUE(made.report.goal_met());
  EXPECT_TRUE(check(domains::pipe(), made.mesh, goal).valid);
}

TEST(UserTest, is_kept_beside_every_other_bound) {
  for (Goal goal : {Goal{.max_area = 2e-3}, Goal{.max_edge = 0.1}, Goal{.size = [](Point) { return 0.08; }},
                    Goal{.size = [](Point) { return 0.08; }, .size_slope = 0}, Goal{.grading = 0.5}}) {
    goal.user_test = is_large_here;
    const Meshed made = meshed(domains::key(), goal);
    EXPECT_TRUE(made.report.goal_met());
    EXPECT_TRUE(check(domains::key(), made.mesh, goal).valid);
  }
}

TEST(UserTest, gets_corners_from_the_least_one_counter_clockwise_and_their_area) {
  bool is_wrong = false;
  std::uint64_t asked = 0;
  Goal goal{.max_area = 0.01};
  goal.user_test = [&](const Corners& c, double area) {
    ++asked;
    const double twice = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
    is_wrong = is_wrong || lexicographically_less(c[1], c[0]) || lexicographically_less(c[2], c[0]) || !(twice > 0) ||
               area != twice / 2;
    return is_large_here(c, area);
  };
  const Meshed made = meshed(domains::key(), goal);
  const std::uint64_t by_mesher = asked;
  EXPECT_GT(by_mesher, made.mesh.triangles.size());
  EXPECT_TRUE(check(domains::key(), made.mesh, goal).valid);
  EXPECT_EQ(asked, by_mesher + made.mesh.triangles.size());
  EXPECT_FALSE(is_wrong);
}

TEST(UserTest, gives_one_mesh_whether_it_may_have_state_or_not_on_any_number_of_threads) {
  Goal goal = goal_near_origin();
  std::set<std::string> digests;
  for (const bool is_free_of_state : {false, true})
    for (const int threads : {1, 2, 4}) {
      goal.user_test_is_free_of_state = is_free_of_state;
      const Options options{.threads = threads, .triangles_per_tile = 100};
      digests.insert(to_string(digest(meshed(domains::pipe(), goal, options).mesh)));
    }
  EXPECT_EQ(digests.size(), 1U);
}

TEST(UserTest, that_may_have_state_is_asked_by_the_calling_thread_only) {
  std::set<std::thread::id> threads;
  Goal goal;
  goal.user_test = [&](const Corners& corners, double area) {
    threads.insert(std::this_thread::get_id());
    return is_large_here(corners, area);
  };
  const Meshed made = meshed(domains::pipe(), goal, {.threads = 4, .triangles_per_tile = 100});
  EXPECT_TRUE(check(domains::pipe(), made.mesh, goal).valid);
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(UserTest, that_is_free_of_state_is_asked_by_several_threads) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  Goal goal{.user_test_is_free_of_state = true};
  goal.user_test = [&](const Corners& corners, double area) {
    if (area < 1e-3) {
      const std::scoped_lock lock(mutex);
      threads.insert(std::this_thread::get_id());
    }
    return area > 1e-5 || is_large_here(corners, area);
  };
  const Meshed made = meshed(domains::pipe(), goal, {.threads = 2, .triangles_per_tile = 500});
  EXPECT_GE(made.report.tiling.columns * made.report.tiling.rows, 4U) << "the work is divided";
  EXPECT_EQ(threads.size(), 2U);
}

TEST(UserTest, that_no_triangle_passes_ends_at_the_budget_and_the_report_says_so) {
  const Goal goal{.user_test = [](const Corners&, double) { return true; }};
  const Meshed made = meshed(domains::key(), goal, {.max_vertices = 3000});
  EXPECT_EQ(made.mesh.points.size(), 3000U);
  EXPECT_EQ(made.report.fail_user_test, made.mesh.triangles.size());
  EXPECT_EQ(made.report.count(ExemptReason::budget), made.mesh.triangles.size());
  EXPECT_FALSE(made.report.goal_met());
  EXPECT_EQ(failures(domains::key(), made.mesh, goal), made.mesh.triangles.size());
}

TEST(UserTest, that_no_triangle_passes_ends_at_the_shortest_edge_and_the_report_says_so) {
  const Goal goal{.user_test = [](const Corners&, double) { return true; }};
  const Meshed made = meshed(domains::square(), goal, {.min_edge = 0.05});
  EXPECT_GT(made.mesh.triangles.size(), 300U);
  EXPECT_EQ(made.report.fail_user_test, made.mesh.triangles.size());
  EXPECT_EQ(made.report.count(ExemptReason::min_edge), made.mesh.triangles.size());
}

TEST(UserTest, that_segments_keep_from_being_met_names_them) {
  const Goal goal{.min_angle_deg = 0, .user_test = [](const Corners&, double area) { return area > 0.01; }};
  const Meshed made = meshed(domains::square(), goal, {.no_segment_splits = true});
  EXPECT_EQ(made.report.fail_user_test, failures(domains::square(), made.mesh, goal));
  EXPECT_EQ(made.report.goal_met(), made.report.fail_user_test == 0);
}

TEST(UserTest, refines_a_given_mesh_and_leaves_one_that_passes) {
  const Goal goal = goal_near_origin();
  const Meshed coarse = meshed(domains::key(), {});
  const Result<Meshed> fine = refine(coarse.mesh, {}, goal);
  ASSERT_TRUE(fine);
  EXPECT_EQ(failures(domains::key(), fine->mesh, goal), 0U);
  const Result<Meshed> again = refine(fine->mesh, {}, goal);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->report.inserted + again->report.segment_splits, 0U);
  EXPECT_EQ(digest(again->mesh), digest(fine->mesh));
}

TEST(UserTest, keeps_the_interior_from_being_filled) {
  const Goal goal{.max_area = 1e-3, .user_test = [](const Corners&, double) { return false; }};
  const Meshed made = meshed(domains::square(), goal, {.interior = Interior::fill});
  EXPECT_EQ(made.report.laid, 0U);
  EXPECT_TRUE(made.report.goal_met());
}

TEST(UserTest, that_throws_is_an_error_that_names_the_corners_and_the_exception) {
  const Goal goal{.user_test = [](const Corners&, double) -> bool { throw std::runtime_error("no data"); },
                  .user_test_is_free_of_state = true};
  std::set<std::string> messages;
  for (const int threads : {1, 2, 4}) {
    const Result<Meshed> made = mesh(domains::square(), goal, {.threads = threads});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().kind, ErrorKind::usage);
    messages.insert(made.error().message);
  }
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages.begin()->find("Goal::user_test of the triangle ("), std::string::npos);
  EXPECT_NE(messages.begin()->find("threw an exception: no data"), std::string::npos) << *messages.begin();
  const Meshed coarse = meshed(domains::square(), {});
  EXPECT_EQ(failures(domains::square(), coarse.mesh, goal), coarse.mesh.triangles.size());
}

TEST(UserTest, does_not_depend_on_which_corner_comes_first) {
  const UserTest is_from_the_origin = [](const Corners& c, double area) { return c[0] == Point{0, 0} && area == 0.5; };
  const Point a{0, 0}, b{1, 0}, c{0, 1};
  EXPECT_TRUE(must_be_refined(is_from_the_origin, a, b, c));
  EXPECT_TRUE(must_be_refined(is_from_the_origin, b, c, a));
  EXPECT_TRUE(must_be_refined(is_from_the_origin, c, a, b));
}

}  // namespace
}  // namespace pardel::engine
