// A quadtree that divides the plane into leaves, and the boxes in which tasks work on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "../arithmetic/box.hpp"

namespace pardel::engine {

/// The square that a quadtree divides: the least one that covers the bounds and has their lower left corner.
class Square {
 public:
  /// The least part of the square that can be told apart has a side of 2^-deepest of the square.
  static constexpr unsigned deepest = 30;

  explicit Square(const Box& bounds) : low_{bounds.min_x, bounds.min_y}, side_(bounds.extent()) {}
  [[nodiscard]] Point low() const { return low_; }
  [[nodiscard]] double side_at(unsigned level) const { return std::ldexp(side_, -static_cast<int>(level)); }
  /// The place along a Z-curve of the least part in which p lies, or of the nearest one. NaN is treated as the lowest
  /// value.
  [[nodiscard]] std::uint64_t place_of(Point p) const {
    return place(least_part((p.x - low_.x) / side_), least_part((p.y - low_.y) / side_));
  }
  /// The first place in the square (column, row) of a level.
  [[nodiscard]] static std::uint64_t first_place(unsigned level, std::uint32_t column, std::uint32_t row) {
    const unsigned down = deepest - level;
    return place(column << down, row << down);
  }

 private:
  /// Moves bit i to bit 2i.
  [[nodiscard]] static std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 16U) & 0x0000ffff0000ffffU;
    x = (x | x << 8U) & 0x00ff00ff00ff00ffU;
    x = (x | x << 4U) & 0x0f0f0f0f0f0f0f0fU;
    x = (x | x << 2U) & 0x3333333333333333U;
    return (x | x << 1U) & 0x5555555555555555U;
  }
  /// The place along the Z-curve of a square of the deepest level.
  [[nodiscard]] static std::uint64_t place(std::uint32_t column, std::uint32_t row) {
    return spread(row) << 1U | spread(column);
  }
  /// The column or row of the least part at this fraction of the square's side.
  [[nodiscard]] static std::uint32_t least_part(double fraction) {
    constexpr double count = 1U << deepest;
    const double index = fraction * count;
    return !(index > 0) ? 0 : static_cast<std::uint32_t>(std::min(index, count - 1));
  }

  Point low_;
  double side_;
};

/// The leaf, among those of a quadtree along the Z-curve, to which p belongs.
template <class Leaf>
[[nodiscard]] Index leaf_of(const std::vector<Leaf>& leaves, const Square& square, Point p) {
  const auto after =
      std::upper_bound(leaves.begin(), leaves.end(), square.place_of(p), [](std::uint64_t place, const Leaf& leaf) {
        return place < Square::first_place(leaf.level, leaf.column, leaf.row);
      });
  return static_cast<Index>(after - leaves.begin() - 1);
}

/// A balanced quadtree over a square: the sides of two leaves that touch, in a side or a corner, differ at most by a
/// factor of two. The box of a leaf is the leaf with a margin of a quarter of its side. So only the boxes of leaves
/// that touch intersect. Leaves that touch have different colours; leaves are numbered along a Z-curve.
class Quadtree {
 public:
  /// A leaf: the square (column, row) among the 2^level x 2^level squares of its level, the lowest left one first.
  struct Leaf {
    std::uint32_t level = 0, column = 0, row = 0;
    friend bool operator==(const Leaf&, const Leaf&) = default;
  };

  /// A tree with one leaf.
  explicit Quadtree(const Box& bounds);

  /// A tree in which each leaf with more than `most` of a quantity is divided into four. More leaves are divided to
  /// keep the balance, without which the boxes of leaves that do not touch might intersect (THEORY.md, Quadtree).
  /// `per_leaf`: the quantity of each leaf.
  [[nodiscard]] Quadtree divided(std::span<const double> per_leaf, double most) const;

  [[nodiscard]] Index cells() const { return static_cast<Index>(leaves_.size()); }
  [[nodiscard]] std::span<const Leaf> leaves() const { return leaves_; }
  [[nodiscard]] double side_of(Index cell) const { return square_.side_at(leaves_[cell].level); }
  /// The leaf of a point. A point beyond the bounds belongs to the nearest leaf. NaN is treated as the lowest value.
  [[nodiscard]] Index cell_of(Point p) const { return leaf_at(square_.place_of(p)); }
  [[nodiscard]] Point centre_of(Index cell) const {
    const Leaf& leaf = leaves_[cell];
    return {square_.low().x + (leaf.column + 0.5) * side_of(cell), square_.low().y + (leaf.row + 0.5) * side_of(cell)};
  }
  [[nodiscard]] unsigned colours() const { return colours_; }
  [[nodiscard]] unsigned colour_of(Index cell) const { return colour_[cell]; }
  /// The box in which the task of a leaf works. Boxes at the border of the square extend to infinity.
  [[nodiscard]] Box box_of(Index cell) const { return with_margin(leaves_[cell], 0.25); }
  /// The cavity of a point in a leaf lies in the box of the leaf if no circumradius exceeds this value: a point in the
  /// circumdisk of a triangle is at most two radii, that is the margin of the box, away from its corners (THEORY.md,
  /// Quadtree). This holds for each triangle separately. As in Lattice::radius_that_fits(), 1 % is left for rounding.
  [[nodiscard]] double radius_that_fits(Index cell) const { return 0.99 * side_of(cell) / 8; }
  /// The area of the box, without its parts beyond the border.
  [[nodiscard]] double box_area(Index cell) const { return 2.25 * side_of(cell) * side_of(cell); }
  /// The leaves that touch a leaf, in ascending order. The boxes of all others are disjoint from its box (THEORY.md,
  /// Quadtree).
  [[nodiscard]] std::span<const Index> touching(Index cell) const {
    return {touching_.data() + first_touching_[cell], first_touching_[cell + 1] - first_touching_[cell]};
  }
  /// The sum of a quantity over the box of a leaf, given its values per leaf, which it fills evenly.
  [[nodiscard]] double sum_over_box(Index cell, const std::vector<double>& per_cell) const;

 private:
  /// The leaves, along the Z-curve, are those of a balanced tree.
  Quadtree(const Square& square, std::vector<Leaf> leaves);
  [[nodiscard]] Index leaf_at(std::uint64_t place) const {
    return static_cast<Index>(std::upper_bound(starts_.begin(), starts_.end(), place) - starts_.begin() - 1);
  }
  [[nodiscard]] Box with_margin(const Leaf& leaf, double margin) const;
  void find_touching();
  void choose_colours();

  Square square_;
  std::vector<Leaf> leaves_;
  std::vector<std::uint64_t> starts_;  ///< the first place of each leaf
  std::vector<Index> touching_;
  std::vector<std::size_t> first_touching_;
  std::vector<std::uint8_t> colour_;
  unsigned colours_ = 1;
};

}  // namespace pardel::engine
