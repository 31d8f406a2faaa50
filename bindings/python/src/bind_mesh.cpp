// Meshes: made of arrays, shown as arrays, measured.
#include <pybind11/pybind11.h>

#include <pardel/core/digest.hpp>
#include <pardel/core/neighbours.hpp>
#include <pardel/properties/checker/statistics.hpp>

#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

HeldMesh& held(const py::object& self) { return *self.cast<HeldMesh*>(); }

/// Corners of triangles, of any integer type and layout, without a converted copy of a common type.
template <class T>
void append_triangles(const py::array& corners, Array<Triangle>& triangles) {
  const auto converted = py::array_t<T, py::array::forcecast>(corners);
  const auto rows = converted.template unchecked<2>();
  for (py::ssize_t t = 0; t < rows.shape(0); ++t) {
    Triangle& triangle = triangles[static_cast<std::size_t>(t)];
    for (py::ssize_t k = 0; k < 3; ++k) triangle.v[static_cast<std::size_t>(k)] = index_of(std::int64_t{rows(t, k)});
  }
}

/// The shapes have been checked.
std::shared_ptr<HeldMesh> make_mesh(const Numbers& points, const py::array& corners) {
  Mesh mesh;
  mesh.points.resize_uninitialised(static_cast<std::size_t>(points.shape(0)));
  copy_points(points, mesh.points.data());
  mesh.triangles.resize(static_cast<std::size_t>(corners.shape(0)));
  if (py::isinstance<py::array_t<std::int32_t>>(corners))
    append_triangles<std::int32_t>(corners, mesh.triangles);
  else
    append_triangles<std::int64_t>(corners, mesh.triangles);
  if (!can_be_a_mesh(mesh.triangles.size())) throw Failure{{ErrorKind::resources, "the mesh has too many triangles"}};
  // Otherwise the triangles have no neighbours, and only check() is of use.
  if (has_indices_in_range(mesh)) Call().run([&] { return rebuild_neighbours(mesh.triangles, mesh.points.size()); });
  return std::make_shared<HeldMesh>(std::move(mesh));
}

py::array points(const py::object& self) {
  const Array<Point>& all = held(self).any().points;
  return view(all.empty() ? nullptr : &all[0].x, all.size(), 2, sizeof(Point), self);
}
py::array triangles(const py::object& self) {
  const Array<Triangle>& all = held(self).any().triangles;
  return view(all.empty() ? nullptr : as_signed(all[0].v.data()), all.size(), 3, sizeof(Triangle), self);
}
py::array neighbors(const py::object& self) {
  const Array<Triangle>& all = held(self).any().triangles;
  return view(all.empty() ? nullptr : as_signed(all[0].n.data()), all.size(), 3, sizeof(Triangle), self);
}
py::array edges(const py::object& self) {
  const auto all = held(self).edges();
  return view(all.empty() ? nullptr : as_signed(&all[0].a), all.size(), 2, sizeof(MarkedEdge), self);
}
py::array edge_markers(const py::object& self) {
  const auto all = held(self).edges();
  return view(all.empty() ? nullptr : &all[0].marker, all.size(), sizeof(MarkedEdge), self);
}
py::array segments(const py::object& self) {
  const auto& all = held(self).any().constrained_edges;
  return view(all.empty() ? nullptr : as_signed(&all[0].a), all.size(), 2, sizeof(ConstrainedEdge), self);
}
py::array segment_markers(const py::object& self) {
  const auto& all = held(self).any().constrained_edges;
  return view(all.empty() ? nullptr : &all[0].marker, all.size(), sizeof(ConstrainedEdge), self);
}
py::array segment_ids(const py::object& self) {
  const auto& all = held(self).any().constrained_edges;
  return view(all.empty() ? nullptr : as_signed(&all[0].segment), all.size(), sizeof(ConstrainedEdge), self);
}
py::array point_markers(const py::object& self) {
  const auto all = held(self).markers();
  return view(all.data(), all.size(), sizeof(int), self);
}
py::array regions(const py::object& self) {
  const Array<Index>& all = held(self).any().region;
  return view(as_signed(all.data()), all.size(), sizeof(Index), self);
}
py::array region_attributes(const py::object& self) {
  const auto& all = held(self).any().region_attributes;
  return view(all.data(), all.size(), sizeof(double), self);
}
py::array attributes(const py::object& self) {
  const Mesh& mesh = held(self).any();
  const std::size_t columns = mesh.attributes_per_point;
  return view(mesh.point_attributes.data(), mesh.points.size(), columns, columns * sizeof(double), self);
}

py::dict statistics_of(const HeldMesh& mesh) {
  const Mesh& usable = mesh.usable();
  const MeshStatistics found = Call().run([&] { return statistics(usable); });
  py::dict result;
  result["vertices"] = found.vertices;
  result["triangles"] = found.triangles;
  result["min_angle"] = found.min_angle_deg;
  result["max_angle"] = found.max_angle_deg;
  result["max_circumradius"] = found.max_circumradius;
  result["area"] = found.area;
  return result;
}

std::string digest_of(const HeldMesh& mesh) {
  const Mesh& usable = mesh.usable();
  return to_string(Call().run([&] { return digest(usable); }));
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<HeldMesh, std::shared_ptr<HeldMesh>>(module, "HeldMesh")
      .def(py::init(&make_mesh), py::arg("points"), py::arg("triangles"))
      .def_property_readonly("points", &points)
      .def_property_readonly("triangles", &triangles)
      .def_property_readonly("neighbors", &neighbors)
      .def_property_readonly("edges", &edges)
      .def_property_readonly("edge_markers", &edge_markers)
      .def_property_readonly("segments", &segments)
      .def_property_readonly("segment_markers", &segment_markers)
      .def_property_readonly("segment_ids", &segment_ids)
      .def_property_readonly("point_markers", &point_markers)
      .def_property_readonly("regions", &regions)
      .def_property_readonly("region_attributes", &region_attributes)
      .def_property_readonly("attributes", &attributes)
      .def_property_readonly("domain",
                             [](const HeldMesh& mesh) {
                               return std::const_pointer_cast<Pslg>(mesh.domain());  // Python's side changes no domain
                             })
      .def("statistics", &statistics_of)
      .def("digest", &digest_of);
}

}  // namespace pardel::python
