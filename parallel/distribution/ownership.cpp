#include "ownership.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../../core/support/without_repetitions.hpp"
#include "../concurrency/hilbert_order.hpp"

namespace pardel::engine {
namespace {

/// A cell is cut into such a number of columns and rows. The margin of a box is half as wide as the next cell; in a
/// quadtree, an eighth, a quarter or a half of it. So each part lies in the box or outside it.
constexpr int parts = 8;

std::vector<Index> cells_on_curve(const Tiles& tiles) {
  std::vector<Point> centres;
  for (Index cell = 0; cell < tiles.cells(); ++cell) centres.push_back(tiles.centre_of(cell));
  const Array<Index> order = hilbert_order(centres);
  return {order.begin(), order.end()};
}

/// Cuts the curve into parts of about the same work.
std::vector<int> owners(std::span<const Index> curve, std::span<const double> work, int ranks) {
  const double all = std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<int> owner(curve.size());
  double before = 0;
  for (const Index cell : curve) {
    const double middle = before + work[cell] / 2;
    owner[cell] = all > 0 ? std::clamp(static_cast<int>(middle / all * ranks), 0, ranks - 1) : 0;
    before += work[cell];
  }
  return owner;
}

}  // namespace

std::vector<double> work_of_tasks(const Tiles& tiles, std::span<const double> work) {
  std::vector<double> of_task(work.size(), 0);
  for (Index cell = 0; cell < tiles.cells(); ++cell) {
    const Point centre = tiles.centre_of(cell);
    const auto [x, y] = tiles.half_size(cell);
    const std::vector<Index> touching = tiles.touching(cell);
    for (int part = 0; part < parts * parts; ++part) {
      const Point p{centre.x + x * ((2 * (part % parts) + 1.0) / parts - 1),
                    centre.y + y * ((2 * (part / parts) + 1.0) / parts - 1)};
      Index first = cell;
      for (const Index other : touching)
        if (tiles.colour_of(other) < tiles.colour_of(first) && tiles.box_of(other).contains_half_open(p)) first = other;
      of_task[first] += work[cell] / (parts * parts);
    }
  }
  return of_task;
}

Ownership::Ownership(const Tiles& tiles, std::span<const double> work, int ranks)
    : Ownership(tiles, owners(cells_on_curve(tiles), work, ranks)) {}

Ownership::Ownership(const Tiles& tiles, std::vector<int> owner)
    : tiles_(tiles), curve_(cells_on_curve(tiles)), owner_(std::move(owner)) {
  for (Index cell = 0; cell < tiles.cells(); ++cell) {
    touching_.push_back(tiles.touching(cell));
    std::vector<int>& near = near_.emplace_back(1, owner_[cell]);
    for (const Index other : touching_.back()) near.push_back(owner_[other]);
    sort_without_repetitions(near);
    std::vector<BoxOfRank>& boxes = boxes_near_.emplace_back();
    if (near.size() == 1) continue;
    for (const Index other : touching_.back())
      if (owner_[other] != owner_[cell]) boxes.push_back({owner_[other], tiles.box_of(other)});
  }
}

bool Ownership::watches(int rank, Point p) const {
  const Index cell = cell_of(p);
  if (owner_[cell] == rank) return true;
  if (tiles_.lattice() != nullptr) return is_in_box_near(cell, rank, p);
  return std::ranges::any_of(boxes_near_[cell], [&](const BoxOfRank& near) { return near.rank == rank; });
}

std::vector<int> Ownership::watchers_of_box(Index cell) const {
  std::vector<int> ranks = near_[cell];
  if (tiles_.lattice() == nullptr)
    for (const Index other : touching_[cell]) ranks.insert(ranks.end(), near_[other].begin(), near_[other].end());
  sort_without_repetitions(ranks);
  return ranks;
}

}  // namespace pardel::engine
