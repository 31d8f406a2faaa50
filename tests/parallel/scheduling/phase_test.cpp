// A phase: what its tasks do depends on the mesh and on the triangles with which they start, and on nothing else.
#include "../../../parallel/scheduling/phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "../../../core/support/point_order.hpp"
#include "../../../parallel/scheduling/one_process.hpp"
#include "../../../parallel/triangulation/compact.hpp"
#include "../refinement/assessed_sample.hpp"

namespace pardel::engine {
namespace {

/// Random points whose triangles are too large, on 2 x 2 cells.
struct PhaseScene : samples::AssessedSample {
  Tiles tiles{Lattice({0, 0, 1, 1}, 2, 2)};
  Schedule schedule;
  OneProcess one_process;
  PhaseRunner runner{sample.triangulation, assessor, criteria, options, Threads(1), schedule, one_process};

  PhaseScene()
      : AssessedSample(samples::uniform_points(200, 11), {.min_angle_deg = 25, .max_area = 0.0005},
                       Placement::off_centre, {.min_edge = 1e-6}) {}
  /// The bad triangles, each in the list of the cell of its split point, in random order and some of them twice.
  SeedsByCell seeds(samples::Random& random) {
    SeedsByCell seeds(tiles.cells());
    std::vector<TriangleId> ids;
    for (TriangleId id = 0; id < sample.triangulation.slots.size(); ++id) ids.push_back(id);
    random.shuffle(ids);
    for (const TriangleId id : ids) {
      const Assessment a = assessor.assess(id);
      if (a.need == Assessment::Need::nothing) continue;
      std::vector<QueuedTriangle>& of_cell = seeds[tiles.cell_of(assessor.point_for(id, a))];
      of_cell.insert(of_cell.end(), random.chance(3) ? 2 : 1, assessor.entry(id, a));
    }
    return seeds;
  }
  /// Runs the phase of each colour, and returns the triangulation.
  Triangulation run(SeedsByCell seeds) {
    for (unsigned colour = 0; colour < tiles.colours(); ++colour) {
      std::vector<PlannedTask> tasks = runner.plan(tiles, colour, {}, seeds);
      runner.run(tiles, tasks, {}, [](std::uint64_t) {});
      for (const PlannedTask& task : tasks) inserted += task.result.inserted;
    }
    compact(sample.triangulation, IndexMoves(runner.vertices()), IndexMoves(runner.triangles()), Threads(1));
    return std::move(sample.triangulation);
  }
  std::uint64_t inserted = 0;
};

/// The corners of the triangles, sorted. The numbers of the vertices depend on how much work was expected.
std::vector<std::array<Point, 3>> corners(const Triangulation& t) {
  std::vector<std::array<Point, 3>> all;
  for (const Slot& slot : t.slots) all.push_back({t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]]});
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return std::ranges::lexicographical_compare(a, b, lexicographically_less);
  });
  return all;
}

TEST(Phase, does_not_depend_on_the_order_in_which_the_triangles_were_found) {
  samples::Random random(1);
  PhaseScene first;
  const std::vector<std::array<Point, 3>> expected = corners(first.run(first.seeds(random)));
  EXPECT_GT(first.inserted, 500U);
  for (int i = 0; i < 10; ++i) {
    PhaseScene again;
    EXPECT_TRUE(corners(again.run(again.seeds(random))) == expected);
  }
}

}  // namespace
}  // namespace pardel::engine
