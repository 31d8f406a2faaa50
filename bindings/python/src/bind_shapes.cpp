// Domains of points, lines and polygons: the shapes that a program of geometry or of geographic data has.
#include <pybind11/pybind11.h>

#include <memory>
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

}  // namespace

void bind_shapes(py::module_& module) {
  py::class_<Shapes>(module, "Shapes")
      .def(py::init([](Numbers coordinates, Integers starts, Integers kinds, Integers rows, Numbers properties) {
             return Shapes{std::move(coordinates), std::move(starts), std::move(kinds), std::move(rows),
                           std::move(properties)};
           }),
           py::arg("coordinates"), py::arg("starts"), py::arg("kinds"), py::arg("rows"), py::arg("properties"));
  module.def("domain_of_shapes", &domain_of_shapes, py::arg("shapes"));
}

}  // namespace pardel::python
