// Paths: polygonal paths with arcs, from which the segments of a Pslg are made. Coordinates are multiples of 2^-30.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::domains {

/// Rounds to multiples of 2^-30, as all computed coordinates are. This spacing is too small to be visible, but large
/// enough that platforms whose sines differ in the last bit make the same domain.
[[nodiscard]] Point snapped(double x, double y);
/// The snapped point on a circle at an angle; 0 degrees lies to the right of the centre.
[[nodiscard]] Point on_circle(Point centre, double radius, double degrees);
/// The corners of an inscribed regular polygon, counter-clockwise from the right of the centre.
[[nodiscard]] std::vector<Point> circle(Point centre, double radius, int pieces);
/// The corners of a rectangle, counter-clockwise from the lower left corner.
[[nodiscard]] std::vector<Point> rectangle(double left, double bottom, double right, double top);

/// A polygonal path. Each function appends to it and returns it.
struct Path {
  std::vector<Point> points;

  /// Appends a straight line to the snapped point; nothing if the path already ends there.
  Path& to(double x, double y);
  /// Appends an arc of `pieces` chords; a straight line joins it to the path. The arc turns left if to_deg > from_deg.
  Path& arc(Point centre, double radius, double from_deg, double to_deg, int pieces);
};

/// Appends points and returns the index of the first.
Index add_points(Pslg& pslg, const std::vector<Point>& points);
/// Appends points and the segments from each point to the next; add_closed() also joins the last point to the first.
void add_open(Pslg& pslg, const std::vector<Point>& points, int marker = 0);
void add_closed(Pslg& pslg, const std::vector<Point>& points, int marker = 0);

}  // namespace pardel::domains
