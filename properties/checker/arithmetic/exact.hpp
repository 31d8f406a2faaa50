// Every question that the checker decides by arithmetic, each answered exactly for finite doubles: by
// CGAL's filtered predicates, or by one formula evaluated in intervals and, where these do not decide, in
// rational numbers. Thread-safe.
#pragma once

#include <string>

#include "../../../core/pslg.hpp"

namespace pardel::checker::exactly {

/// +1 when a, b, c make a left turn, -1 for a right turn, 0 if and only if collinear.
[[nodiscard]] int orientation(Point a, Point b, Point c);

/// For counter-clockwise a, b, c: +1 when d lies strictly inside their circumcircle, -1 outside, 0 on it.
[[nodiscard]] int in_circle(Point a, Point b, Point c, Point d);

/// The cosine of the angle at `corner` between the rays to a and b is greater than `bound` (0 <= bound).
[[nodiscard]] bool cosine_exceeds(Point corner, Point a, Point b, double bound);

/// The area of the counter-clockwise triangle is greater than `bound`.
[[nodiscard]] bool area_exceeds(Point a, Point b, Point c, double bound);

/// |ab| > bound (0 <= bound).
[[nodiscard]] bool length_exceeds(Point a, Point b, double bound);

/// The sign of |ab| - |cd|.
[[nodiscard]] int compare_lengths(Point a, Point b, Point c, Point d);

/// The circumradius of the counter-clockwise triangle is greater than `bound` (0 <= bound).
[[nodiscard]] bool circumradius_exceeds(Point a, Point b, Point c, double bound);

/// p is further than `bound` (0 <= bound) from the line through a and b.
[[nodiscard]] bool line_distance_exceeds(Point p, Point a, Point b, double bound);

/// The sign of (to - from) . (b - a): does a walk from `from` to `to` go forward along ab?
[[nodiscard]] int progress(Point from, Point to, Point a, Point b);

/// Witnesses: the exact value as a fraction when it is short, else its leading digits.
[[nodiscard]] std::string orientation_text(Point a, Point b, Point c);
[[nodiscard]] std::string in_circle_text(Point a, Point b, Point c, Point d);
/// The exact square of the cosine at `corner`.
[[nodiscard]] std::string squared_cosine_text(Point corner, Point a, Point b);
[[nodiscard]] std::string area_text(Point a, Point b, Point c);
[[nodiscard]] std::string squared_length_text(Point a, Point b);
[[nodiscard]] std::string squared_circumradius_text(Point a, Point b, Point c);
[[nodiscard]] std::string squared_line_distance_text(Point p, Point a, Point b);

}  // namespace pardel::checker::exactly
