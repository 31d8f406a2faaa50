// Exact predicates and comparisons for finite doubles. Orientation and in-circle tests are CGAL's filtered predicates.
// The other functions evaluate a formula in intervals; if the intervals leave the sign open, they evaluate it in
// rational numbers. Thread-safe.
#pragma once

#include <string>

#include "../../../core/pslg.hpp"
#include "units.hpp"

namespace pardel::checker::exactly {

/// +1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear.
[[nodiscard]] int orientation(Point a, Point b, Point c);

/// +1 if d lies strictly inside the circumcircle of a, b, c, -1 outside, 0 on it. Precondition: a, b, c are
/// counter-clockwise.
[[nodiscard]] int in_circle(Point a, Point b, Point c, Point d);

/// True if the cosine of the angle at `corner` between the rays to a and b is greater than `bound` (0 <= bound).
[[nodiscard]] bool cosine_exceeds(Point corner, Point a, Point b, double bound);

/// True if the area of the counter-clockwise triangle is greater than `bound`.
[[nodiscard]] bool area_exceeds(Point a, Point b, Point c, double bound);

/// True if |ab| > bound (0 <= bound).
[[nodiscard]] bool length_exceeds(Point a, Point b, double bound);

/// The sign of |ab| - |cd|.
[[nodiscard]] int compare_lengths(Point a, Point b, Point c, Point d);

/// True if |cp| and |cq| differ by more than relative * max(|cp|, |cq|) + absolute (0 <= relative <= 1, 0 <= absolute).
[[nodiscard]] bool distances_differ(Point c, Point p, Point q, double relative, double absolute);

/// True if the circumradius of the counter-clockwise triangle is greater than `bound` (0 <= bound).
[[nodiscard]] bool circumradius_exceeds(Point a, Point b, Point c, double bound);

/// True if p is further from the line through a and b than an error of `units` in its coordinates can explain:
/// |cross(b - a, p - a)| > units.x * |b.y - a.y| + units.y * |b.x - a.x|.
[[nodiscard]] bool line_offset_exceeds(Point p, Point a, Point b, Units units);

/// The tangent of the least angle across a shell, sin θ / (2 - cos θ), where θ is the angle at the apex between p and
/// q. Its relative error is a few roundings.
[[nodiscard]] double tangent_across_shell(Point apex, Point p, Point q);

/// True if the tangent of the acute angle at `corner` between p and q is less than `bound` (0 <= bound), whatever the
/// errors of p and q are, up to `error` in each coordinate: |cross| + error * (|p - corner| + |q - corner|) < bound *
/// dot, where distances are sums of absolute coordinates.
[[nodiscard]] bool tangent_is_below(Point corner, Point p, Point q, double bound, double error);

/// The sign of (to - from) . (b - a): positive if a step from `from` to `to` goes forward along ab.
[[nodiscard]] int progress(Point from, Point to, Point a, Point b);

/// Exact values as text, for witnesses: the fraction if it has at most 40 characters, else its leading digits.
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
