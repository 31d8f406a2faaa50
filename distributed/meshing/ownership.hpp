// Which rank refines which cells, and which ranks hold the triangles there.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "../../parallel/decomposition/tiles.hpp"

namespace pardel::engine {

/// Per cell, the work that its task finds. A task works in its box, which is larger than its cell, and tasks of later
/// colours find only what earlier ones have left. So the work at a place counts for the task of the earliest colour
/// among those whose boxes contain the place. The sum over all cells does not change. `work`: per cell, assumed to be
/// spread evenly over the cell. O(cells).
[[nodiscard]] std::vector<double> work_of_tasks(const Tiles& tiles, std::span<const double> work);

/// Divides the cells of tiles among ranks. Each rank owns cells that follow each other on a space-filling curve, with
/// about the same work. (In a lattice, a Hilbert curve visits the cells of the first colour; each other cell comes
/// after one of those around it.) It holds all triangles with a corner in the area that it watches: the boxes of its
/// cells, or for a quadtree its leaves and all that touch them. (Triangles that wait for a leaf may be longer than the
/// margin of its box.) So a rank holds what the tasks of its cells read and change. A task of another rank changes such
/// triangles only if its cell touches one of this rank, or for a quadtree one that touches one of this rank.
class Ownership {
 public:
  /// `work`: per cell; >= 0. All ranks pass the same arguments, and get the same result.
  Ownership(const Tiles& tiles, std::span<const double> work, int ranks);
  /// With any owners. `owner`: a rank per cell, the same on all ranks.
  Ownership(const Tiles& tiles, std::vector<int> owner);

  [[nodiscard]] Index cells() const { return static_cast<Index>(owner_.size()); }
  [[nodiscard]] Index cell_of(Point p) const { return tiles_.cell_of(p); }
  [[nodiscard]] int owner(Index cell) const { return owner_[cell]; }
  /// The ranks that own the cell or one that touches it, ascending. On a lattice, no other rank watches a point in it.
  [[nodiscard]] std::span<const int> near(Index cell) const { return near_[cell]; }
  /// True if the point lies in the area that the rank watches.
  [[nodiscard]] bool watches(int rank, Point p) const;
  /// The same for a point in the box of a cell that the rank does not own; faster on a lattice.
  [[nodiscard]] bool watches(int rank, Point p, Index box) const {
    return tiles_.lattice() != nullptr ? is_in_box_near(box, rank, p) : watches(rank, p);
  }
  [[nodiscard]] Box box_of(Index cell) const { return tiles_.box_of(cell); }
  /// The ranks that watch a part of the cell's box, in ascending order: they may hold what its task changes.
  [[nodiscard]] std::vector<int> watchers_of_box(Index cell) const;
  /// The cells in the order of the curve.
  [[nodiscard]] std::span<const Index> curve() const { return curve_; }

 private:
  struct BoxOfRank {
    int rank;
    Box box;
  };
  void find_neighbours();
  /// True if the point lies in the box of a cell of the rank that touches the given cell. (Boxes of other cells do not
  /// meet the box of this cell.)
  [[nodiscard]] bool is_in_box_near(Index cell, int rank, Point p) const {
    return std::ranges::any_of(
        boxes_near_[cell], [&](const BoxOfRank& near) { return near.rank == rank && near.box.contains_half_open(p); });
  }

  Tiles tiles_;
  std::vector<Index> curve_;
  std::vector<int> owner_;
  std::vector<std::vector<Index>> touching_;
  std::vector<std::vector<int>> near_;  ///< per cell: the ranks that own it or a cell that touches it, ascending
  std::vector<std::vector<BoxOfRank>> boxes_near_;  ///< per cell: those of cells that touch it and have other owners
};

}  // namespace pardel::engine
