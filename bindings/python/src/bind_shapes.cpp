// Domains of points, lines and polygons: the shapes that a program of geometry or of geographic data has.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>

#include "../../../cli/place_seeds.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "shapes.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

std::shared_ptr<Pslg> domain_of_shapes(const Shapes& shapes) {
  return std::make_shared<Pslg>(Call().run([&] { return cli::place_seeds(drawing_of(shapes)); }));
}

/// The part that is a hole outside its outline, if there is one.
std::optional<std::size_t> hole_outside(const Shapes& shapes) {
  return Call().run([&] { return first_hole_outside(shapes); });
}

}  // namespace

void bind_shapes(py::module_& module) {
  py::class_<Shapes>(module, "Shapes")
      .def(py::init([](Numbers coordinates, Integers starts, Integers kinds, Integers rows, Numbers properties) {
             return Shapes{std::move(coordinates), std::move(starts), std::move(kinds), std::move(rows),
                           std::move(properties)};
           }),
           py::arg("coordinates"), py::arg("starts"), py::arg("kinds"), py::arg("rows"), py::arg("properties"));
  module.def(
      "lies_outside",
      [](const Numbers& hole, const Numbers& outline) {
        return cli::lies_outside(points_of(hole), points_of(outline));
      },
      py::arg("hole"), py::arg("outline"));
  module.def("hole_outside", &hole_outside, py::arg("shapes"));
  module.def("domain_of_shapes", &domain_of_shapes, py::arg("shapes"));
}

}  // namespace pardel::python
