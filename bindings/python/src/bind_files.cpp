// Files: reads and writes all formats of the library.
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <pardel/core/formats.hpp>
#include <string>
#include <variant>

#include "../../../cli/read_geojson.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

std::variant<Pslg, Mesh> domain_or_mesh(const std::filesystem::path& file, Call& call) {
  if (cli::is_geojson(file)) return value_of(cli::read_geojson(file, call.question()));
  return value_of(read_pslg_or_mesh(file, call.question()));
}

/// A Pslg or a HeldMesh.
py::object read_file(const std::filesystem::path& file) {
  Call call;
  std::variant<Pslg, Mesh> read = call.run([&] { return domain_or_mesh(file, call); });
  if (Pslg* domain = std::get_if<Pslg>(&read)) return py::cast(std::make_shared<Pslg>(std::move(*domain)));
  return py::cast(std::make_shared<HeldMesh>(std::move(std::get<Mesh>(read))));
}

void write_mesh_file(const std::filesystem::path& file, const HeldMesh& held, bool as_text, bool second_order) {
  const Mesh& mesh = held.usable();
  Call call;
  const MeshFileOptions options{.msh = as_text ? MshEncoding::ascii : MshEncoding::binary,
                                .elements = second_order ? ElementOrder::second : ElementOrder::first,
                                .go_on = call.question()};
  const Pslg none;
  const Pslg& domain = held.domain() ? *held.domain() : none;
  call.run([&] {
    require(write_mesh(mesh, domain, file, options));
    return Done{};
  });
}

void write_domain_file(const std::filesystem::path& file, const Pslg& domain) {
  const std::string suffix = file.extension().string();
  if (suffix != ".poly" && suffix != ".svg")
    throw Failure{
        {ErrorKind::usage, file.string() + ": '" + suffix + "' is not a format of a domain; these are .poly and .svg"}};
  Call call;
  call.run([&] {
    require(suffix == ".svg" ? write_svg(domain, file, call.question()) : write_poly(domain, file, 1, call.question()));
    return Done{};
  });
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("read", &read_file, py::arg("file"));
  module.def("write_mesh", &write_mesh_file, py::arg("file"), py::arg("mesh"), py::arg("as_text"),
             py::arg("second_order"));
  module.def("write_domain", &write_domain_file, py::arg("file"), py::arg("domain"));
}

}  // namespace pardel::python
