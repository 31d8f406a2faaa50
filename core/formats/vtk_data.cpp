#include "vtk_data.hpp"

#include <algorithm>
#include <utility>

#include "mesh_readers.hpp"
#include "triangle_sections.hpp"
#include "vtk_cells.hpp"
#include "vtk_names.hpp"
#include "vtu_names.hpp"
#include "whole_markers.hpp"

namespace pardel::files {

bool VtkData::read_section(std::string_view word, std::size_t cells) {
  cells_ = cells;
  const auto name = [this] { return name_in_vtk(in_.word()); };
  if (word == "CELL_DATA") {
    open(false);
  } else if (word == "POINT_DATA") {
    open(true);
  } else if (word == "FIELD") {
    read_field_data();
  } else if (word == "METADATA") {
    skip_metadata();
  } else if (word == "SCALARS") {
    read_scalars();
  } else if (word == "LOOKUP_TABLE") {
    skip_lookup_table();
  } else if (word == "COLOR_SCALARS") {
    read_colours();
  } else if (word == "TEXTURE_COORDINATES") {
    read_texture();
  } else if (word == "VECTORS" || word == "NORMALS") {
    read_rows(name(), 3);
  } else if (word == "TENSORS") {
    read_rows(name(), 9);
  } else {
    return false;
  }
  return true;
}

void VtkData::give_to(const std::vector<std::size_t>& cell_of_triangle, const std::vector<std::size_t>& cell_of_line) {
  if (!region_.empty()) {
    Array<double> attributes(cell_of_triangle.size());
    for (std::size_t t = 0; t < attributes.size(); ++t) attributes[t] = region_[cell_of_triangle[t]];
    set_regions(mesh_, attributes.span());
  }
  take_markers_of_points();
  take_markers_of_lines(cell_of_line);
  for (Field& field : mesh_.fields)
    if (field.place == Field::Place::triangles) keep_triangles(field, cell_of_triangle, cell_of_line);
  // Files that have markers of lines have 0 in triangles, so zeroes alone say nothing.
  std::erase_if(mesh_.fields, [this](const Field& field) {
    return is_quality(field, mesh_) ||
           (is_marker_of_triangles(field) && std::ranges::none_of(field.values, says_something));
  });
  // Those at points come first, as in other formats.
  std::ranges::stable_sort(mesh_.fields, {}, &Field::place);
}

/// Arrays follow, of the points or of the cells.
void VtkData::open(bool of_points) {
  const std::size_t n = in_.count("the number of values");
  of_points_ = of_points;
  if (n != size())
    in_.fail(std::string("expected as many values as there are ") + (of_points ? "points, " : "cells, ") +
             std::to_string(size()));
}

/// A number of values that follow as text.
std::size_t VtkData::count(std::string_view what) {
  const std::size_t n = in_.count(what);
  return in_.room_for(n, text_bytes(1), what) ? n : 0;
}

/// `NAME NUMBER`, then so many arrays `NAME COMPONENTS TUPLES TYPE`. They may also precede the data of points and
/// cells.
void VtkData::read_field_data() {
  in_.word();
  const std::size_t n = in_.count("the number of arrays");
  for (std::size_t i = 0; i < n && !in_.failed(); ++i) {
    in_.next_field();
    std::string_view name = in_.word();
    if (name == "METADATA") {
      skip_metadata();
      in_.next_field();
      name = in_.word();
    }
    const std::size_t components = count("the number of components"), tuples = count("the number of tuples");
    if (components > 0 && !in_.room_for(tuples, text_bytes(components), "values")) return;
    const std::string_view type = in_.word();
    read_array(name_in_vtk(name), components, tuples, type == "string");
  }
}

/// `NAME TYPE [COMPONENTS]`, then `LOOKUP_TABLE NAME`, then the values.
void VtkData::read_scalars() {
  const std::string name = name_in_vtk(in_.word());
  in_.word();
  const auto components = static_cast<std::size_t>(in_.integer_or("the number of components", 1, 4, 1));
  in_.expect_line("LOOKUP_TABLE");
  in_.expect_word("LOOKUP_TABLE");
  read_rows(name, components);
}

void VtkData::read_colours() {
  const std::string name = name_in_vtk(in_.word());
  read_rows(name, count("the number of components"));
}

void VtkData::read_texture() {
  const std::string name = name_in_vtk(in_.word());
  read_rows(name, static_cast<std::size_t>(in_.integer("the number of components", 1, 3)));
}

/// The values of each point or cell, from the next line on.
void VtkData::read_rows(const std::string& name, std::size_t components) {
  in_.end_line();
  if (!of_points_) return in_.fail("expected CELL_DATA or POINT_DATA before an array");
  if (components > 0 && !in_.room_for(size(), text_bytes(components), "values")) return;
  read_array(name, components, size(), false);
}

void VtkData::read_array(const std::string& name, std::size_t components, std::size_t tuples, bool is_text) {
  const bool fits = of_points_ && tuples == size() && components > 0 && !is_text;
  const bool has_values = fits && tuples > 0;
  if (has_values && *of_points_ && name == "attributes") return read_attributes(components);
  if (has_values && components == 1) {
    if (name == "marker") return read_field(name, 1);  // give_to() takes the markers from it
    if (name == "region" && !*of_points_) return read_numbers(region_, tuples);
  }
  const bool is_of_mesh = name == "attributes" || name == "marker" || name == "region";
  if (has_values || (fits && !is_of_mesh)) return read_field(name, components);
  mesh_.left_out.add("the array " + in_quotes(name));
  skip_values(components * tuples);
}

void VtkData::read_attributes(std::size_t components) {
  mesh_.attributes_per_point = components;
  read_numbers(mesh_.point_attributes, components * mesh_.points.size());
}

void VtkData::read_numbers(Array<double>& values, std::size_t n) {
  if (!in_.room_for(n, text_bytes(1), "values")) return;
  values.resize(n);
  for (std::size_t i = 0; i < n && !in_.failed(); ++i) {
    in_.next_field();
    values[i] = in_.number("a value");
  }
}

void VtkData::read_field(const std::string& name, std::size_t components) {
  const Field::Place place = *of_points_ ? Field::Place::points : Field::Place::triangles;
  Field field{name, place, components, Array<double>(components * size()), 0};
  for (double& value : field.values) {
    in_.next_field();
    value = in_.any_number("a value");
    if (in_.failed()) return;
  }
  mesh_.fields.push_back(std::move(field));
}

void VtkData::skip_values(std::size_t n) {
  if (!in_.room_for(n, text_bytes(1), "values")) return;
  for (std::size_t i = 0; i < n; ++i) {
    if (!in_.next_field()) return in_.fail("expected a value, found the end of the file");
    in_.word();
  }
}

/// `NAME SIZE`, then the entries, of four numbers each.
void VtkData::skip_lookup_table() {
  in_.word();
  skip_values(4 * count("the number of entries"));
}

/// It ends with an empty line.
void VtkData::skip_metadata() {
  in_.end_line();
  while (!in_.rest().empty() && !in_.rest().starts_with('\n') && !in_.rest().starts_with("\r\n")) in_.end_line();
}

void VtkData::take_markers_of_points() {
  const auto field = std::ranges::find_if(mesh_.fields, [](const Field& f) {
    return f.place == Field::Place::points && f.name == "marker" && f.components == 1;
  });
  if (field == mesh_.fields.end()) return;
  std::optional<Array<int>> markers = whole_markers(field->values.span());
  if (!markers) return;
  mesh_.point_markers = std::move(*markers);
  mesh_.fields.erase(field);
}

/// The values of triangles stay.
void VtkData::take_markers_of_lines(const std::vector<std::size_t>& cell_of_line) {
  const auto field = std::ranges::find_if(mesh_.fields, is_marker_of_triangles);
  if (field == mesh_.fields.end()) return;
  const std::optional<Array<int>> markers = whole_markers(field->values.span(), cell_of_line);
  if (!markers) return;
  for (std::size_t i = 0; i < cell_of_line.size(); ++i) {
    mesh_.constrained_edges[i].marker = (*markers)[i];
    field->values[cell_of_line[i]] = 0;
  }
}

/// A field that other cells do not have is 0 or not a number there.
void VtkData::keep_triangles(Field& field, const std::vector<std::size_t>& cell_of_triangle,
                             const std::vector<std::size_t>& cell_of_line) {
  Array<double>& values = field.values;
  const std::size_t n = field.components;
  const auto has_values = [&](std::size_t cell) {
    return std::any_of(&values[cell * n], &values[cell * n] + n, says_something);
  };
  if (std::ranges::any_of(cell_of_line, has_values)) mesh_.left_out.add("values in cells that are not triangles");
  keep_cells(values, n, 0, cell_of_triangle);
}

}  // namespace pardel::files
