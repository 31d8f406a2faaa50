#include "uniform_cells.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::schemes::cells {
namespace {

constexpr double most_cells_in_a_row = 256;

/// A lattice as plain values.
struct Grid {
  Point corner;
  double side;
  std::int64_t columns, rows;

  [[nodiscard]] std::int64_t column_of(double x) const { return index_of((x - corner.x) / side, columns); }
  [[nodiscard]] std::int64_t row_of(double y) const { return index_of((y - corner.y) / side, rows); }
  [[nodiscard]] Index number(std::int64_t i, std::int64_t j) const { return static_cast<Index>(i + j * columns); }
  [[nodiscard]] std::int64_t column(Index cell) const { return cell % columns; }
  [[nodiscard]] std::int64_t row(Index cell) const { return cell / columns; }

  [[nodiscard]] std::vector<Index> touching(Index cell) const {
    std::vector<Index> cells;
    for (std::int64_t j = row(cell) - 1; j <= row(cell) + 1; ++j)
      for (std::int64_t i = column(cell) - 1; i <= column(cell) + 1; ++i)
        if (i >= 0 && j >= 0 && i < columns && j < rows && number(i, j) != cell) cells.push_back(number(i, j));
    return cells;
  }
  /// The box is half open, so the boxes of one colour are disjoint. The outermost cells have no end outwards.
  [[nodiscard]] bool in_box(Index cell, Point p) const {
    const double x = (p.x - corner.x) / side, y = (p.y - corner.y) / side;
    return is_within(x, column(cell), columns) && is_within(y, row(cell), rows);
  }

 private:
  static std::int64_t index_of(double x, std::int64_t count) {
    if (!(x >= 1)) return 0;
    return x < static_cast<double>(count) ? static_cast<std::int64_t>(x) : count - 1;
  }
  static bool is_within(double x, std::int64_t k, std::int64_t count) {
    const double low = static_cast<double>(k) - 0.5, high = static_cast<double>(k) + 1.5;
    return (k == 0 || x >= low) && (k == count - 1 || x < high);
  }
};

}  // namespace

Division uniform_cells(const Extent& extent, double side, Assignment assignment, const Territory& territory) {
  const double width = extent.side();
  const bool is_one_cell = !(side <= width);
  const double used = is_one_cell ? width : std::max(side, width / most_cells_in_a_row);
  const auto count = [&](double length) {
    return is_one_cell ? std::int64_t{1} : static_cast<std::int64_t>(std::floor(length / used)) + 1;
  };
  const Grid grid{extent.low, used, count(extent.width()), count(extent.height())};

  Division division;
  division.colours = 4;
  for (std::int64_t j = 0; j < grid.rows; ++j)
    for (std::int64_t i = 0; i < grid.columns; ++i) division.colour.push_back(static_cast<int>((i & 1) + 2 * (j & 1)));
  division.cell_of = [grid](Point p) { return grid.number(grid.column_of(p.x), grid.row_of(p.y)); };
  division.touching = [grid](Index cell) { return grid.touching(cell); };
  division.in_box = [grid](Index cell, Point p) { return grid.in_box(cell, p); };
  division.allows = [](Point, double) { return true; };
  // The four cells of a block have four colours, so their worker has one in each phase.
  assign(division, assignment, territory, [&](Index cell) {
    const auto middle = [&](std::int64_t k) { return static_cast<double>((k & ~std::int64_t{1}) + 1) * used; };
    return Point{grid.corner.x + middle(grid.column(cell)), grid.corner.y + middle(grid.row(cell))};
  });
  return division;
}

}  // namespace pardel::schemes::cells
