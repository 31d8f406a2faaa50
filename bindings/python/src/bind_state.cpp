// All that a mesh has, as arrays and plain values, and a mesh of them: for pickling.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>
#include <pardel/core/neighbours.hpp>
#include <string>

#include "arrays.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

/// A copy of plain values as an array of numbers of type T. A value may consist of several.
template <class T, class Values>
py::array_t<T> numbers_of(const Values& values) {
  static_assert(sizeof(values.data()[0]) % sizeof(T) == 0);
  py::array_t<T> result(static_cast<py::ssize_t>(values.size() * sizeof(values.data()[0]) / sizeof(T)));
  if (result.size() > 0) std::memcpy(result.mutable_data(), values.data(), static_cast<std::size_t>(result.nbytes()));
  return result;
}

/// The array of this name. Its bytes are the values of the list, which has then as many as the array has room for.
template <class T, class Values>
void take(const py::dict& state, const char* name, Values& values) {
  const auto numbers = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(state[name]);
  if (!numbers) throw py::error_already_set();
  const auto bytes = static_cast<std::size_t>(numbers.nbytes());
  values.resize(bytes / sizeof(values.data()[0]));
  if (!values.empty())
    std::memcpy(static_cast<void*>(values.data()), numbers.data(), values.size() * sizeof(values.data()[0]));
}

py::list fields_of(const Mesh& mesh) {
  py::list list;
  for (const Field& field : mesh.fields)
    list.append(py::make_tuple(field.name, field.place == Field::Place::points, field.components,
                               numbers_of<double>(field.values), field.time));
  return list;
}

std::vector<Field> fields_of(const py::dict& state) {
  std::vector<Field> fields;
  for (const py::handle item : state["fields"]) {
    const auto row = item.cast<py::tuple>();
    Field field;
    field.name = row[0].cast<std::string>();
    field.place = row[1].cast<bool>() ? Field::Place::points : Field::Place::triangles;
    field.components = row[2].cast<std::size_t>();
    py::dict values;
    values["values"] = row[3];
    take<double>(values, "values", field.values);
    field.time = row[4].cast<double>();
    fields.push_back(std::move(field));
  }
  return fields;
}

py::list names_of(const Mesh& mesh) {
  py::list list;
  for (const GroupName& name : mesh.names)
    list.append(py::make_tuple(name.of == GroupName::Of::marker, name.value, name.name));
  return list;
}

py::dict state_of(const HeldMesh& held) {
  const Mesh& mesh = held.any();
  std::vector<std::array<Index, 3>> corners(mesh.triangles.size());
  for (std::size_t t = 0; t < corners.size(); ++t) corners[t] = mesh.triangles[t].v;
  py::dict state;
  state["points"] = numbers_of<double>(mesh.points);
  state["triangles"] = numbers_of<Index>(corners);
  state["origin"] = numbers_of<Index>(mesh.origin);
  state["regions"] = numbers_of<Index>(mesh.region);
  state["region_attributes"] = numbers_of<double>(mesh.region_attributes);
  state["segments"] = numbers_of<std::int32_t>(mesh.constrained_edges);
  state["attributes_per_point"] = mesh.attributes_per_point;
  state["attributes"] = numbers_of<double>(mesh.point_attributes);
  state["point_markers"] = numbers_of<std::int32_t>(mesh.point_markers);
  state["first_id"] = mesh.first_id.value;
  state["numbers_of_points"] = numbers_of<std::uint64_t>(mesh.numbers.of_points);
  state["numbers_of_triangles"] = numbers_of<std::uint64_t>(mesh.numbers.of_triangles);
  state["fields"] = fields_of(mesh);
  state["names"] = names_of(mesh);
  state["left_out"] = mesh.left_out.things();
  return state;
}

/// Other code of the library relies on these lengths.
bool has_right_lengths(const Mesh& mesh) {
  const std::size_t points = mesh.points.size(), triangles = mesh.triangles.size();
  const auto is_none_or = [](std::size_t size, std::size_t all) { return size == 0 || size == all; };
  const auto is_whole = [&](const Field& field) {
    const std::size_t count = field.place == Field::Place::points ? points : triangles;
    return field.components > 0 && field.values.size() == count * field.components;
  };
  return is_none_or(mesh.origin.size(), points) && is_none_or(mesh.region.size(), triangles) &&
         mesh.point_attributes.size() == points * mesh.attributes_per_point &&
         is_none_or(mesh.point_markers.size(), points) && is_none_or(mesh.numbers.of_points.size(), points) &&
         is_none_or(mesh.numbers.of_triangles.size(), triangles) && can_be_a_mesh(triangles) &&
         std::ranges::all_of(mesh.fields, is_whole) && std::ranges::all_of(mesh.region, [&](Index region) {
           return region == no_index || region < mesh.region_attributes.size();
         });
}

std::shared_ptr<HeldMesh> mesh_of_state(const py::dict& state, const std::shared_ptr<Pslg>& domain) {
  Mesh mesh;
  std::vector<std::array<Index, 3>> corners;
  take<double>(state, "points", mesh.points);
  take<Index>(state, "triangles", corners);
  mesh.triangles.resize(corners.size());
  for (std::size_t t = 0; t < corners.size(); ++t) mesh.triangles[t].v = corners[t];
  take<Index>(state, "origin", mesh.origin);
  take<Index>(state, "regions", mesh.region);
  take<double>(state, "region_attributes", mesh.region_attributes);
  take<std::int32_t>(state, "segments", mesh.constrained_edges);
  mesh.attributes_per_point = state["attributes_per_point"].cast<std::size_t>();
  take<double>(state, "attributes", mesh.point_attributes);
  take<std::int32_t>(state, "point_markers", mesh.point_markers);
  mesh.first_id.value = state["first_id"].cast<int>();
  take<std::uint64_t>(state, "numbers_of_points", mesh.numbers.of_points);
  take<std::uint64_t>(state, "numbers_of_triangles", mesh.numbers.of_triangles);
  mesh.fields = fields_of(state);
  for (const py::handle item : state["names"]) {
    const auto row = item.cast<py::tuple>();
    mesh.names.push_back({row[0].cast<bool>() ? GroupName::Of::marker : GroupName::Of::region, row[1].cast<int>(),
                          row[2].cast<std::string>()});
  }
  for (const py::handle thing : state["left_out"]) mesh.left_out.add(thing.cast<std::string>());
  if (!has_right_lengths(mesh))
    throw Failure{{ErrorKind::invalid_input, "the pickled mesh has arrays that do not belong together"}};
  if (has_indices_in_range(mesh)) Call().run([&] { return rebuild_neighbours(mesh.triangles, mesh.points.size()); });
  return std::make_shared<HeldMesh>(std::move(mesh), domain);
}

}  // namespace

void bind_state(py::module_& module) {
  module.def("state_of", &state_of, py::arg("mesh"));
  module.def("mesh_of_state", &mesh_of_state, py::arg("state"), py::arg("domain").none(true));
  module.def(
      "fields_of", [](const HeldMesh& held) { return fields_of(held.any()); }, py::arg("mesh"));
}

}  // namespace pardel::python
