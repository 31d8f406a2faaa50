#include "balance.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pardel::bench {
namespace {

double most_by_mean(const std::vector<double>& of_rank) {
  const double all = std::accumulate(of_rank.begin(), of_rank.end(), 0.0);
  return all > 0 ? *std::ranges::max_element(of_rank) * static_cast<double>(of_rank.size()) / all : 1;
}

/// Half the width and half the height of a cell.
std::pair<double, double> half_size(const engine::Tiles& tiles, Index cell) {
  if (const engine::Lattice* lattice = tiles.lattice()) return {lattice->width() / 2, lattice->height() / 2};
  const double half = tiles.quadtree()->side_of(cell) / 2;
  return {half, half};
}

}  // namespace

std::vector<double> promised_by_task(const Trace& trace) {
  const engine::Tiles& tiles = *trace.tiles;
  const engine::Ownership ownership(tiles, trace.promised, 1);
  constexpr int parts = 8;  // the margin of a box begins in the middle of a part's side, at the latest
  std::vector<double> work(trace.promised.size(), 0);
  for (Index cell = 0; cell < tiles.cells(); ++cell) {
    const Point centre = tiles.centre_of(cell);
    const auto [x, y] = half_size(tiles, cell);
    for (int part = 0; part < parts * parts; ++part) {
      const Point p{centre.x + x * ((2 * (part % parts) + 1.0) / parts - 1),
                    centre.y + y * ((2 * (part / parts) + 1.0) / parts - 1)};
      Index first = cell;
      for (const Index other : ownership.touching(cell))
        if (tiles.colour_of(other) < tiles.colour_of(first) && tiles.box_of(other).contains_half_open(p)) first = other;
      work[first] += trace.promised[cell] / (parts * parts);
    }
  }
  return work;
}

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
