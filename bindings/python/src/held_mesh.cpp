#include "held_mesh.hpp"

#include <pybind11/pybind11.h>

#include <algorithm>

#include "errors.hpp"

namespace py = pybind11;

namespace pardel::python {
bool has_indices_in_range(const Mesh& mesh) {
  const auto is_point = [&](Index v) { return v < mesh.points.size(); };
  return std::ranges::all_of(mesh.triangles, [&](const Triangle& t) { return std::ranges::all_of(t.v, is_point); }) &&
         std::ranges::all_of(mesh.constrained_edges,
                             [&](const ConstrainedEdge& e) { return is_point(e.a) && is_point(e.b); });
}

HeldMesh::HeldMesh(Mesh mesh, std::shared_ptr<const Pslg> domain)
    : mesh_(std::move(mesh)), domain_(std::move(domain)), is_usable_(has_indices_in_range(mesh_)) {}

const Mesh& HeldMesh::usable() const {
  if (is_usable_) return mesh_;
  throw Failure{{ErrorKind::invalid_input, "the mesh has an index that is not the index of a point"}};
}

std::span<const MarkedEdge> HeldMesh::edges() {
  const Mesh& mesh = usable();
  const py::gil_scoped_release released;
  std::call_once(edges_once_, [&] { edges_ = {.edges = edge_table(mesh).edges, .edge_of_side = {}}; });
  return edges_.edges.span();
}

std::span<const int> HeldMesh::markers() {
  const Mesh& mesh = usable();
  const py::gil_scoped_release released;
  std::call_once(markers_once_, [&] { markers_ = vertex_markers(mesh, inferred_markers_); });
  return markers_;
}

const Locator& HeldMesh::locator(const LocatorOptions& options) {
  const Mesh& mesh = usable();
  const std::scoped_lock lock(locator_once_);
  if (!locator_) locator_.emplace(value_of(Locator::over(mesh, options)));
  return *locator_;
}

}  // namespace pardel::python
