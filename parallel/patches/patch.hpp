// A patch: the triangles of a lattice that have all three corners in a set of places. Everything about it follows from
// a few numbers per row: which triangles exist, which of its points lie on its border, and who is whose neighbour.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "triangular_lattice.hpp"

namespace pardel::engine {

/// Consecutive triangles between row and row + 1. The triangle at x covers x to x + 2. It stands on its base (x, row),
/// (x + 2, row) if x and row are both even or both odd; otherwise it hangs from its base (x, row + 1), (x + 2, row +
/// 1). Its third corner is at x + 1.
struct Strip {
  int row = 0, low = 0, high = 0;  ///< the triangles at low, low + 1, ..., high
  std::size_t first = 0;           ///< the number of the triangle at low, among those of the patch
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(high - low) + 1; }
};

/// Consecutive points of a row, all on the border of the patch or all inside it.
struct Piece {
  int row = 0, low = 0, high = 0;  ///< the places low, low + 2, ..., high
  bool on_border = false;
  std::size_t first = 0;  ///< the number of the point at low, among the points of the patch of this kind
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(high - low) / 2 + 1; }
};

/// A side of a triangle of a patch that belongs to no other triangle of the patch. The triangle lies on its left.
struct BorderSide {
  std::size_t from = 0, to = 0;  ///< the numbers of its ends, among the points on the border
  std::size_t triangle = 0;      ///< the number of the triangle
  unsigned side = 0;             ///< the side of the triangle as lay_patches() writes it
};

/// The strips and pieces of all rows from `first_row` on.
class Patch {
 public:
  /// `places`: merged. Places that are no corner of a triangle are left out.
  Patch(const TriangularLattice& lattice, const std::vector<Span>& places);

  [[nodiscard]] const TriangularLattice& lattice() const { return lattice_; }
  [[nodiscard]] std::size_t triangles() const { return triangles_; }
  [[nodiscard]] std::size_t border_points() const { return border_points_; }
  [[nodiscard]] std::size_t inner_points() const { return inner_points_; }
  [[nodiscard]] std::span<const Strip> strips() const { return strips_; }
  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
  /// All sides on the border, strip by strip. Nearly linear in their number.
  [[nodiscard]] std::vector<BorderSide> border() const;
  /// The strips between row and row + 1, from left to right; the pieces of a row.
  [[nodiscard]] std::span<const Strip> strips_above(int row) const { return of_row(strips_, strip_start_, row); }
  [[nodiscard]] std::span<const Piece> pieces_of(int row) const { return of_row(pieces_, piece_start_, row); }
  /// Calls visit(number) for the triangles at a place. O(log n) for n strips in its rows.
  template <class Visit>
  void for_each_triangle_at(int x, int row, const Visit& visit) const {
    for (const int above : {row - 1, row})
      for (int at = x - 2; at <= x; ++at)
        if (const auto number = triangle_at(at, above)) visit(*number);
  }

 private:
  void find_strips(const std::vector<Span>& places);
  void find_pieces();
  [[nodiscard]] std::size_t border_point(int x, int row) const;
  /// The triangle at x between row and row + 1.
  [[nodiscard]] std::optional<std::size_t> triangle_at(int x, int row) const;
  template <class T>
  [[nodiscard]] std::span<const T> of_row(const std::vector<T>& all, const std::vector<std::size_t>& start,
                                          int row) const {
    const auto r = static_cast<std::size_t>(row - first_row_);
    if (row < first_row_ || r + 1 >= start.size()) return {};
    return std::span(all).subspan(start[r], start[r + 1] - start[r]);
  }

  TriangularLattice lattice_;
  int first_row_ = 0;
  std::vector<Strip> strips_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> strip_start_, piece_start_;  ///< by row, from first_row_ on
  std::size_t triangles_ = 0, border_points_ = 0, inner_points_ = 0;
};

}  // namespace pardel::engine
