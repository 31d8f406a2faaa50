// Domains of points, lines and polygons: the shapes that a program of geometry or of geographic data has.
#include <pybind11/pybind11.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "../../../cli/drawn_domain.hpp"
#include "../../../cli/place_seeds.hpp"
#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

/// As in pardel/geometry.py.
enum PartKind : std::int64_t { points_part, line_part, outer_ring, inner_ring };

/// A row of numbers: marker, is a hole (0 or 1), attribute, largest area. Not a number: there is none.
cli::ShapeProperties properties_of(const double* row) {
  cli::ShapeProperties properties;
  properties.has_marker = !std::isnan(row[0]);
  if (properties.has_marker) properties.marker = static_cast<int>(row[0]);
  properties.is_hole = row[1] != 0;
  if (!std::isnan(row[2])) properties.attribute = row[2];
  if (!std::isnan(row[3])) properties.max_area = row[3];
  return properties;
}

/// Parts of shapes: the coordinates of all; where each part begins, and the end; its kind; its row of properties.
struct Parts {
  const Numbers& coordinates;
  const Integers& starts;
  const Integers& kinds;
  const Integers& rows;
  const Numbers& properties;

  [[nodiscard]] py::ssize_t size() const { return kinds.shape(0); }
  [[nodiscard]] std::vector<Point> points(py::ssize_t part) const {
    std::vector<Point> points;
    for (std::int64_t k = *starts.data(part); k < *starts.data(part + 1); ++k)
      points.push_back({*coordinates.data(k, 0) + 0.0, *coordinates.data(k, 1) + 0.0});  // -0 becomes 0
    return points;
  }
  [[nodiscard]] cli::ShapeProperties properties_at(py::ssize_t part) const {
    return properties_of(properties.data(*rows.data(part), 0));
  }
};

/// Adds the part, and to an outer ring the inner ones that follow it. Returns the next part.
py::ssize_t add(cli::Drawing& drawing, const Parts& parts, py::ssize_t part) {
  const cli::ShapeProperties properties = parts.properties_at(part);
  const std::int64_t kind = *parts.kinds.data(part);
  std::vector<Point> points = parts.points(part++);
  if (kind == points_part) {
    for (const Point p : points) drawing.add_point(p, properties);
  } else if (kind == line_part) {
    drawing.add_line(points, properties);
  } else {
    std::vector<std::vector<Point>> rings = {std::move(points)};
    for (; part < parts.size() && *parts.kinds.data(part) == inner_ring; ++part) rings.push_back(parts.points(part));
    drawing.add_polygon(std::move(rings), properties);
  }
  return part;
}

/// Shapes and values have been checked.
std::shared_ptr<Pslg> domain_of_shapes(const Numbers& coordinates, const Integers& starts, const Integers& kinds,
                                       const Integers& rows, const Numbers& properties) {
  const Parts parts{coordinates, starts, kinds, rows, properties};
  Pslg domain = Call().run([&] {
    cli::Drawing drawing;
    for (py::ssize_t part = 0; part < parts.size();) part = add(drawing, parts, part);
    return cli::place_seeds(std::move(drawing).take());
  });
  return std::make_shared<Pslg>(std::move(domain));
}

}  // namespace

void bind_shapes(py::module_& module) {
  module.def("domain_of_shapes", &domain_of_shapes, py::arg("coordinates"), py::arg("starts"), py::arg("kinds"),
             py::arg("rows"), py::arg("properties"));
}

}  // namespace pardel::python
