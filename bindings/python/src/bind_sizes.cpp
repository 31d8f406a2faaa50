// Rasters of edge lengths, and places with edge lengths.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <map>
#include <memory>
#include <pardel/core/formats.hpp>
#include <pardel/core/raster.hpp>
#include <variant>

#include "../../../cli/read_geojson.hpp"
#include "../../../cli/size_field.hpp"
#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "held_mesh.hpp"
#include "places.hpp"
#include "shapes.hpp"
#include "state_of_sizes.hpp"

namespace py = pybind11;

namespace pardel::python {

namespace {

/// values: row by row from south to north. first: x and y of the grid point in the south-west corner.
std::shared_ptr<Raster> make_raster(const Numbers& values, double first_x, double first_y, double step_x,
                                    double step_y) {
  return std::make_shared<Raster>(Raster{static_cast<Index>(values.shape(1)),
                                         static_cast<Index>(values.shape(0)),
                                         {first_x, first_y},
                                         step_x,
                                         step_y,
                                         {values.data(), values.data() + values.size()}});
}

std::shared_ptr<Raster> read_raster_file(const std::filesystem::path& file) {
  Call call;
  return std::make_shared<Raster>(call.run([&] { return value_of(read_raster(file, call.question())); }));
}

/// What a file of the program's option --sizes has: an array with one length per point of the domain; a Raster; or a
/// HeldMesh and an array with one length per point of it.
py::object read_sizes_file(const std::filesystem::path& file) {
  struct Read {
    cli::SizeField field;
    cli::PointSizes on_mesh;
  };
  Call call;
  Read read = call.run([&] {
    Read made{value_of(cli::read_size_field(file, call.question())), {}};
    if (const Mesh* mesh = std::get_if<Mesh>(&made.field))
      made.on_mesh = value_of(cli::sizes_at_points(*mesh, file.string()));
    return made;
  });
  const auto array = [](const cli::PointSizes& lengths) {
    return py::array_t<double>(static_cast<py::ssize_t>(lengths.size()), lengths.data());
  };
  if (Mesh* mesh = std::get_if<Mesh>(&read.field))
    return py::make_tuple(std::make_shared<HeldMesh>(std::move(*mesh)), array(read.on_mesh));
  if (Raster* raster = std::get_if<Raster>(&read.field)) return py::cast(std::make_shared<Raster>(std::move(*raster)));
  return array(std::get<cli::PointSizes>(read.field));
}

/// points: rows of x, y and length. lines: rows of two places and their lengths.
std::shared_ptr<Places> make_places(const Numbers& points, const Numbers& lines, const std::map<int, double>& markers,
                                    const std::map<double, double>& regions) {
  auto places = std::make_shared<Places>();
  places->name = "sources";
  for (py::ssize_t k = 0; k < points.shape(0); ++k)
    places->rules.points.push_back({{*points.data(k, 0), *points.data(k, 1)}, *points.data(k, 2)});
  for (py::ssize_t k = 0; k < lines.shape(0); ++k) {
    const double* row = lines.data(k, 0);
    places->drawn.sources.push_back({{row[0], row[1]}, {row[2], row[3]}, row[4], row[5]});
  }
  for (const auto& [marker, length] : markers) places->rules.markers.push_back({marker, length});
  for (const auto& [attribute, length] : regions) places->rules.regions.push_back({attribute, length});
  return places;
}

Places places_in(const std::filesystem::path& file, Call& call) {
  if (cli::is_geojson(file))
    return places_of(value_of(cli::read_drawing(file, cli::LengthProperty::read, call.question())), file.string());
  return {.rules = value_of(read_size_rules(file)), .name = file.string()};
}

std::shared_ptr<Places> read_places(const std::filesystem::path& file) {
  Call call;
  return std::make_shared<Places>(call.run([&] { return places_in(file, call); }));
}

std::shared_ptr<Places> places_of_shapes(const Shapes& shapes) {
  return std::make_shared<Places>(Call().run([&] { return places_of(drawing_of(shapes), "sources"); }));
}

}  // namespace

void bind_sizes(py::module_& module) {
  py::class_<Raster, std::shared_ptr<Raster>>(module, "Raster")
      .def(py::init(&make_raster), py::arg("values"), py::arg("first_x"), py::arg("first_y"), py::arg("step_x"),
           py::arg("step_y"))
      .def_static("read", &read_raster_file, py::arg("file"))
      .def_property_readonly("shape", [](const Raster& r) { return py::make_tuple(r.rows, r.columns); })
      .def_property_readonly(
          "extent", [](const Raster& r) { return py::make_tuple(r.low().x, r.high().x, r.low().y, r.high().y); })
      .def_property_readonly("values",
                             [](const py::object& self) {
                               const Raster& raster = *self.cast<const Raster*>();
                               return view(raster.values.data(), raster.rows, raster.columns,
                                           raster.columns * sizeof(double), self);
                             })
      .def(py::pickle(&state_of_raster, &raster_of_state));
  py::class_<Places, std::shared_ptr<Places>>(module, "Places")
      .def(py::init(&make_places), py::arg("points"), py::arg("lines"), py::arg("markers"), py::arg("regions"))
      .def_static("read", &read_places, py::arg("file"))
      .def_static("of_shapes", &places_of_shapes, py::arg("shapes"))
      .def("__len__",
           [](const Places& places) {
             const SizeRules& rules = places.rules;
             return rules.points.size() + rules.markers.size() + rules.regions.size() + places.drawn.sources.size();
           })
      .def(py::pickle(&state_of_places, &places_of_state));
  module.def("read_sizes", &read_sizes_file, py::arg("file"));
}

}  // namespace pardel::python
