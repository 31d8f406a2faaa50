// The functions of the caller may fail. Each failure becomes an error value that names it, on any number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>
#include <new>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>

#include "../../../core/digest.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

using Size = std::function<double(Point)>;

/// The error of a mesh with this goal. It must be a usage error, and the same on one to four threads.
std::string error_of(const Pslg& pslg, const Goal& goal, Options options = {}) {
  std::string first;
  for (const int threads : {1, 2, 3, 4}) {
    options.threads = threads;
    const Result<Meshed> meshed = mesh(pslg, goal, options);
    if (meshed) return "no error";
    EXPECT_EQ(meshed.error().kind, ErrorKind::usage);
    if (first.empty()) first = meshed.error().message;
    EXPECT_EQ(meshed.error().message, first) << threads << " threads";
  }
  return first;
}

/// The point in a message: "... at (0.5, 0.25)...".
Point named_point(const std::string& message) {
  Point p{NAN, NAN};
  const std::size_t at = message.find(" at (");
  if (at != std::string::npos) std::sscanf(message.c_str() + at, " at (%lf, %lf)", &p.x, &p.y);
  return p;
}

/// True in many small disks. Only a fine mesh has centroids in them.
bool in_a_disk(Point p) { return std::hypot(std::remainder(p.x, 0.25), std::remainder(p.y, 0.25)) < 0.005; }

TEST(SizeFunction, that_returns_no_length_is_an_error_that_names_the_point_and_the_number) {
  const struct {
    double number;
    std::string text;
  } cases[] = {{0, "returned 0 at"}, {-2.5, "returned -2.5 at"}, {std::nan(""), "returned nan at"}};
  for (const auto& [number, text] : cases) {
    const std::string everywhere = error_of(domains::square(), {.size = [n = number](Point) { return n; }});
    EXPECT_NE(everywhere.find("Goal::size " + text), std::string::npos) << everywhere;
    const Size in_disks = [n = number](Point p) { return in_a_disk(p) ? n : 0.003; };
    const std::string message = error_of(domains::square(), {.size = in_disks});
    EXPECT_NE(message.find(text), std::string::npos) << message;
    EXPECT_TRUE(in_a_disk(named_point(message))) << message;
  }
}

/// Counts the places of a size that had been announced, among those that it is asked about.
struct Announcements {
  std::set<std::pair<double, double>> announced{};
  std::size_t calls = 0, asked = 0, known = 0;

  [[nodiscard]] Goal goal() {
    Goal goal;
    goal.size = [this](Point p) {
      ++asked;
      if (announced.contains({p.x, p.y})) ++known;
      return 0.01 + 0.05 * p.x;
    };
    goal.before_sizes = [this](std::span<const Point> places) {
      ++calls;
      for (const Point p : places) announced.insert({p.x, p.y});
    };
    return goal;
  }
};

TEST(SizeFunction, is_asked_about_places_that_were_announced_and_the_mesh_is_the_same) {
  for (const double grading : {HUGE_VAL, 0.2}) {
    Announcements count;
    Goal goal = count.goal();
    goal.grading = grading;
    const Result<Meshed> announced = mesh(domains::square(), goal, {.threads = 1});
    EXPECT_GT(count.known, count.asked - count.asked / 20);
    EXPECT_LT(count.calls, count.asked / 4);
    goal.before_sizes = nullptr;
    const Result<Meshed> usual = mesh(domains::square(), goal, {.threads = 1});
    ASSERT_TRUE(announced && usual);
    EXPECT_EQ(announced->mesh, usual->mesh);
  }
}

TEST(SizeFunction, is_announced_by_the_threads_that_ask) {
  std::mutex one_at_a_time;
  std::set<std::tuple<std::thread::id, double, double>> announced;
  std::size_t asked = 0, known = 0;
  Goal goal;
  goal.size = [&](Point p) {
    const std::scoped_lock lock(one_at_a_time);
    ++asked;
    if (announced.contains({std::this_thread::get_id(), p.x, p.y})) ++known;
    return 0.01;
  };
  goal.before_sizes = [&](std::span<const Point> places) {
    const std::scoped_lock lock(one_at_a_time);
    for (const Point p : places) announced.insert({std::this_thread::get_id(), p.x, p.y});
  };
  ASSERT_TRUE(mesh(domains::square(), goal, {.threads = 3}));
  EXPECT_GT(known, asked - asked / 5) << "a task has splits in triangles that other threads announced";
}

TEST(SizeFunction, whose_announcement_throws_is_an_error_with_the_exception) {
  Goal goal{.size = [](Point) { return 0.1; }};
  goal.before_sizes = [](std::span<const Point>) { throw std::runtime_error("no data"); };
  EXPECT_EQ(error_of(domains::square(), goal), "Goal::before_sizes threw an exception: no data");
}

TEST(SizeFunction, that_throws_is_an_error_that_names_the_point_and_the_exception) {
  const Size at_once = [](Point) -> double { throw std::runtime_error("no data"); };
  const Size late = [](Point p) { return in_a_disk(p) ? throw std::runtime_error("no data") : 0.003; };
  for (const Size& size : {at_once, late}) {
    const std::string message = error_of(domains::square(), {.size = size});
    EXPECT_NE(message.find("threw an exception: no data"), std::string::npos) << message;
    EXPECT_TRUE(std::isfinite(named_point(message).x)) << message;
  }
  const std::string message = error_of(domains::square(), {.size = [](Point) -> double { throw 7; }});
  EXPECT_NE(message.find("threw an exception"), std::string::npos) << message;
}

TEST(SizeFunction, that_throws_while_a_mesh_is_refined_is_an_error) {
  const Result<Meshed> coarse = mesh(domains::square());
  ASSERT_TRUE(coarse);
  const Result<Meshed> fine = refine(coarse->mesh, {}, {.size = [](Point) { return 0.0; }});
  ASSERT_FALSE(fine);
  EXPECT_EQ(fine.error().kind, ErrorKind::usage);
}

TEST(SizeFunction, that_runs_out_of_memory_is_an_error_of_resources) {
  const Result<Meshed> meshed =
      mesh(domains::square(), {.size = [](Point) -> double { throw std::bad_alloc(); }}, {.threads = 2});
  ASSERT_FALSE(meshed);
  EXPECT_EQ(meshed.error().kind, ErrorKind::resources);
}

TEST(SizeFunction, that_returns_infinity_sets_no_bound) {
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  const Goal goal{.min_angle_deg = 30, .max_area = 0.01};
  Goal with_size = goal;
  with_size.size = [](Point) { return no_bound; };
  const Result<Meshed> expected = mesh(domains::key(), goal), found = mesh(domains::key(), with_size);
  ASSERT_TRUE(expected && found);
  EXPECT_EQ(digest(found->mesh), digest(expected->mesh));
  EXPECT_TRUE(found->report.goal_met());
}

TEST(Progress, that_throws_is_an_error_with_the_text_of_the_exception) {
  const Goal goal{.max_area = 1e-4};
  const std::string message = error_of(
      domains::pipe(), goal, {.progress = [](const Progress&) -> bool { throw std::runtime_error("closed"); }});
  EXPECT_EQ(message, "Options::progress threw an exception: closed");
}

TEST(AfterSweep, that_throws_is_an_error_with_the_text_of_the_exception) {
  const std::string message =
      error_of(domains::pipe(), {},
               {.after_sweep = [](const Mesh&, const Sweep&) -> Status { throw std::runtime_error("disk full"); }});
  EXPECT_EQ(message, "Options::after_sweep threw an exception: disk full");
}

}  // namespace
}  // namespace pardel::engine
