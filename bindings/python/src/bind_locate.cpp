// Locates points in a mesh, and interpolates there.
#include <pybind11/pybind11.h>

#include <pardel/parallel/locator.hpp>

#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

/// The rows of an array of shape (n, 2), without a copy.
std::span<const Point> as_points(const Numbers& rows) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  return {reinterpret_cast<const Point*>(rows.data()), static_cast<std::size_t>(rows.shape(0))};
}

py::array_t<std::int32_t> locate(HeldMesh& mesh, const Numbers& points, int threads) {
  py::array_t<std::int32_t> result(points.shape(0));
  const std::span<Index> found(reinterpret_cast<Index*>(result.mutable_data()),
                               static_cast<std::size_t>(result.size()));
  Call call;
  call.run([&] {
    const LocatorOptions options{.threads = threads, .go_on = call.question()};
    return value_of(mesh.locator(options).triangles_at(as_points(points), found, options));
  });
  return result;
}

/// values: shape (n, k). Returns an array with one row per point.
py::array_t<double> interpolate(HeldMesh& mesh, const Numbers& values, const Numbers& points, double outside,
                                int threads) {
  py::array_t<double> result({points.shape(0), values.shape(1)});
  const std::span<const double> given(values.data(), static_cast<std::size_t>(values.size()));
  const std::span<double> found(result.mutable_data(), static_cast<std::size_t>(result.size()));
  const auto columns = static_cast<std::size_t>(values.shape(1));
  Call call;
  call.run([&] {
    const LocatorOptions options{.threads = threads, .go_on = call.question()};
    return value_of(mesh.locator(options).interpolate(given, columns, as_points(points), found, outside, options));
  });
  return result;
}

}  // namespace

void bind_locate(py::module_& module) {
  module.def("locate", &locate, py::arg("mesh"), py::arg("points"), py::arg("threads"));
  module.def("interpolate", &interpolate, py::arg("mesh"), py::arg("values"), py::arg("points"), py::arg("outside"),
             py::arg("threads"));
}

}  // namespace pardel::python
