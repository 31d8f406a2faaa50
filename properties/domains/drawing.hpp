// Drawing domains: points on a fine dyadic lattice, arcs as chords, paths that become segments.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::domains {

/// To the lattice of all computed coordinates, 2^-30: fine enough to be invisible, and coarse enough that
/// platforms whose sine differs in the last bit still make the same domain.
[[nodiscard]] Point snapped(double x, double y);
[[nodiscard]] Point on_circle(Point centre, double radius, double degrees);
/// Counter-clockwise, the first point to the right of the centre.
[[nodiscard]] std::vector<Point> circle(Point centre, double radius, int pieces);
[[nodiscard]] std::vector<Point> rectangle(double left, double bottom, double right, double top);

/// A polygonal path, drawn stroke by stroke.
struct Path {
  std::vector<Point> points;

  Path& to(double x, double y);
  /// `pieces` chords; turns left when `to_deg` is larger. The first point is joined to what was drawn before.
  Path& arc(Point centre, double radius, double from_deg, double to_deg, int pieces);
};

/// Adds points; returns the index of the first.
Index add_points(Pslg& pslg, const std::vector<Point>& points);
/// Adds points and the segments that join each to the next, and for a closed path the last to the first.
void add_open(Pslg& pslg, const std::vector<Point>& points, int marker = 0);
void add_closed(Pslg& pslg, const std::vector<Point>& points, int marker = 0);

}  // namespace pardel::domains
