// The numbers that the vertices of pieces have in the whole mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../../../core/ranks.hpp"
#include "../../../core/result.hpp"
#include "../model/adjacency.hpp"
#include "../model/number_set.hpp"

namespace pardel::checker {

/// A vertex, and its number in the whole mesh.
struct NumberedPoint {
  std::uint64_t number;
  Point at;
};

/// The numbers in the pieces of one rank.
class NumbersOfRank {
 public:
  /// Counts those of a piece.
  void count(std::span<const std::uint64_t> number);
  /// Adds the vertices of a piece, in which no two vertices have one number, after count().
  void add(std::span<const std::uint64_t> number, const Adjacency& adjacency);

  [[nodiscard]] std::uint64_t listed() const { return listed_; }
  [[nodiscard]] std::uint64_t largest() const { return largest_; }
  /// The numbers of vertices in the interior of a piece. Numbers that no mesh can have are left out.
  [[nodiscard]] const NumberSet& inner() const { return inner_; }
  /// Those in the interiors of several pieces.
  [[nodiscard]] const std::vector<std::uint64_t>& repeated() const { return repeated_; }

 private:
  std::uint64_t listed_ = 0, largest_ = 0;
  NumberSet inner_;
  std::vector<std::uint64_t> repeated_;
};

/// Returns the vertices with these numbers, which are sorted, in all pieces of the rank.
using FindPoints = std::function<Result<std::vector<NumberedPoint>>(const std::vector<std::uint64_t>& numbers)>;

/// The number of points of the whole mesh, which is the largest number plus one, by count() alone. Collective.
///
/// Errors: invalid_input if all pieces together have fewer points; resources if there are more than an Index can
/// number.
[[nodiscard]] Result<std::uint64_t> count_points(const NumbersOfRank& here, Ranks& ranks);

/// Returns count_points(), after a comparison of the pieces. Collective; an error is the same on all ranks. Each number
/// must belong to one vertex, with the same coordinates in all pieces that have it. `border`: the vertices that other
/// pieces may have, of all pieces of the rank. `find` is called, on all ranks alike, only if a vertex in the interior
/// of one piece is in another piece, too.
///
/// Errors: those of count_points() and of `find`; invalid_input if a number is missing or belongs to different points.
/// Memory: one bit per point of the whole mesh.
[[nodiscard]] Result<std::uint64_t> check_numbers(const NumbersOfRank& here, const std::vector<NumberedPoint>& border,
                                                  const FindPoints& find, Ranks& ranks);

}  // namespace pardel::checker
