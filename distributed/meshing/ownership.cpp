#include "ownership.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/decomposition/hilbert_order.hpp"

namespace pardel::engine {
namespace {

/// A cell is cut into such a number of columns and rows. The margin of a box is half as wide as the next cell; in a
/// quadtree, an eighth, a quarter or a half of it. So each part lies in the box or outside it.
constexpr int parts = 8;

/// In one direction, the even neighbour of a cell with an odd index: along four cells the lower one, along the next
/// four the upper one. `i`: the index in this direction; `j`: that in the other direction. (With two cells, the boxes
/// of the tasks would overlap more, and margins would be half as wide again; with eight, ranks of few tiles would wait
/// longer.)
Index even_neighbour(Index i, Index j) {
  if (i % 2 == 0) return i;
  return j / 4 % 2 == 0 ? i - 1 : i + 1;
}

/// The cell that has the same owner. In a lattice, the tasks of the first colour, in even columns and rows, do all the
/// work between them. The task of a cell between them reads and changes what they have made. Where they have two
/// owners, each gets about half of these tasks, so that both send and work about the same in each phase.
Index follows(const Tiles& tiles, Index cell) {
  const Lattice* const lattice = tiles.lattice();
  if (lattice == nullptr) return cell;
  const Index columns = lattice->columns(), i = cell % columns, j = cell / columns;
  const auto is_last_and_odd = [](Index k, Index count) { return k % 2 == 1 && k + 1 == count; };
  if (is_last_and_odd(i, columns) || is_last_and_odd(j, lattice->rows())) return cell;  // it has work of its own
  return even_neighbour(j, i) * columns + even_neighbour(i, j);
}

/// Cells that follow another one, which they touch, come after it.
std::vector<Index> cells_on_curve(const Tiles& tiles) {
  std::vector<Index> leaders;
  std::vector<Point> centres;
  for (Index cell = 0; cell < tiles.cells(); ++cell) {
    if (follows(tiles, cell) != cell) continue;
    leaders.push_back(cell);
    centres.push_back(tiles.centre_of(cell));
  }
  std::vector<Index> curve;
  for (const Index place : hilbert_order(centres)) {
    const Index leader = leaders[place];
    curve.push_back(leader);
    for (const Index other : tiles.touching(leader))
      if (follows(tiles, other) == leader) curve.push_back(other);
  }
  return curve;
}

/// Cuts the curve into parts of about the same work.
std::vector<int> owners(const Tiles& tiles, std::span<const Index> curve, std::span<const double> work, int ranks) {
  const double all = std::accumulate(work.begin(), work.end(), 0.0);
  std::vector<int> owner(curve.size());
  double before = 0;
  int last = 0;
  for (const Index cell : curve) {
    const double middle = before + work[cell] / 2;
    if (all > 0 && follows(tiles, cell) == cell)
      last = std::clamp(static_cast<int>(middle / all * ranks), 0, ranks - 1);
    owner[cell] = last;
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
    : tiles_(tiles), curve_(cells_on_curve(tiles)), owner_(owners(tiles, curve_, work, ranks)) {
  find_neighbours();
}

Ownership::Ownership(const Tiles& tiles, std::vector<int> owner)
    : tiles_(tiles), curve_(cells_on_curve(tiles)), owner_(std::move(owner)) {
  find_neighbours();
}

void Ownership::find_neighbours() {
  for (Index cell = 0; cell < tiles_.cells(); ++cell) {
    touching_.push_back(tiles_.touching(cell));
    std::vector<int>& near = near_.emplace_back(1, owner_[cell]);
    for (const Index other : touching_.back()) near.push_back(owner_[other]);
    sort_without_repetitions(near);
    std::vector<BoxOfRank>& boxes = boxes_near_.emplace_back();
    if (near.size() == 1) continue;
    for (const Index other : touching_.back())
      if (owner_[other] != owner_[cell]) boxes.push_back({owner_[other], tiles_.box_of(other)});
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
