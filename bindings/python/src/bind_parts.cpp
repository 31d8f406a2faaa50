// A mesh of arrays with more than points and triangles: segments, markers, attributes and regions.
#include <pybind11/pybind11.h>

#include <algorithm>
#include <pardel/core/mesh.hpp>

#include "arrays.hpp"
#include "bind.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

/// A copy of a mesh of arrays with these parts, whose shapes have been checked. `markers`: of the segments;
/// `point_markers`: one per point, or none; `regions`: one per triangle, or none.
std::shared_ptr<HeldMesh> with_parts(const HeldMesh& held, const Integers& segments, const Markers& markers,
                                     const Markers& point_markers, const Numbers& attributes, const Integers& regions,
                                     const Numbers& region_attributes) {
  Mesh mesh = held.usable();
  const auto ends = segments.unchecked<2>();
  mesh.constrained_edges.clear();
  for (py::ssize_t k = 0; k < ends.shape(0); ++k)
    mesh.constrained_edges.push_back({index_of(ends(k, 0)), index_of(ends(k, 1)), no_index, markers.at(k)});
  mesh.point_markers.resize(static_cast<std::size_t>(point_markers.size()));
  std::copy_n(point_markers.data(), point_markers.size(), mesh.point_markers.begin());
  mesh.attributes_per_point = static_cast<std::size_t>(attributes.shape(1));
  mesh.point_attributes.resize(static_cast<std::size_t>(attributes.size()));
  std::copy_n(attributes.data(), attributes.size(), mesh.point_attributes.begin());
  mesh.region.resize(static_cast<std::size_t>(regions.size()));
  std::transform(regions.data(), regions.data() + regions.size(), mesh.region.begin(), &index_of);
  mesh.region_attributes.assign(region_attributes.data(), region_attributes.data() + region_attributes.size());
  return std::make_shared<HeldMesh>(std::move(mesh));
}

}  // namespace

void bind_parts(py::module_& module) {
  module.def("with_parts", &with_parts, py::arg("mesh"), py::arg("segments"), py::arg("markers"),
             py::arg("point_markers"), py::arg("attributes"), py::arg("regions"), py::arg("region_attributes"));
}

}  // namespace pardel::python
