// The communicator of a run without other ranks.
#pragma once

#include "../triangulation/compact.hpp"
#include "communicator.hpp"

namespace pardel::engine {

class OneProcess final : public Communicator {
 public:
  [[nodiscard]] int ranks() const override { return 1; }
  void add_up(std::span<std::uint64_t> /*values*/) override {}
  void add_up_estimates(std::span<double> /*estimates*/) override {}
  void take_largest(std::span<double> /*values*/) override {}
  [[nodiscard]] Box bounds_of_all(const Box& here) override { return here; }
  void begin(PhaseRunner& /*runner*/) override {}
  [[nodiscard]] std::function<bool(TriangleId)> counted() const override { return {}; }
  [[nodiscard]] Waiting refine_coarse(const CoarseWork& work) override {
    work.refine_here();
    return {};
  }
  void divide(const Division& /*division*/, PhaseRunner& /*runner*/) override {}
  void deliver(std::vector<PlannedTask>& /*tasks*/) override {}
  void exchange_changes(std::vector<PlannedTask>& /*tasks*/) override {}
  void refine_rest(const RestOfWork& work) override { work.refine_here(); }
  /// Closes the gaps between indices.
  void finish(Triangulation& t, const PhaseRunner& runner, const Threads& threads) override {
    compact(t, IndexMoves(runner.vertices()), IndexMoves(runner.triangles()), threads);
  }
};

}  // namespace pardel::engine
