// Draws segments or constrained edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "canvas.hpp"
#include "colour.hpp"

namespace pardel::cli {

/// Calls add(item) for every item, and draw() after every 20,000 of them and at the end. A path of an SVG is one
/// attribute, and readers of XML refuse an attribute of more than 10 MB.
template <class Items, class Add, class Draw>
void in_parts(const Items& items, const Add& add, const Draw& draw) {
  constexpr std::size_t part = 20'000;
  std::size_t added = 0;
  for (const auto& item : items) {
    add(item);
    if (++added % part == 0) draw();
  }
  draw();
}

/// Lines are thinner if there are so many that they would cover a large part of the drawing.
template <class Edges>
void draw_lines(Canvas& canvas, const Edges& edges, std::span<const Point> points) {
  constexpr double most_ink = 0.08;  // of the area of the drawing
  double total = canvas.unit();
  for (const auto& edge : edges) {
    const Point a = points[edge.a], b = points[edge.b];
    if (canvas.contains(a) || canvas.contains(b)) total += canvas.scale() * std::hypot(b.x - a.x, b.y - a.y);
  }
  const double area = std::max(canvas.width(), canvas.unit()) * std::max(canvas.height(), canvas.unit());
  const double width = std::clamp(most_ink * area / total, 0.2 * canvas.unit(), 1.8 * canvas.unit());
  in_parts(
      edges, [&](const auto& edge) { canvas.add_line(points[edge.a], points[edge.b]); },
      [&, width] { canvas.stroke(segment_colour, width); });
}

}  // namespace pardel::cli
