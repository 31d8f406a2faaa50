// The tiles of a level: the cells of a lattice, or the leaves of a quadtree.
#pragma once

#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "lattice.hpp"
#include "quadtree.hpp"

namespace pardel::engine {

/// Divides the plane into cells. Each cell has a colour and a box; the boxes of the cells of one colour are disjoint.
class Tiles {
 public:
  explicit Tiles(Lattice lattice) : shape_(lattice) {}
  explicit Tiles(Quadtree tree) : shape_(std::move(tree)) {}

  [[nodiscard]] Index cells() const {
    return std::visit([](const auto& s) { return s.cells(); }, shape_);
  }
  [[nodiscard]] Index cell_of(Point p) const {
    return std::visit([p](const auto& s) { return s.cell_of(p); }, shape_);
  }
  [[nodiscard]] Point centre_of(Index cell) const {
    return std::visit([cell](const auto& s) { return s.centre_of(cell); }, shape_);
  }
  [[nodiscard]] unsigned colours() const {
    return std::visit([](const auto& s) -> unsigned { return s.colours(); }, shape_);
  }
  [[nodiscard]] unsigned colour_of(Index cell) const {
    return std::visit([cell](const auto& s) { return s.colour_of(cell); }, shape_);
  }
  [[nodiscard]] Box box_of(Index cell) const {
    return std::visit([cell](const auto& s) { return s.box_of(cell); }, shape_);
  }
  /// Half the width and half the height of a cell.
  [[nodiscard]] std::pair<double, double> half_size(Index cell) const {
    if (lattice() != nullptr) return {lattice()->width() / 2, lattice()->height() / 2};
    return {quadtree()->side_of(cell) / 2, quadtree()->side_of(cell) / 2};
  }
  /// The other cells that touch a cell, also those that touch only its corners.
  [[nodiscard]] std::vector<Index> touching(Index cell) const {
    if (lattice() != nullptr) return lattice()->touching(cell);
    const std::span<const Index> found = quadtree()->touching(cell);
    return {found.begin(), found.end()};
  }
  [[nodiscard]] double box_area(Index cell) const {
    return std::visit([cell](const auto& s) { return s.box_area(cell); }, shape_);
  }
  [[nodiscard]] double sum_over_box(Index cell, const std::vector<double>& per_cell) const {
    return std::visit([&](const auto& s) { return s.sum_over_box(cell, per_cell); }, shape_);
  }
  /// The cavity of a point in the cell lies in the box of the cell if no circumradius exceeds this value.
  [[nodiscard]] double radius_that_fits(Index cell) const {
    return lattice() != nullptr ? lattice()->radius_that_fits() : quadtree()->radius_that_fits(cell);
  }
  /// The columns and rows of the lattice; for a quadtree, the number of leaves and 1.
  [[nodiscard]] Index columns() const { return lattice() != nullptr ? lattice()->columns() : cells(); }
  [[nodiscard]] Index rows() const { return lattice() != nullptr ? lattice()->rows() : 1; }
  /// Null if the tiles are not the cells of a lattice.
  [[nodiscard]] const Lattice* lattice() const { return std::get_if<Lattice>(&shape_); }
  /// Null if the tiles are not the leaves of a quadtree.
  [[nodiscard]] const Quadtree* quadtree() const { return std::get_if<Quadtree>(&shape_); }

 private:
  std::variant<Lattice, Quadtree> shape_;
};

}  // namespace pardel::engine
