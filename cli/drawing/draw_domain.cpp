#include "draw_domain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "draw_lines.hpp"

namespace pardel::cli {
namespace {

constexpr Colour point_colour{0.125, 0.314, 0.565};
constexpr Colour hole_colour{0.753, 0.125, 0.125};
constexpr Colour region_colour{0.125, 0.502, 0.251};

void set_colour(Canvas& canvas, Colour colour) {
  cairo_set_source_rgb(canvas.context(), colour.red, colour.green, colour.blue);
}

/// Many points get smaller dots, so that together they cover at most a tenth of the drawing.
double radius_of_dots(const Canvas& canvas, std::size_t points) {
  const double area = std::max(canvas.width() * canvas.height(), canvas.unit());
  const double fitting =
      std::sqrt(0.1 * area / (std::numbers::pi * static_cast<double>(std::max<std::size_t>(points, 1))));
  return std::clamp(fitting, 0.4 * canvas.unit(), 3 * canvas.unit());
}

void draw_regions(Canvas& canvas, const Pslg& pslg) {
  cairo_set_font_size(canvas.context(), 16 * canvas.unit());
  for (const Region& region : pslg.regions) {
    if (!canvas.contains(region.seed)) continue;
    const Point place = canvas.at(region.seed);
    draw_diamond(canvas, place);
    cairo_move_to(canvas.context(), place.x + 10 * canvas.unit(), place.y + 5 * canvas.unit());
    cairo_show_text(canvas.context(), fmt::format("{:g}", region.attribute).c_str());
    cairo_new_path(canvas.context());
  }
}

}  // namespace

void draw_dot(Canvas& canvas, Point place, double radius) {
  cairo_move_to(canvas.context(), place.x, place.y);
  cairo_line_to(canvas.context(), place.x, place.y);
  canvas.stroke(point_colour, 2 * radius);
}

void draw_cross(Canvas& canvas, Point place) {
  const double arm = 6 * canvas.unit();
  for (const double side : {-arm, arm}) {
    cairo_move_to(canvas.context(), place.x - arm, place.y - side);
    cairo_line_to(canvas.context(), place.x + arm, place.y + side);
  }
  canvas.stroke(hole_colour, 2.5 * canvas.unit());
}

void draw_diamond(Canvas& canvas, Point place) {
  const double half = 6.5 * canvas.unit();
  cairo_move_to(canvas.context(), place.x, place.y - half);
  cairo_line_to(canvas.context(), place.x + half, place.y);
  cairo_line_to(canvas.context(), place.x, place.y + half);
  cairo_line_to(canvas.context(), place.x - half, place.y);
  cairo_close_path(canvas.context());
  set_colour(canvas, region_colour);
  cairo_fill(canvas.context());
}

void draw_domain(Canvas& canvas, const Pslg& pslg) {
  draw_lines(canvas, pslg.segments, std::span(pslg.points));
  const double radius = radius_of_dots(canvas, pslg.points.size());
  const auto dot = [&](Point p) { canvas.add_line(p, p); };  // round line ends make it a dot
  in_parts(pslg.points, dot, [&] { canvas.stroke(point_colour, 2 * radius); });
  for (const Point hole : pslg.holes)
    if (canvas.contains(hole)) draw_cross(canvas, canvas.at(hole));
  draw_regions(canvas, pslg);
}

}  // namespace pardel::cli
