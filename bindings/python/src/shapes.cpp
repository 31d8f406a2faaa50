#include "shapes.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pardel::python {
namespace {

/// As in pardel/shapes.py.
enum PartKind : std::int64_t { points_part, line_part, outer_ring, inner_ring };

/// A row of numbers: marker, is a hole (0 or 1), attribute, largest area, length. Not a number: there is none.
cli::ShapeProperties properties_of(const double* row) {
  cli::ShapeProperties properties;
  properties.has_marker = !std::isnan(row[0]);
  if (properties.has_marker) properties.marker = static_cast<int>(row[0]);
  properties.is_hole = row[1] != 0;
  if (!std::isnan(row[2])) properties.attribute = row[2];
  if (!std::isnan(row[3])) properties.max_area = row[3];
  if (!std::isnan(row[4])) properties.length = row[4];
  return properties;
}

py::ssize_t size(const Shapes& shapes) { return shapes.kinds.shape(0); }

std::vector<Point> points_of(const Shapes& shapes, py::ssize_t part) {
  std::vector<Point> points;
  for (std::int64_t k = *shapes.starts.data(part); k < *shapes.starts.data(part + 1); ++k)
    points.push_back({*shapes.coordinates.data(k, 0) + 0.0, *shapes.coordinates.data(k, 1) + 0.0});  // -0 becomes 0
  return points;
}

/// Adds the part, and to an outer ring the inner ones that follow it. Returns the next part.
py::ssize_t add(cli::Drawing& drawing, const Shapes& shapes, py::ssize_t part) {
  const cli::ShapeProperties properties = properties_of(shapes.properties.data(*shapes.rows.data(part), 0));
  const std::int64_t kind = *shapes.kinds.data(part);
  std::vector<Point> points = points_of(shapes, part++);
  if (kind == points_part) {
    for (const Point p : points) drawing.add_point(p, properties);
  } else if (kind == line_part) {
    drawing.add_line(points, properties);
  } else {
    std::vector<std::vector<Point>> rings = {std::move(points)};
    for (; part < size(shapes) && *shapes.kinds.data(part) == inner_ring; ++part)
      rings.push_back(points_of(shapes, part));
    drawing.add_polygon(std::move(rings), properties);
  }
  return part;
}

}  // namespace

std::optional<std::size_t> first_hole_outside(const Shapes& shapes) {
  std::vector<Point> outline;
  for (py::ssize_t part = 0; part < size(shapes); ++part) {
    const std::int64_t kind = *shapes.kinds.data(part);
    if (kind == outer_ring) outline = points_of(shapes, part);
    if (kind == inner_ring && cli::lies_outside(points_of(shapes, part), outline)) return part;
  }
  return {};
}

cli::DrawnDomain drawing_of(const Shapes& shapes) {
  cli::Drawing drawing;
  for (py::ssize_t part = 0; part < size(shapes);) part = add(drawing, shapes, part);
  return std::move(drawing).take();
}

}  // namespace pardel::python
