// A task refines the triangles in its box and hands the other triangles on: later tasks process them.
#include "../../../parallel/refinement/task.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "assessed_sample.hpp"

namespace pardel::engine {
namespace {

/// Points, by default random ones in the unit square, a task, and indices for some insertions.
struct TaskScene : samples::AssessedSample {
  FreeIndices free;

  explicit TaskScene(Index insertions = 5000, Placement placement = Placement::off_centre)
      : TaskScene(samples::uniform_points(300, 5), {.min_angle_deg = 25, .max_area = 0.0003},
                  {.placement = placement, .min_edge = 1e-6}, insertions) {}
  TaskScene(const std::vector<Point>& points, const Goal& goal, const Options& with, Index insertions)
      : AssessedSample(points, goal, with.placement, with) {
    const auto vertices = static_cast<Index>(t().points.size()), triangles = static_cast<Index>(t().slots.size());
    free = {IndexPool({{vertices, vertices + insertions}}), IndexPool({{triangles, triangles + 2 * insertions}})};
    t().points.resize(vertices + insertions);
    t().origin.resize(vertices + insertions);
    t().slots.resize(triangles + 2 * insertions);
  }
  Triangulation& t() { return sample.triangulation; }
  [[nodiscard]] Index triangles() const {
    return static_cast<Index>(sample.triangulation.slots.size() - free.triangles.left());
  }
  /// Runs the task of a cell with all bad triangles in the cell's box.
  TaskResult run(
      const Tiles& tiles, Index cell, const Deferral& later = {}, const Task::Report& report = [](std::uint64_t) {},
      bool own_cell_only = false) {
    const Box box = tiles.box_of(cell);
    std::vector<QueuedTriangle> seeds;
    for (TriangleId id = 0; id < triangles(); ++id) {
      const auto& v = t().slots[id].v;
      if (std::all_of(v.begin(), v.end(), [&](VertexId c) { return box.contains_half_open(t().points[c]); }))
        seeds.push_back(QueuedTriangle::now(t(), EdgeRef(id, 0)));
    }
    Task task(t(), assessor, criteria, options.min_edge, own_cell_only);
    return task.run(tiles, cell, seeds, later, free, report);
  }
  [[nodiscard]] std::vector<TriangleId> bad() const {
    std::vector<TriangleId> bad;
    for (TriangleId id = 0; id < triangles(); ++id)
      if (assessor.assess(id).need != Assessment::Need::nothing) bad.push_back(id);
    return bad;
  }
};

const Tiles one_cell(Lattice({0, 0, 1, 1}, 1, 1));

TEST(Task, refines_the_whole_plane_until_no_triangle_is_bad) {
  TaskScene scene;
  EXPECT_FALSE(scene.bad().empty());
  const TaskResult result = scene.run(one_cell, 0);
  EXPECT_TRUE(scene.bad().empty());
  EXPECT_GT(result.inserted, 1024U);
  EXPECT_GT(result.segment_splits, 0U);
  EXPECT_TRUE(result.handed_on.empty());
  EXPECT_TRUE(result.deferred.empty());
  EXPECT_TRUE(result.needs_larger_box.empty());
}

TEST(Task, changes_no_triangle_outside_its_box) {
  TaskScene scene;
  const Tiles lattice(Lattice({0, 0, 1, 1}, 3, 3));
  const Box box = lattice.box_of(0);
  const Triangulation before = scene.t();
  const Index triangles = scene.triangles();
  const TaskResult result = scene.run(lattice, 0);
  EXPECT_GT(result.inserted, 0U);
  EXPECT_FALSE(result.handed_on.empty() && result.needs_larger_box.empty());
  for (const HandedOn& h : result.handed_on) EXPECT_NE(h.cell, 0U);
  for (TriangleId id = 0; id < triangles; ++id) {
    const auto& v = before.slots[id].v;
    if (scene.t().slots[id].v != v) {
      for (const VertexId c : v) EXPECT_TRUE(box.contains_half_open(before.points[c]));
    }
  }
}

/// In the paper's lattice, a point belongs to the cell in which it lies, also a point on a segment.
TEST(Task, inserts_only_points_of_its_own_cell_if_asked) {
  const Tiles lattice(Lattice({0, 0, 1, 1}, 3, 3));
  std::uint64_t of_other_cells = 0;
  for (const auto& [own_cell_only, placement] : {std::pair(true, Placement::off_centre),
                                                 {false, Placement::off_centre},
                                                 {true, Placement::search},
                                                 {false, Placement::search}}) {
    std::array<int, 2> beyond{};  // points in faces, and on segments
    for (Index cell = 0; cell < lattice.cells(); ++cell) {
      TaskScene scene(5000, placement);
      const auto first = static_cast<Index>(scene.t().points.size() - scene.free.vertices.left());
      const TaskResult result = scene.run(
          lattice, cell, {}, [](std::uint64_t) {}, own_cell_only);
      const auto made = static_cast<Index>(result.inserted + result.segment_splits);
      EXPECT_GT(made, 20U);
      for (Index v = first; v < first + made; ++v)
        if (lattice.cell_of(scene.t().points[v]) != cell) ++beyond[scene.t().origin[v] == interior_vertex ? 0 : 1];
      of_other_cells += result.handed_on.size();
    }
    EXPECT_EQ(beyond[0] == 0, own_cell_only);
    EXPECT_EQ(beyond[1] == 0, own_cell_only);
  }
  EXPECT_GT(of_other_cells, 0U);
}

TEST(Task, makes_fewer_triangles_and_no_shorter_edges_if_it_searches_for_the_best_points) {
  const std::vector<Point> points = samples::uniform_points(300, 6);
  const auto refined = [&](Placement placement) {
    TaskScene scene(points, {.min_angle_deg = 33}, {.placement = placement, .min_edge = 1e-6}, 20'000);
    EXPECT_TRUE(scene.run(one_cell, 0).handed_on.empty());
    EXPECT_TRUE(scene.bad().empty());
    double shortest = INFINITY;
    for (TriangleId id = 0; id < scene.triangles(); ++id)
      shortest = std::min(shortest, Shape(scene.t(), scene.t().slots[id]).shortest_squared());
    return std::pair(scene.triangles(), shortest);
  };
  const auto [by_off_centres, shortest_by_off_centres] = refined(Placement::off_centre);
  const auto [by_search, shortest_by_search] = refined(Placement::search);
  EXPECT_LT(by_search, 0.9 * by_off_centres);
  EXPECT_GT(shortest_by_search, 0.6 * shortest_by_off_centres);
}

TEST(Task, defers_what_the_rule_defers) {
  TaskScene scene;
  const Deferral later{.longest_squared = 0.003};
  const TaskResult result = scene.run(one_cell, 0, later);
  EXPECT_GT(result.inserted, 0U);
  EXPECT_FALSE(result.deferred.empty());
  const std::vector<TriangleId> bad = scene.bad();
  EXPECT_FALSE(bad.empty());
  for (const TriangleId id : bad) {
    EXPECT_TRUE(std::any_of(result.deferred.begin(), result.deferred.end(), [&](const Deferred& d) {
      return d.triangle.id() == id && d.triangle.is_current(scene.t());
    })) << id;
  }
}

TEST(Task, hands_the_rest_on_to_its_own_cell_where_its_indices_are_used_up) {
  TaskScene scene(50);
  const TaskResult result = scene.run(one_cell, 0);
  EXPECT_EQ(result.inserted + result.segment_splits, 50U);
  EXPECT_GT(result.out_of_numbers, 0U);
  EXPECT_EQ(result.handed_on.size(), result.out_of_numbers);
  for (const HandedOn& h : result.handed_on) EXPECT_EQ(h.cell, 0U);
  for (const TriangleId id : scene.bad()) {
    EXPECT_TRUE(std::any_of(result.handed_on.begin(), result.handed_on.end(), [&](const HandedOn& h) {
      return h.triangle.id() == id && h.triangle.is_current(scene.t());
    })) << id;
  }
}

/// The middle of the lower side is rounded up to the point above it.
TEST(Task, counts_a_segment_that_cannot_be_split) {
  const double ulp = 0x1p-52;
  for (const double min_edge : {0.0, 1e-6}) {
    TaskScene scene({{1, 1 + ulp}, {3, 1 + 2 * ulp}, {2, 1 + 2 * ulp}, {2, 9}}, {.min_angle_deg = 0, .max_area = 100},
                    {.min_edge = min_edge}, 1);
    ASSERT_EQ(scene.bad().size(), 1U) << "the flat triangle";
    const TaskResult result = scene.run(one_cell, 0);
    EXPECT_EQ(result.inserted + result.segment_splits, 0U);
    EXPECT_EQ(result.refused, 1U) << (min_edge > 0 ? "too short" : "not valid");
    EXPECT_TRUE(result.left_alone);
  }
}

TEST(Task, reports_after_64_insertions_at_the_latest) {
  TaskScene scene;
  std::uint64_t reported = 0, largest = 0;
  const TaskResult result = scene.run(one_cell, 0, {}, [&](std::uint64_t made) {
    reported += made;
    largest = std::max(largest, made);
  });
  const std::uint64_t made = result.inserted + result.segment_splits;
  EXPECT_GT(made, 1024U);
  EXPECT_LE(largest, Task::steps_between_reports);
  EXPECT_LE(made - reported, Task::steps_between_reports);
}

TEST(Task, ends_at_once_if_its_report_throws_even_among_the_seeds) {
  for (const int call : {1, 2, 5, 12}) {
    TaskScene scene;
    int calls = 0;
    const auto run = [&] {
      (void)scene.run(one_cell, 0, {}, [&](std::uint64_t) {
        if (++calls == call) throw Stopped{};
      });
    };
    const std::size_t left = scene.free.vertices.left();
    EXPECT_THROW(run(), Stopped);
    EXPECT_EQ(calls, call);
    EXPECT_LE(left - scene.free.vertices.left(), Task::steps_between_reports * static_cast<std::uint64_t>(call));
  }
}

TEST(Task, makes_the_same_mesh_in_single_steps) {
  TaskScene at_once, in_steps;
  (void)at_once.run(one_cell, 0);
  std::vector<QueuedTriangle> seeds;
  for (TriangleId id = 0; id < in_steps.triangles(); ++id)
    seeds.push_back(QueuedTriangle::now(in_steps.t(), EdgeRef(id, 0)));
  Task task(in_steps.t(), in_steps.assessor, in_steps.criteria, in_steps.options.min_edge, false);
  task.start(one_cell, 0, seeds, {}, in_steps.free);
  while (task.step()) continue;
  (void)task.finish();
  ASSERT_EQ(at_once.triangles(), in_steps.triangles());
  for (TriangleId id = 0; id < at_once.triangles(); ++id)
    EXPECT_EQ(at_once.t().slots[id].v, in_steps.t().slots[id].v) << id;
}

}  // namespace
}  // namespace pardel::engine
