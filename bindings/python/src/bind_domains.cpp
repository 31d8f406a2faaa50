// The named domains that examples, tests and benchmarks share.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <pardel/properties/domains/domains.hpp>
#include <string>

#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

std::shared_ptr<Pslg> generate(const std::string& kind, std::uint64_t n, std::uint64_t seed) {
  return std::make_shared<Pslg>(Call().run([&] { return value_of(domains::generate(kind, n, seed)); }));
}

/// The least, the most and the usual size of each domain; None for one without sizes.
py::dict sizes_of_kinds() {
  py::dict sizes;
  for (const std::string& name : domains::names()) sizes[py::str(name)] = py::none();
  for (const domains::SizeRange& range : domains::size_ranges())
    sizes[py::str(range.name)] = py::make_tuple(range.least, range.most, range.usual);
  return sizes;
}

py::array_t<double> radial_sizes(const Pslg& radial, double ratio) {
  const std::vector<double> sizes = domains::radial_sizes(radial, ratio);
  return py::array_t<double>(static_cast<py::ssize_t>(sizes.size()), sizes.data());
}

}  // namespace

void bind_domains(py::module_& module) {
  module.def("generate", &generate, py::arg("kind"), py::arg("n"), py::arg("seed"));
  module.def("sizes_of_kinds", &sizes_of_kinds);
  module.def("radial_sizes", &radial_sizes, py::arg("radial"), py::arg("ratio"));
}

}  // namespace pardel::python
