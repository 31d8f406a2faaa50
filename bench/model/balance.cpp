#include "balance.hpp"

#include <algorithm>
#include <numeric>

namespace pardel::bench {
namespace {

double most_by_mean(const std::vector<double>& of_rank) {
  const double all = std::accumulate(of_rank.begin(), of_rank.end(), 0.0);
  return all > 0 ? *std::ranges::max_element(of_rank) * static_cast<double>(of_rank.size()) / all : 1;
}

}  // namespace

std::vector<double> inserted_per_cell(const Trace& trace) {
  std::vector<double> inserted(trace.promised.size(), 0);
  for (const PhaseRecord& phase : trace.phases)
    for (const TaskRecord& task : phase) inserted[task.cell] += static_cast<double>(task.inserted);
  return inserted;
}

Balance balance(const Trace& trace, std::span<const double> work, int ranks) {
  const engine::Ownership ownership(*trace.tiles, work, ranks);
  const auto owner = [&](Index cell) { return static_cast<std::size_t>(ownership.owner(cell)); };
  const std::vector<double> zero(static_cast<std::size_t>(ranks), 0);
  std::vector<double> promised = zero, inserted = zero, seconds = zero;
  for (Index cell = 0; cell < ownership.cells(); ++cell) promised[owner(cell)] += trace.promised[cell];
  double slowest = 0, all = 0;
  for (const PhaseRecord& phase : trace.phases) {
    std::vector<double> in_phase = zero;
    for (const TaskRecord& task : phase) {
      in_phase[owner(task.cell)] += static_cast<double>(task.inserted);
      seconds[owner(task.cell)] += task.seconds;
    }
    slowest += *std::ranges::max_element(in_phase);
    for (std::size_t rank = 0; rank < in_phase.size(); ++rank) {
      inserted[rank] += in_phase[rank];
      all += in_phase[rank];
    }
  }
  return {most_by_mean(promised), most_by_mean(inserted), most_by_mean(seconds), all > 0 ? slowest * ranks / all : 1};
}

}  // namespace pardel::bench
