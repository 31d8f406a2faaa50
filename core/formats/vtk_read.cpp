// Reads legacy files of VTK as text ("Simple legacy formats" of The VTK User's Guide): an unstructured grid of
// triangles, lines and vertices. CELLS are lists of points, each after its length, or, since version 5.1, OFFSETS and
// CONNECTIVITY. Of the arrays those of write_vtk() are read, and `size` where there is no `attributes`, as SCALARS or
// as part of a FIELD.
#include <optional>

#include "../formats.hpp"
#include "../neighbours.hpp"
#include "mesh_readers.hpp"
#include "triangle_sections.hpp"
#include "vtk_cells.hpp"

namespace pardel::files {
namespace {

class VtkReader {
 public:
  VtkReader(std::string_view text, const std::string& name) : in_(text, name) {}

  Result<Mesh> read() {
    read_head();
    while (in_.next_field()) read_section(in_.word());
    if (!has_points_) in_.fail("expected POINTS, found the end of the file");
    if (!has_types_) in_.fail("expected CELL_TYPES, found the end of the file");
    if (in_.failed()) return in_.error();
    if (!region_.empty()) {
      Array<double> attributes(cell_of_triangle_.size());
      for (std::size_t t = 0; t < attributes.size(); ++t) attributes[t] = region_[cell_of_triangle_[t]];
      set_regions(mesh_, attributes.span());
    }
    for (std::size_t i = 0; i < cell_of_line_.size() && !marker_.empty(); ++i)
      mesh_.constrained_edges[i].marker = marker_[cell_of_line_[i]];
    rebuild_neighbours(mesh_.triangles, mesh_.points.size());
    return std::move(mesh_);
  }

 private:
  /// The version, a title, the encoding, the kind of the data.
  void read_head() {
    if (!in_.rest().starts_with("# vtk DataFile")) in_.fail("expected \"# vtk DataFile Version\"");
    in_.end_line();
    in_.end_line();
    in_.expect_line("ASCII");
    if (const std::string_view word = in_.word(); word != "ASCII")
      in_.fail("expected ASCII, found " + in_quotes(word) + "; only text files are read");
    in_.expect_line("DATASET");
    in_.expect_word("DATASET");
    in_.expect_word("UNSTRUCTURED_GRID");
  }

  void read_section(std::string_view word) {
    if (word == "POINTS") return read_points();
    if (word == "CELLS") return read_cells();
    if (word == "CELL_TYPES") return read_types();
    if (word == "CELL_DATA") return open_data(false);
    if (word == "POINT_DATA") return open_data(true);
    if (word == "FIELD") return read_field();
    if (word == "METADATA") return skip_metadata();
    if (word == "SCALARS") return read_scalars();
    if (word == "LOOKUP_TABLE") return skip_array(4);
    if (word == "COLOR_SCALARS") return skip_colours();
    if (word == "TEXTURE_COORDINATES") return skip_texture();
    if (word == "VECTORS" || word == "NORMALS") return skip_data(3);
    if (word == "TENSORS") return skip_data(9);
    in_.fail("expected a section, found " + in_quotes(word));
  }

  double number(std::string_view what) {
    in_.next_field();
    return in_.number(what);
  }
  std::int64_t integer(std::string_view what, std::int64_t low, std::int64_t high) {
    in_.next_field();
    return in_.integer(what, low, high);
  }
  Index point_index() {
    in_.next_field();
    return read_point_index(in_, "a point", mesh_.points.size(), 0);
  }
  /// A number of values that follow as text.
  std::size_t count(std::string_view what) {
    const std::size_t n = in_.count(what);
    return in_.room_for(n, text_bytes(1), what) ? n : 0;
  }

  void read_points() {
    const std::size_t n = in_.count("the number of points");
    if (has_points_) in_.fail("has POINTS twice");
    if (n > max_points) in_.fail("announces more points than a mesh can hold");
    if (!in_.room_for(n, text_bytes(3), "points")) return;
    has_points_ = true;
    in_.word();  // the type of the numbers
    mesh_.points.resize(n);
    for (std::size_t i = 0; i < n && !in_.failed(); ++i) {
      const double x = number("an x coordinate");
      const double y = number("a y coordinate");
      number("a z coordinate");
      mesh_.points[i] = {x, y};
    }
  }

