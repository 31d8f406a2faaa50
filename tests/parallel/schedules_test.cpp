// However the tasks of a phase take turns, the mesh is the same: in any order, with delays, on threads, and with single
// insertions of different tasks interleaved at random.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "../../core/digest.hpp"
#include "../../parallel/assemble.hpp"
#include "../../parallel/refine.hpp"
#include "../../properties/domains.hpp"
#include "samples.hpp"

namespace pardel {
namespace {

struct Case {
  std::string name;
  Pslg pslg;
  Goal goal;
  std::array<Index, 2> cells;
};

/// Small meshes cut into many tiles, so that tasks meet often.
const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list{
        {"square", domains::square(), {.max_area = 0.0004}, {5, 5}},
        {"pipe", domains::pipe(), {.min_angle_deg = 25}, {7, 8}},
        {"cracks", domains::cracks(), {.min_angle_deg = 30, .max_area = 0.005, .conforming = true}, {3, 3}},
        {"wedge", domains::wedge(12, 7), {.min_angle_deg = 28, .max_area = 0.005}, {3, 4}},
        {"points", domains::random_points(300, 3), {.min_angle_deg = 30}, {8, 8}},
        {"lattice", domains::grid_points(9), {.max_area = 0.03}, {4, 4}},
        {"far", domains::moved(domains::cracks(), 654321, 4987654), {.min_angle_deg = 25, .max_area = 0.005}, {3, 3}},
    };
    return list;
  }();
  return all;
}

/// The engine's part of mesh(), with a schedule.
struct Refined {
  Mesh mesh;
  RefineCounts counts;
};
Refined refined(const Case& c, const Options& options, const Schedule& schedule) {
  Result<Assembled> domain = assemble(c.pslg, c.goal.convex_hull);
  EXPECT_TRUE(domain);
  std::vector<double> attributes, caps;
  for (const Region& region : c.pslg.regions) {
    attributes.push_back(region.attribute);
    caps.push_back(region.max_area);
  }
  const Criteria criteria(c.goal, options.placement, caps);
  auto counts = refine(domain->triangulation, domain->lines, criteria, options, schedule);
  EXPECT_TRUE(counts);
  return {disassemble(std::move(domain).value(), attributes, {}, {}), std::move(counts).value()};
}

Options options_for(const Case& c, Decomposition decomposition = Decomposition::automatic, int threads = 1) {
  Options options{.threads = threads, .decomposition = decomposition, .min_edge = 1e-6};
  options.cells = c.cells;
  return options;
}

/// Without several tasks that meet at their borders a schedule would have nothing to choose.
void expect_tasks_that_meet(const RefineCounts& counts) {
  EXPECT_GT(2 * (counts.inserted + counts.segment_splits), 3 * counts.tiling.vertices_before);
  std::uint64_t handed_on = 0;
  for (const Sweep& sweep : counts.tiling.sweeps) handed_on += sweep.to_other_cells + sweep.beyond_box;
  EXPECT_GE(handed_on, 5U);
}

class Schedules : public testing::TestWithParam<std::size_t> {
 protected:
  const Case& case_ = cases()[GetParam()];
};

TEST_P(Schedules, have_tasks_that_meet) { expect_tasks_that_meet(refined(case_, options_for(case_), {}).counts); }

TEST_P(Schedules, of_single_insertions_interleaved_at_random_give_one_mesh) {
  for (const Decomposition decomposition : {Decomposition::automatic, Decomposition::paper}) {
    const Options options = options_for(case_, decomposition);
    const Digest expected = digest(refined(case_, options, {}).mesh);
    const int schedules = decomposition == Decomposition::automatic ? 1'000 : 430;
    samples::Random random(20040626);
    for (int i = 0; i < schedules; ++i) {
      // Turns of one insertion, and now and then long runs of one task.
      const std::size_t sticky = 1 + random.below(4);
      std::size_t turn = 0;
      const Schedule schedule{.next = [&](std::size_t n) {
        if (turn >= n || random.below(sticky) == 0) turn = random.below(n);
        return turn;
      }};
      ASSERT_EQ(digest(refined(case_, options, schedule).mesh), expected) << "schedule " << i;
    }
  }
}

TEST_P(Schedules, in_any_order_and_with_delays_give_one_mesh_on_any_number_of_threads) {
  const Mesh expected = refined(case_, options_for(case_), {}).mesh;
  samples::Random random(7);
  for (const int threads : {1, 2, 3, 4, 8, 16}) {
    const std::uint64_t salt = random.next();
    const Schedule schedule{.order = [&](std::vector<std::size_t>& order) { random.shuffle(order); },
                            .before_task =
                                [salt](std::size_t task) {
                                  samples::Random here(salt + task);
                                  std::this_thread::sleep_for(std::chrono::microseconds(here.below(60)));
                                }};
    const Mesh found = refined(case_, options_for(case_, Decomposition::automatic, threads), schedule).mesh;
    EXPECT_TRUE(found == expected) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Schedules, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& parameter) { return cases()[parameter.param].name; });

}  // namespace
}  // namespace pardel
