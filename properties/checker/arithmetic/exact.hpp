// Exact predicates and comparisons for finite doubles. Orientation and in-circle tests are CGAL's filtered predicates.
// The others evaluate a formula in intervals and, where these do not decide, in rational numbers. Thread-safe.
#pragma once

#include <string>

#include "../../../core/pslg.hpp"

namespace pardel::checker::exactly {

/// +1 where a, b, c turn left, -1 where they turn right, 0 where they are collinear.
[[nodiscard]] int orientation(Point a, Point b, Point c);

/// +1 where d lies strictly inside the circumcircle of a, b, c, -1 outside, 0 on it. Precondition: a, b, c are
/// counter-clockwise.
[[nodiscard]] int in_circle(Point a, Point b, Point c, Point d);

/// True where the cosine of the angle at `corner` between the rays to a and b is greater than `bound` (0 <= bound).
[[nodiscard]] bool cosine_exceeds(Point corner, Point a, Point b, double bound);

/// True where the area of the counter-clockwise triangle is greater than `bound`.
[[nodiscard]] bool area_exceeds(Point a, Point b, Point c, double bound);

/// True where |ab| > bound (0 <= bound).
[[nodiscard]] bool length_exceeds(Point a, Point b, double bound);

/// The sign of |ab| - |cd|.
[[nodiscard]] int compare_lengths(Point a, Point b, Point c, Point d);

/// True where the circumradius of the counter-clockwise triangle is greater than `bound` (0 <= bound).
[[nodiscard]] bool circumradius_exceeds(Point a, Point b, Point c, double bound);

/// True where p is further than `bound` (0 <= bound) from the line through a and b.
[[nodiscard]] bool line_distance_exceeds(Point p, Point a, Point b, double bound);

/// The sign of (to - from) . (b - a): positive where a step from `from` to `to` goes forward along ab.
[[nodiscard]] int progress(Point from, Point to, Point a, Point b);

/// Exact values as text, for witnesses: the fraction where it has at most 40 characters, else its leading digits.
/// orientation_text() is twice the signed area of a, b, c; in_circle_text() is the in-circle determinant.
[[nodiscard]] std::string orientation_text(Point a, Point b, Point c);
[[nodiscard]] std::string in_circle_text(Point a, Point b, Point c, Point d);
/// The exact square of the cosine at `corner`.
[[nodiscard]] std::string squared_cosine_text(Point corner, Point a, Point b);
[[nodiscard]] std::string area_text(Point a, Point b, Point c);
[[nodiscard]] std::string squared_length_text(Point a, Point b);
[[nodiscard]] std::string squared_circumradius_text(Point a, Point b, Point c);
[[nodiscard]] std::string squared_line_distance_text(Point p, Point a, Point b);

}  // namespace pardel::checker::exactly