  void read_cells() {
    if (!has_points_ || !ends_.empty()) return in_.fail("expected CELLS once, after POINTS");
    const std::size_t n = count("the number of cells"), size = count("the number of numbers in CELLS");
    if (in_.failed()) return;
    in_.next_field();
    if (in_.rest().starts_with("OFFSETS")) return read_connectivity(n, size);
    for (std::size_t c = 0; c < n && !in_.failed(); ++c) {
      const std::int64_t corners = integer("the number of points of a cell", 0, static_cast<std::int64_t>(size));
      for (std::int64_t k = 0; k < corners && !in_.failed(); ++k) corners_.push_back(point_index());
      ends_.push_back(corners_.size());
    }
  }

  /// `offsets`: one more than there are cells; the first is 0.
  void read_connectivity(std::size_t offsets, std::size_t size) {
    in_.word();
    in_.word();  // the type of the numbers
    for (std::size_t c = 0; c < offsets && !in_.failed(); ++c) {
      const std::int64_t low = ends_.empty() ? 0 : static_cast<std::int64_t>(ends_.back());
      const std::int64_t offset = integer("an offset", low, c == 0 ? 0 : static_cast<std::int64_t>(size));
      if (c > 0) ends_.push_back(static_cast<std::size_t>(offset));
    }
    in_.next_field();
    in_.expect_word("CONNECTIVITY");
    in_.word();
    for (std::size_t k = 0; k < size && !in_.failed(); ++k) corners_.push_back(point_index());
  }

  void read_types() {
    const std::size_t n = in_.count("the number of cells");
    if (n != ends_.size()) in_.fail("expected as many cells as CELLS has, " + std::to_string(ends_.size()));
    if (has_types_) in_.fail("has CELL_TYPES twice");
    has_types_ = true;
    for (std::size_t c = 0; c < n && !in_.failed(); ++c) add_cell(c, integer("the type of a cell", 0, any_marker_high));
    if (!can_be_a_mesh(mesh_.triangles.size())) in_.fail("has more triangles than a mesh can hold");
  }

  void add_cell(std::size_t c, std::int64_t type) {
    const std::size_t begin = c == 0 ? 0 : ends_[c - 1], corners = ends_[c] - begin;
    const std::size_t expected = type > vtk_triangle ? 0 : nodes_of_vtk_cell(type);  // none of order 2
    if (in_.failed()) return;
    if (expected == 0)
      return in_.fail("cell " + std::to_string(c) + " is of type " + std::to_string(type) +
                      ", neither a triangle (5) nor a line (3) nor a vertex (1)");
    if (corners != expected)
      return in_.fail("cell " + std::to_string(c) + " of type " + std::to_string(type) + " has " +
                      std::to_string(corners) + " points");
    if (type == vtk_triangle) {
      mesh_.triangles.push_back(
          {{corners_[begin], corners_[begin + 1], corners_[begin + 2]}, {no_index, no_index, no_index}});
      cell_of_triangle_.push_back(c);
    } else if (type == vtk_line) {
      mesh_.constrained_edges.push_back({corners_[begin], corners_[begin + 1], no_index, 0});
      cell_of_line_.push_back(c);
    }
  }

  /// Arrays follow, of the points or of the cells.
  void open_data(bool of_points) {
    const std::size_t n = in_.count("the number of values");
    of_points_ = of_points;
    if (n != size_of_data())
      in_.fail(std::string("expected as many values as there are ") + (of_points ? "points, " : "cells, ") +
               std::to_string(size_of_data()));
  }
  [[nodiscard]] std::size_t size_of_data() const { return *of_points_ ? mesh_.points.size() : ends_.size(); }

  /// `NAME NUMBER`, then so many arrays `NAME COMPONENTS TUPLES TYPE`. A field may also precede the data.
  void read_field() {
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
      in_.word();  // the type of the values
      read_array(name, components, tuples);
    }
  }

