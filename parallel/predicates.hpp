// Exact signs of the two geometric predicates. A floating-point filter answers almost always; where it
// cannot, the determinant is evaluated exactly with floating-point expansions (Shewchuk, "Adaptive
// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997).
//
// The result is the exact sign for coordinates that are zero or satisfy
// smallest_coordinate <= |x| <= largest_coordinate; validate() checks that of the input and snapped()
// keeps it for computed points. The code must be compiled without -ffast-math and with -ffp-contract=off.
#pragma once

#include <cmath>

#include "../core/mutants.hpp"
#include "../core/pslg.hpp"

namespace pardel {

inline constexpr double largest_coordinate = 0x1p200;
inline constexpr double smallest_coordinate = 0x1p-140;

/// True for the coordinates that the predicates are exact for; false for NaN and infinity.
[[nodiscard]] inline bool is_usable(double x) {
  return x == 0 || (std::abs(x) >= smallest_coordinate && std::abs(x) <= largest_coordinate);
}
[[nodiscard]] inline bool is_usable(Point p) { return is_usable(p.x) && is_usable(p.y); }

namespace exact {
[[nodiscard]] double orient2d(Point a, Point b, Point c);
[[nodiscard]] double incircle(Point a, Point b, Point c, Point d);
}  // namespace exact

/// Positive when a, b, c make a left turn (counter-clockwise), negative for a right turn, zero if and only
/// if exactly collinear. Swapping two arguments flips the sign. The magnitude approximates twice the area.
[[nodiscard]] inline double orient2d(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  // 3 + 16 eps of Shewchuk's ccwerrboundA, on |left| + |right| whatever their signs.
  constexpr double bound = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;
  if (std::abs(det) > bound * (std::abs(left) + std::abs(right))) return det;
  if (mutated("orient2d_trusts_its_filter")) return det;
  return exact::orient2d(a, b, c);
}

/// For counter-clockwise a, b, c: positive when d lies strictly inside their circumcircle, negative
/// outside, zero if and only if exactly cocircular. Swapping two of a, b, c flips the sign.
[[nodiscard]] inline double incircle(Point a, Point b, Point c, Point d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc1 = bdx * cdy, bc2 = bdy * cdx;
  const double ca1 = cdx * ady, ca2 = cdy * adx;
  const double ab1 = adx * bdy, ab2 = ady * bdx;
  const double alift = adx * adx + ady * ady;
  const double blift = bdx * bdx + bdy * bdy;
  const double clift = cdx * cdx + cdy * cdy;
  const double det = alift * (bc1 - bc2) + blift * (ca1 - ca2) + clift * (ab1 - ab2);
  // Shewchuk's iccerrboundA is (10 + 96 eps) times the permanent, the sum of alift (|bc1| + |bc2|) and its like.
  // By Cauchy and Schwarz |bc1| + |bc2| <= (blift + clift) / 2, so this sum is no smaller, and cheaper.
  const double permanent = alift * blift + blift * clift + clift * alift;
  constexpr double bound = 11.0 * 0x1p-53;
  if (mutated("incircle_sign_flipped")) return -det;
  if (std::abs(det) > bound * permanent) return det;
  if (mutated("incircle_trusts_its_filter")) return det;
  return exact::incircle(a, b, c, d);
}

/// A computed coordinate below smallest_coordinate is noise of a cancellation: zero.
[[nodiscard]] inline double snapped(double x) { return std::abs(x) < smallest_coordinate ? 0.0 : x; }

}  // namespace pardel
