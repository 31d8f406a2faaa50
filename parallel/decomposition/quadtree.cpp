#include "quadtree.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace pardel::engine {
namespace {

using Leaf = Quadtree::Leaf;

std::uint64_t first_place(const Leaf& leaf) { return Square::first_place(leaf.level, leaf.column, leaf.row); }

/// The leaves of a tree that grows, by their first places.
using Leaves = std::map<std::uint64_t, Leaf>;

Leaf leaf_at(const Leaves& leaves, const Leaf& square) {
  return std::prev(leaves.upper_bound(first_place(square)))->second;
}

/// Replaces a leaf by its four quarters.
void divide(Leaves& leaves, const Leaf& leaf, std::vector<Leaf>& made) {
  leaves.erase(first_place(leaf));
  for (const std::uint32_t quarter : {0U, 1U, 2U, 3U}) {
    made.push_back({leaf.level + 1, 2 * leaf.column + (quarter & 1U), 2 * leaf.row + (quarter >> 1U)});
    leaves.emplace(first_place(made.back()), made.back());
  }
}

/// Calls visit(square) for the squares that touch `leaf` from outside, of half its side, or of its own side at the
/// deepest level.
template <class Visit>
void for_each_around(const Leaf& leaf, const Visit& visit) {
  const std::uint32_t parts = leaf.level < Square::deepest ? 2 : 1;
  const std::uint32_t level = leaf.level + parts - 1;
  const std::int64_t count = std::int64_t{1} << level;
  const std::int64_t left = std::int64_t{leaf.column} * parts, low = std::int64_t{leaf.row} * parts;
  for (std::int64_t y = low - 1; y <= low + parts; ++y)
    for (std::int64_t x = left - 1; x <= left + parts; ++x) {
      const bool inside = x >= left && x < left + parts && y >= low && y < low + parts;
      if (!inside && x >= 0 && y >= 0 && x < count && y < count)
        visit(Leaf{level, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)});
    }
}

/// Divides leaves that touch one of `made`, directly or in the course of the work, and are too large for it.
void balance(Leaves& leaves, std::vector<Leaf> made) {
  while (!made.empty()) {
    const Leaf leaf = made.back();
    made.pop_back();
    for_each_around(leaf, [&](const Leaf& square) {
      const Leaf other = leaf_at(leaves, square);
      if (other.level + 1 < leaf.level) divide(leaves, other, made);
    });
  }
}

double overlap(double a_low, double a_high, double b_low, double b_high) {
  return std::max(0.0, std::min(a_high, b_high) - std::max(a_low, b_low));
}

}  // namespace

Quadtree::Quadtree(const Box& bounds) : Quadtree(Square(bounds), {Leaf{}}) {}

Quadtree::Quadtree(const Square& square, std::vector<Leaf> leaves) : square_(square), leaves_(std::move(leaves)) {
  for (const Leaf& leaf : leaves_) starts_.push_back(first_place(leaf));
  find_touching();
  choose_colours();
}

Quadtree Quadtree::divided(std::span<const double> per_leaf, double most) const {
  Leaves leaves;
  for (const Leaf& leaf : leaves_) leaves.emplace(first_place(leaf), leaf);
  std::vector<Leaf> made;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (per_leaf[i] > most && leaves_[i].level < Square::deepest) divide(leaves, leaves_[i], made);
  }
  balance(leaves, std::move(made));
  std::vector<Leaf> all;
  for (const auto& [start, leaf] : leaves) all.push_back(leaf);
  return {square_, std::move(all)};
}

Box Quadtree::with_margin(const Leaf& leaf, double margin) const {
  const double side = square_.side_at(leaf.level);
  const Point low = square_.low();
  const std::uint32_t last = (1U << leaf.level) - 1;
  Box box;
  if (leaf.column > 0) box.min_x = low.x + (leaf.column - margin) * side;
  if (leaf.row > 0) box.min_y = low.y + (leaf.row - margin) * side;
  if (leaf.column < last) box.max_x = low.x + (leaf.column + 1 + margin) * side;
  if (leaf.row < last) box.max_y = low.y + (leaf.row + 1 + margin) * side;
  return box;
}

void Quadtree::find_touching() {
  for (const Leaf& leaf : leaves_) {
    first_touching_.push_back(touching_.size());
    std::vector<Index> found;
    for_each_around(leaf, [&](const Leaf& square) { found.push_back(leaf_at(first_place(square))); });
    std::sort(found.begin(), found.end());
    touching_.insert(touching_.end(), found.begin(), std::unique(found.begin(), found.end()));
  }
  first_touching_.push_back(touching_.size());
}

/// Each leaf gets the first colour that no leaf before it has that touches it.
void Quadtree::choose_colours() {
  colour_.assign(leaves_.size(), 0);
  for (Index cell = 0; cell < cells(); ++cell) {
    std::uint32_t taken = 0;
    for (const Index other : touching(cell))
      if (other < cell) taken |= 1U << colour_[other];
    while ((taken >> colour_[cell] & 1U) != 0) ++colour_[cell];
    colours_ = std::max<unsigned>(colours_, colour_[cell] + 1U);
  }
}

double Quadtree::sum_over_box(Index cell, const std::vector<double>& per_cell) const {
  const Box box = box_of(cell);
  double sum = per_cell[cell];
  for (const Index other : touching(cell)) {
    const Leaf& leaf = leaves_[other];
    const double side = square_.side_at(leaf.level);
    const double x = square_.low().x + leaf.column * side, y = square_.low().y + leaf.row * side;
    sum += per_cell[other] * (overlap(x, x + side, box.min_x, box.max_x) / side) *
           (overlap(y, y + side, box.min_y, box.max_y) / side);
  }
  return sum;
}

}  // namespace pardel::engine