  /// `NAME TYPE [COMPONENTS]`, then `LOOKUP_TABLE NAME`, then the values.
  void read_scalars() {
    const std::string_view name = in_.word();
    in_.word();
    const auto components = static_cast<std::size_t>(in_.integer_or("the number of components", 1, 4, 1));
    in_.expect_line("LOOKUP_TABLE");
    in_.expect_word("LOOKUP_TABLE");
    in_.word();
    if (!of_points_) return in_.fail("expected CELL_DATA or POINT_DATA before an array");
    read_array(name, components, size_of_data());
  }

  /// Reads an array that is part of a mesh. Any other one is left out.
  void read_array(std::string_view name, std::size_t components, std::size_t tuples) {
    const bool fits = of_points_ && tuples == size_of_data() && tuples > 0;
    const bool is_attribute =
        fits && *of_points_ && components > 0 && (name == "attributes" || (name == "size" && !has_attributes_));
    if (is_attribute) return read_attributes(name, components);
    if (fits && components == 1) {
      if (name == "marker") return read_markers(*of_points_ ? mesh_.point_markers : marker_, tuples);
      if (name == "region" && !*of_points_) return read_numbers(region_, tuples);
    }
    leave_out(name);
    skip_values(components * tuples);
  }

  void read_attributes(std::string_view name, std::size_t components) {
    has_attributes_ = name == "attributes";
    mesh_.attributes_per_point = components;
    read_numbers(mesh_.point_attributes, components * mesh_.points.size());
  }
  void read_numbers(Array<double>& values, std::size_t n) {
    if (!in_.room_for(n, text_bytes(1), "values")) return;
    values.resize(n);
    for (std::size_t i = 0; i < n && !in_.failed(); ++i) values[i] = number("a value");
  }
  void read_markers(Array<int>& markers, std::size_t n) {
    if (!in_.room_for(n, text_bytes(1), "values")) return;
    markers.resize(n);
    for (std::size_t i = 0; i < n && !in_.failed(); ++i)
      markers[i] = static_cast<int>(integer("a marker", any_marker_low, any_marker_high));
  }

  void leave_out(std::string_view name) { mesh_.left_out.add("the array " + in_quotes(name)); }

  void skip_values(std::size_t n) {
    if (!in_.room_for(n, text_bytes(1), "values")) return;
    for (std::size_t i = 0; i < n; ++i) {
      if (!in_.next_field()) return in_.fail("expected a value, found the end of the file");
      in_.word();
    }
  }
  /// `NAME TYPE`, then the values of each point or cell.
  void skip_data(std::size_t components) {
    leave_out(in_.word());
    skip_rows(components);
  }
  void skip_rows(std::size_t components) {
    in_.end_line();
    if (!of_points_) return in_.fail("expected CELL_DATA or POINT_DATA before an array");
    skip_values(components * size_of_data());
  }
  /// `NAME SIZE`, then the entries.
  void skip_array(std::size_t components) {
    in_.word();
    skip_values(components * count("the number of entries"));
  }
  void skip_colours() {
    leave_out(in_.word());
    skip_rows(count("the number of components"));
  }
  void skip_texture() {
    leave_out(in_.word());
    skip_rows(static_cast<std::size_t>(in_.integer("the number of components", 1, 3)));
  }
  /// It ends with an empty line.
  void skip_metadata() {
    in_.end_line();
    while (!in_.rest().empty() && !in_.rest().starts_with('\n') && !in_.rest().starts_with("\r\n")) in_.end_line();
  }

  TextReader in_;
  Mesh mesh_;
  bool has_points_ = false, has_types_ = false, has_attributes_ = false;
  Array<Index> corners_;     ///< of all cells
  Array<std::size_t> ends_;  ///< per cell: the end of its corners
  std::vector<std::size_t> cell_of_triangle_, cell_of_line_;
  std::optional<bool> of_points_;  ///< what the arrays belong to that are read
  Array<double> region_;           ///< per cell
  Array<int> marker_;              ///< per cell
};

}  // namespace

Result<Mesh> parse_vtk(std::string_view text, const std::string& name) { return VtkReader(text, name).read(); }

}  // namespace pardel::files
