// Refines small meshes with a given schedule. The meshes have so many tiles that many triangles are handed on, that is,
// passed from a task to another cell.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "../../../fuzz/with_schedule.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/random.hpp"

namespace pardel::engine::samples {

struct Case {
  std::string name;
  Pslg pslg;
  Goal goal;
  std::array<Index, 2> cells;
};

inline const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list{
        {"square", domains::square(), {.max_area = 0.00035}, {5, 5}},
        {"pipe", domains::pipe(), {.min_angle_deg = 25}, {7, 8}},
        {"cracks", domains::cracks(), {.min_angle_deg = 30, .max_area = 0.005, .conforming = true}, {3, 3}},
        {"wedge", domains::wedge(12, 7), {.min_angle_deg = 28, .max_area = 0.005}, {3, 4}},
        {"points", domains::random_points(300, 3), {.min_angle_deg = 30}, {8, 8}},
        {"lattice", domains::grid_points(9), {.max_area = 0.02}, {4, 4}},
        {"far", domains::moved(domains::cracks(), 654321, 4987654), {.min_angle_deg = 25, .max_area = 0.005}, {3, 3}},
    };
    return list;
  }();
  return all;
}

inline fuzz::RefinedMesh refined(const Case& c, const Options& options, const Schedule& schedule) {
  Result<fuzz::RefinedMesh> result = fuzz::refine_with_schedule(c.pslg, c.goal, options, schedule);
  EXPECT_TRUE(result);
  return std::move(result).value();
}

inline Options options_for(const Case& c, Decomposition decomposition = Decomposition::automatic, int threads = 1) {
  Options options{.threads = threads, .decomposition = decomposition, .min_edge = 1e-6};
  options.cells = c.cells;
  return options;
}

/// The case with sizes that grow with the distance from one of its points, and options that refine it on the leaves of
/// a quadtree.
inline Case graded(Case c) {
  const Point centre = c.pslg.points.front();
  c.goal.size = [centre](Point p) {
    const double x = p.x - centre.x, y = p.y - centre.y;
    return 0.01 + 0.2 * std::sqrt(x * x + y * y);
  };
  return c;
}
inline Options options_for_leaves(const Case& c, int threads = 1,
                                  Decomposition decomposition = Decomposition::quadtree) {
  Options options = options_for(c, decomposition, threads);
  options.triangles_per_tile = 40;
  return options;
}

/// Starts the tasks of a phase in random order, and one in four after a delay of up to 60 microseconds.
inline Schedule shuffled(std::uint64_t seed) {
  return {
      .order = [random = generators::Random(seed)](std::vector<std::size_t>& order) mutable { random.shuffle(order); },
      .before_task =
          [seed](std::size_t task) {
            generators::Random random(seed + task);
            if (random.chance(4)) std::this_thread::sleep_for(std::chrono::microseconds(random.below(60)));
          }};
}

}  // namespace pardel::engine::samples
