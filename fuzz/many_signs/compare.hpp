// Compares the predicates of the mesher and of the checker with exact signs.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "../../parallel/arithmetic/predicates.hpp"
#include "points.hpp"

namespace pardel::fuzz {

/// What was compared, and the first difference.
struct Comparison {
  std::uint64_t orientations = 0, incircles = 0;  ///< calls whose sign was compared
  std::uint64_t filters = 0;                      ///< filters of the checker that said yes, and were right
  std::uint64_t zeros = 0, exact = 0;             ///< signs that are zero; signs that needed whole numbers of any size
  /// By exact::Stage: the stage that decided orient2d and incircle, where all stages were asked.
  std::array<std::uint64_t, 5> orient2d_stages{}, incircle_stages{};
  std::uint64_t differences = 0;
  std::string first_difference;

  void add(const Comparison& other);
};

/// The predicates of the mesher; tests put others in their place.
struct Predicates {
  double (*orient2d)(Point, Point, Point) = engine::orient2d;
  double (*incircle)(Point, Point, Point, Point) = engine::incircle;
};

/// Two calls: orient2d and incircle.
void compare(const FourPoints& points, Comparison& result, const Predicates& predicates = {});

/// All ways to ask: exchanged arguments, the exact stages with turned arguments, pairs, the exact predicates of the
/// checker and its filters.
void compare_all(const FourPoints& points, Comparison& result, const Predicates& predicates = {});

}  // namespace pardel::fuzz
