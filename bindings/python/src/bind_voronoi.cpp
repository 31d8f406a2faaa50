// What the Voronoi diagram needs of exact arithmetic.
#include <pybind11/pybind11.h>

#include <pardel/core/mesh.hpp>

#include "../../../parallel/arithmetic/predicates.hpp"
#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

/// For each side of each triangle: is there a triangle across it, and do all four points lie on one circle? Exact.
py::array_t<bool> cocircular_sides(const HeldMesh& held) {
  const Mesh& mesh = held.usable();
  const auto count = static_cast<py::ssize_t>(mesh.triangles.size());
  py::array_t<bool> sides({count, py::ssize_t{3}});
  bool* const to = sides.mutable_data();
  Call().run([&] {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Triangle& triangle = mesh.triangles[t];
        to[3 * t + i] = false;
        if (triangle.n[i] == no_index) continue;
        const Triangle& other = mesh.triangles[triangle.n[i]];
        std::size_t apex = 0;
        while (other.v[apex] == triangle.v[(i + 1) % 3] || other.v[apex] == triangle.v[(i + 2) % 3]) ++apex;
        const auto corner = [&](std::size_t k) { return mesh.points[triangle.v[k]]; };
        to[3 * t + i] = engine::incircle(corner(0), corner(1), corner(2), mesh.points[other.v[apex]]) == 0;
      }
    return 0;
  });
  return sides;
}

}  // namespace

void bind_voronoi(py::module_& module) { module.def("cocircular_sides", &cocircular_sides, py::arg("mesh")); }

}  // namespace pardel::python
