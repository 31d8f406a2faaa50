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

/// Many points get smaller dots, so that together they cover at most a tenth of the drawing.
double radius_of_dots(const Canvas& canvas, std::size_t points) {
  const double area = std::max(canvas.width() * canvas.height(), canvas.unit());
  const double fitting =
      std::sqrt(0.1 * area / (std::numbers::pi * static_cast<double>(std::max<std::size_t>(points, 1))));
  return std::clamp(fitting, 0.4 * canvas.unit(), 3 * canvas.unit());
}

void draw_regions(Canvas& canvas, const Pslg& pslg) {
  for (const Region& region : pslg.regions) {
    if (!canvas.contains(region.seed)) continue;
    const Point place = canvas.at(region.seed);
    draw_diamond(canvas, place);
    canvas.write(fmt::format("{:g}", region.attribute), {place.x + 10 * canvas.unit(), place.y + 5 * canvas.unit()},
                 16 * canvas.unit(), region_colour);
  }
}

}  // namespace

void draw_dot(Canvas& canvas, Point place, double radius) {
  canvas.move_to(place);
  canvas.line_to(place);
  canvas.stroke(point_colour, 2 * radius);
}

void draw_cross(Canvas& canvas, Point place) {
  const double arm = 6 * canvas.unit();
  for (const double side : {-arm, arm}) {
    canvas.move_to({place.x - arm, place.y - side});
    canvas.line_to({place.x + arm, place.y + side});
  }
  canvas.stroke(hole_colour, 2.5 * canvas.unit());
}

void draw_diamond(Canvas& canvas, Point place) {
  const double half = 6.5 * canvas.unit();
  canvas.move_to({place.x, place.y - half});
  canvas.line_to({place.x + half, place.y});
  canvas.line_to({place.x, place.y + half});
  canvas.line_to({place.x - half, place.y});
  canvas.close_path();
  canvas.fill_smoothly(region_colour);
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
