// No triangle is read or written by two tasks of one phase (THEORY.md, T-region).
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "../../../properties/domains/generators/random.hpp"
#include "many_tasks.hpp"

namespace pardel::engine {
namespace {

#ifndef PARDEL_WATCHED_ARRAYS
#error "only the mutated twin of this program is built"
#endif

/// Records which triangles each task of a phase accesses, and counts the triangles that two tasks access.
class Watch {
 public:
  [[nodiscard]] Schedule schedule() {
    return {.before_task = [this](std::size_t task) { watched_indices = &log_[task]; },
            .after_phase = [this] { compare(); }};
  }
  [[nodiscard]] std::uint64_t touched() const { return touched_; }
  [[nodiscard]] std::uint64_t common() const { return common_; }
  [[nodiscard]] std::size_t most_tasks() const { return most_tasks_; }

 private:
  void compare() {
    watched_indices = nullptr;
    std::map<std::size_t, std::size_t> owner;
    for (const auto& [task, triangles] : log_)
      for (const std::size_t triangle : triangles)
        if (owner.emplace(triangle, task).first->second != task) ++common_;
    touched_ += owner.size();
    most_tasks_ = std::max(most_tasks_, log_.size());
    log_.clear();
  }

  std::map<std::size_t, std::vector<std::size_t>> log_;
  std::uint64_t touched_ = 0, common_ = 0;
  std::size_t most_tasks_ = 0;
};

class Touches : public testing::TestWithParam<std::size_t> {
 protected:
  const samples::Case& case_ = samples::cases()[GetParam()];
};

TEST_P(Touches, of_the_tasks_of_a_phase_are_disjoint) {
  for (const Decomposition decomposition : {Decomposition::automatic, Decomposition::paper}) {
    Watch watch;
    const Schedule schedule = watch.schedule();
    const auto done = samples::refined(case_, samples::options_for(case_, decomposition), schedule);
    EXPECT_GT(watch.touched(), done.counts.inserted);
    // The paper's lattice may have room for one cell only.
    EXPECT_TRUE(watch.most_tasks() > 1 || decomposition == Decomposition::paper);
    EXPECT_EQ(watch.common(), 0U);
  }
}

TEST_P(Touches, of_tasks_on_the_leaves_of_a_quadtree_are_disjoint) {
  for (const Decomposition decomposition : {Decomposition::quadtree, Decomposition::paper_quadtree}) {
    Watch watch;
    const Schedule schedule = watch.schedule();
    const Options options = samples::options_for_leaves(case_, 1, decomposition);
    const auto done = samples::refined(samples::graded(case_), options, schedule);
    EXPECT_GT(done.counts.tiling.leaves.size(), 15U);
    EXPECT_GT(watch.touched(), done.counts.inserted);
    EXPECT_GT(watch.most_tasks(), decomposition == Decomposition::quadtree ? 3U : 2U);
    EXPECT_EQ(watch.common(), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Touches, testing::Range(std::size_t{0}, samples::cases().size()),
                         [](const auto& parameter) { return samples::cases()[parameter.param].name; });

/// Points close to a row of segments. The triangles between points and segments have their circumcentres on the other
/// side of the segments, far outside the boxes that contain the triangles.
samples::Case needles_along_a_wall() {
  constexpr int pieces = 32;
  samples::Case c{"needles", domains::square(), {.min_angle_deg = 25, .max_area = 0.002}, {6, 6}};
  generators::Random random(3);
  for (int i = 0; i <= pieces; ++i) {
    const double y = (i + 0.5) / (pieces + 1);
    c.pslg.points.push_back({0.4, y});
    if (i == 0) continue;
    const auto end = static_cast<Index>(c.pslg.points.size() - 1);
    c.pslg.segments.push_back({i == 1 ? end - 1 : end - 2, end});
    c.pslg.points.push_back({0.4 + std::ldexp(1.0, -random.between(10, 13)), y - 0.5 / (pieces + 1)});
  }
  return c;
}

/// A triangle goes to the task of the cell in which its split point lies. That task may own none of its corners.
TEST(Touches, of_tasks_that_are_sent_triangles_outside_their_boxes_are_disjoint) {
  const samples::Case c = needles_along_a_wall();
  Watch watch;
  const Schedule schedule = watch.schedule();
  Options options = samples::options_for(c);
  options.placement = Placement::circumcentre;
  options.no_segment_splits = true;
  const auto done = samples::refined(c, options, schedule);
  std::uint64_t beyond_box = 0;
  for (const Sweep& sweep : done.counts.tiling.sweeps) beyond_box += sweep.beyond_box;
  EXPECT_GE(beyond_box, 20U);
  EXPECT_EQ(watch.common(), 0U);
}

}  // namespace
}  // namespace pardel::engine
