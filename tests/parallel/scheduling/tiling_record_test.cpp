// The record of the tiles: the finest lattice, and the first thread that worked on each of its cells.
#include "../../../parallel/scheduling/tiling_record.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

#include "many_tasks.hpp"

namespace pardel::engine {
namespace {

TEST(Sweep, hands_on_what_it_leaves_to_later_tasks_for_any_reason) {
  EXPECT_EQ((Sweep{.to_other_cells = 100, .beyond_box = 20, .out_of_numbers = 3}).handed_on(), 123U);
}

TEST(TilingRecord, holds_the_finest_lattice_and_the_bounds_on_circumradii) {
  const Box bounds{-1, 2, 5, 4};
  const Tiles finest(Lattice(bounds, 3, 2));
  TilingRecord record;
  record.set_finest(finest, bounds, {.radius = 0.25, .ratio = 1.5, .area = 0.125}, 77);
  record.add_sweep({.columns = 3, .rows = 2, .inserted = 5});
  const Tiling tiling = std::move(record).take();
  EXPECT_EQ(tiling.columns, 3U);
  EXPECT_EQ(tiling.rows, 2U);
  EXPECT_EQ(tiling.cell_width, 2);
  EXPECT_EQ(tiling.cell_height, 1);
  EXPECT_EQ(tiling.low, (Point{-1, 2}));
  EXPECT_EQ(tiling.high, (Point{5, 4}));
  EXPECT_EQ(tiling.vertices_before, 77U);
  EXPECT_EQ(tiling.largest_radius, 0.25);
  EXPECT_EQ(tiling.radius_by_t3, radius_bound(1.5, 0.125));
  EXPECT_EQ(tiling.radius_by_t3_sharp, sharp_radius_bound(1.5, 0.125));
  ASSERT_EQ(tiling.sweeps.size(), 1U);
  EXPECT_EQ(tiling.sweeps[0].inserted, 5U);
}

TEST(TilingRecord, finds_the_cell_of_a_point_and_its_colour) {
  Tiling tiling;
  tiling.low = {-1, 2};
  tiling.high = {5, 4};
  tiling.columns = 3;
  tiling.rows = 2;
  EXPECT_EQ(tiling.cell_of({-0.5, 2.5}), 0U);
  EXPECT_EQ(tiling.cell_of({1.5, 2.5}), 1U);
  EXPECT_EQ(tiling.cell_of({4.5, 3.5}), 5U);
  for (Index cell = 0; cell < 6; ++cell) EXPECT_EQ(tiling.colour_of(cell), cell / 3 * 2 + cell % 3 % 2);
}

TEST(TilingRecord, holds_the_first_thread_of_each_cell_of_the_finest_lattice) {
  const Box bounds{0, 0, 1, 1};
  const Tiles coarse(Lattice(bounds, 1, 1)), finest(Lattice(bounds, 2, 2));
  TilingRecord record;
  record.add_task(coarse, 0, 3);
  record.set_finest(finest, bounds, {}, 0);
  record.add_task(finest, 2, 1);
  record.add_task(finest, 2, 0);
  record.add_task(finest, 3, 0);
  record.add_task(coarse, 0, 3);
  EXPECT_EQ(std::move(record).take().thread_of_cell, (std::vector<std::int16_t>{-1, -1, 1, 0}));
}

TEST(TilingRecord, finds_the_leaf_of_a_point_and_its_colour) {
  const Box bounds{0, 0, 1, 0.75};
  Quadtree tree(bounds);
  for (int i = 0; i < 5; ++i) {
    std::vector<double> quantity(tree.cells(), 0);
    quantity[tree.cell_of({0.3, 0.4})] = 1;
    tree = tree.divided(quantity, 0.5);
  }
  const Tiles finest(tree);
  TilingRecord record;
  record.set_finest(finest, bounds, {}, 0);
  const Tiling tiling = std::move(record).take();
  EXPECT_EQ(tiling.columns, tree.cells());
  EXPECT_EQ(tiling.cell_width, 1.0 / 32);
  for (Index cell = 0; cell < tree.cells(); ++cell) {
    EXPECT_EQ(tiling.cell_of(tree.centre_of(cell)), cell);
    EXPECT_EQ(tiling.colour_of(cell), tree.colour_of(cell));
  }
}

/// The first two tasks wait for each other, so two threads run them.
TEST(TilingRecord, names_all_threads_that_worked) {
  if (omp_get_max_threads() < 2) GTEST_SKIP() << "there is one thread only";
  std::atomic<int> started{0};
  Schedule schedule;
  schedule.before_task = [&](std::size_t) {
    ++started;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (started < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  };
  schedule.order = [&](const std::vector<std::size_t>& tasks) { started = tasks.size() < 2 ? 2 : 0; };
  const samples::Case& c = samples::cases().front();
  const Tiling tiling =
      samples::refined(c, samples::options_for(c, Decomposition::automatic, 2), schedule).counts.tiling;
  EXPECT_EQ(std::ranges::max(tiling.thread_of_cell), 1);
  EXPECT_TRUE(std::ranges::count(tiling.thread_of_cell, 0) > 0);
}

}  // namespace
}  // namespace pardel::engine
