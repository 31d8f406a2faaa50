// The model of many ranks (bench/model) agrees with real ranks about what they send, and is consistent.
#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <numeric>

#include "../../bench/model/balance.hpp"
#include "../../bench/model/recording_ranks.hpp"
#include "../../bench/model/simulation.hpp"
#include "../../bench/model/trace.hpp"
#include "../../bench/tool.hpp"
#include "../../distributed/distributed.hpp"
#include "../../properties/theorems/framework/local_ranks.hpp"

namespace pardel::bench {
namespace {

constexpr int most_ranks = 8;

struct Case {
  ValidPslg domain;
  Goal goal;
  Options options{.threads = 1, .triangles_per_tile = 1'500};
};

Case make_case(const std::string& domain) {
  Task task{.domain = domain, .goal = {}, .triangles = 150'000};
  set_size(task);
  return {std::move(validate(make_domain(task))).value(), task.goal};
}

Trace traced(const Case& c, const std::vector<int>& ranks) {
  return std::move(trace(c.domain, c.goal, c.options, ranks)).value();
}

/// What each rank of a real run has called.
std::vector<std::vector<RecordedCall>> recorded(const Case& c, int ranks) {
  std::vector<std::vector<RecordedCall>> calls(static_cast<std::size_t>(ranks));
  properties::on_ranks(ranks, [&](Ranks& local) {
    RecordingRanks recording(local);
    ASSERT_TRUE(mesh(c.domain, c.goal, c.options, recording));
    calls[static_cast<std::size_t>(local.rank())] = recording.calls();
  });
  return calls;
}

std::uint64_t bytes_out(const Step& step) {
  return std::accumulate(step.traffic.begin(), step.traffic.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Traffic& t) { return sum + t.bytes_out; });
}

class MpiModel : public testing::TestWithParam<const char*> {};

TEST_P(MpiModel, predicts_the_calls_and_the_bytes_of_real_ranks) {
  const Case c = make_case(GetParam());
  for (const int ranks : {2, 5, most_ranks}) {
    const Trace trace = traced(c, {ranks});
    const std::vector<Step>& steps = trace.for_ranks.front().replay.steps();
    const auto calls = recorded(c, ranks);
    ASSERT_EQ(trace.rest, 0);
    ASSERT_EQ(calls.front().size(), steps.size());
    double predicted = 0, real = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      ASSERT_EQ(calls.front()[i].is_sum, steps[i].is_sum()) << "call " << i;
      if (steps[i].is_sum()) {
        EXPECT_EQ(calls.front()[i].bytes, steps[i].bytes) << "call " << i;
        continue;
      }
      predicted += static_cast<double>(bytes_out(steps[i]));
      for (const auto& of_rank : calls) real += static_cast<double>(of_rank[i].bytes_out());
    }
    // Slots are reused in another order (replay.hpp).
    EXPECT_NEAR(predicted / real, 1, 1e-3) << ranks << " ranks send " << real << " bytes";
  }
}

INSTANTIATE_TEST_SUITE_P(OnLatticesAndQuadtrees, MpiModel, testing::Values("pipe", "square", "radial"));

TEST(MpiModelOf, ranks_sums_up_to_the_run_that_was_traced) {
  const Case c = make_case("pipe");
  const Trace trace = traced(c, {1, 3, most_ranks});
  double work = 0;
  for (const PhaseRecord& phase : trace.phases)
    for (const TaskRecord& task : phase) work += task.seconds;
  for (const ForRanks& each : trace.for_ranks) {
    double of_ranks = 0;
    for (const Step& step : each.replay.steps()) {
      of_ranks += std::accumulate(step.work.begin(), step.work.end(), 0.0);
      std::uint64_t in = 0;
      for (const Traffic& traffic : step.traffic) in += traffic.bytes_in;
      EXPECT_EQ(in, bytes_out(step));
    }
    const double held = static_cast<double>(each.replay.held()) / static_cast<double>(trace.triangles);
    EXPECT_NEAR(of_ranks, work + held * trace.piece_seconds, 1e-6 * work);
  }
  const Replay& alone = trace.for_ranks.front().replay;
  EXPECT_EQ(alone.held(), trace.triangles);
  for (const Step& step : alone.steps()) EXPECT_EQ(bytes_out(step), 0);
  EXPECT_GT(trace.for_ranks[1].replay.held(), trace.triangles);
  EXPECT_GT(trace.for_ranks[2].replay.held(), trace.for_ranks[1].replay.held());
}

TEST(MpiModelOf, parts_of_the_time_add_up_and_a_slower_network_takes_longer) {
  const Case c = make_case("pipe");
  const Trace trace = traced(c, {most_ranks});
  const ForRanks& eight = trace.for_ranks.front();
  const RankCosts costs = trace.costs(eight.alone, 0);
  const auto on = [&](const Network& network) {
    const Prediction p = simulate(most_ranks, eight.replay.steps(), costs, network);
    EXPECT_NEAR(p.before + p.divide + p.phases + p.work + p.messages + p.waiting + p.network(), p.seconds,
                1e-9 * p.seconds);
    return p;
  };
  const Prediction fast = on({}), far = on({.latency = 1e-3}), narrow = on({.bandwidth = 1e7});
  const Prediction ideal = on({.latency = 0, .bandwidth = INFINITY});
  EXPECT_EQ(ideal.network(), 0);
  EXPECT_LT(ideal.seconds, fast.seconds);
  EXPECT_LT(fast.seconds, far.seconds);
  EXPECT_LT(fast.seconds, narrow.seconds);
  EXPECT_DOUBLE_EQ(fast.work, far.work);
}

TEST(MpiModelOf, the_coarse_levels_alone_is_the_beginning_of_the_whole_run) {
  const Case c = make_case("pipe");
  const Trace whole = traced(c, {2});
  const Trace coarse = std::move(trace(c.domain, c.goal, c.options, {2}, Extent::coarse)).value();
  EXPECT_EQ(coarse.coarse_triangles, whole.coarse_triangles);
  EXPECT_EQ(coarse.promised, whole.promised);
  EXPECT_TRUE(coarse.phases.empty());
}

TEST(MpiModelOf, ranks_that_repeat_traced_ones_have_their_work_and_traffic) {
  const Case c = make_case("pipe");
  const Trace trace = traced(c, {3});
  const Replay& three = trace.for_ranks.front().replay;
  constexpr int more = 9;
  const std::vector<Step> steps = repeated(three.steps(), 3, more, 3 * trace.promised.size());
  ASSERT_EQ(steps.size(), three.steps().size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step &step = steps[i], &traced = three.steps()[i];
    EXPECT_EQ(bytes_out(step), 3 * bytes_out(traced));
    const bool grows = step.kind == Step::Kind::cell_sum || step.kind == Step::Kind::rank_sum;
    EXPECT_EQ(step.bytes, (grows ? 3 : 1) * traced.bytes);
  }
  const Prediction few = simulate(3, three.steps(), {}, {}), many = simulate(more, steps, {}, {});
  EXPECT_NEAR(many.work, few.work, 1e-9 * few.work);
  EXPECT_GT(many.announcements, few.announcements);
}

TEST(Balance, is_even_for_one_rank_and_a_division_by_measured_work_is_no_worse_than_the_promise) {
  const Case c = make_case("radial");
  const Trace trace = traced(c, {1});
  const Balance one = balance(trace, trace.promised, 1);
  EXPECT_DOUBLE_EQ(one.promised, 1);
  EXPECT_DOUBLE_EQ(one.inserted, 1);
  EXPECT_DOUBLE_EQ(one.phases, 1);
  const Balance promised = balance(trace, trace.promised, most_ranks);
  const Balance measured = balance(trace, inserted_per_cell(trace), most_ranks);
  EXPECT_LE(measured.inserted, promised.inserted);
  EXPECT_GE(promised.phases, promised.inserted);
}

TEST(Network, collective_functions_cost_nothing_on_one_rank_and_more_on_more_ranks) {
  const Network network;
  EXPECT_EQ(network.all_to_all(1, 24), 0);
  EXPECT_EQ(network.all_reduce(1, 24), 0);
  for (int ranks = 2; ranks < 20'000; ranks *= 2) {
    EXPECT_LT(network.all_to_all(ranks / 2, 24), network.all_to_all(ranks, 24));
    EXPECT_LT(network.all_reduce(ranks / 2, 8e6), network.all_reduce(ranks, 8e6));
  }
}

}  // namespace
}  // namespace pardel::bench
