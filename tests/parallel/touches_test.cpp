// What the tasks of one phase touch is disjoint: no triangle is read or written by two of them (THEORY, T-region).
#include <gtest/gtest.h>

#include <map>

#include "many_tasks.hpp"

namespace pardel {
namespace {

#ifndef PARDEL_TOUCHES
#error "built with the watched twin of the engine only"
#endif

/// The schedule of a test that watches: what each task of the phase has touched, and how many triangles two have.
class Watch {
 public:
  [[nodiscard]] Schedule schedule() {
    return {.before_task = [this](std::size_t task) { touches = &log_[task]; }, .after_phase = [this] { compare(); }};
  }
  [[nodiscard]] std::uint64_t touched() const { return touched_; }
  [[nodiscard]] std::uint64_t common() const { return common_; }
  [[nodiscard]] std::size_t most_tasks() const { return most_tasks_; }

 private:
  void compare() {
    touches = nullptr;
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

INSTANTIATE_TEST_SUITE_P(Every, Touches, testing::Range(std::size_t{0}, samples::cases().size()),
                         [](const auto& parameter) { return samples::cases()[parameter.param].name; });

}  // namespace
}  // namespace pardel
