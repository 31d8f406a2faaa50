// Reads VTU: triangles become triangles of the mesh, lines become its constrained edges, vertices are ignored. Of cells
// of second order the corners are read. The arrays of write_vtu() (region, marker, attributes) are read if they are
// present; other arrays of points and cells are fields. z is ignored.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "../formats.hpp"
#include "../neighbours.hpp"
#include "equal_points.hpp"
#include "group_names.hpp"
#include "mesh_readers.hpp"
#include "middles.hpp"
#include "text_reader.hpp"
#include "triangle_sections.hpp"
#include "vtk_cells.hpp"
#include "vtu_arrays.hpp"
#include "vtu_names.hpp"
#include "whole_markers.hpp"

namespace pardel::files {
namespace {

/// Fills a mesh from the arrays of a piece of a file. Stores the first failure; after it, every step does nothing.
class VtuMesh {
 public:
  VtuMesh(const VtuFile& file, std::size_t piece) : file_(file), piece_(piece) {}

  /// After read(): the numbers of the points in a mesh of which the file is a piece; empty if there are none.
  Result<Array<std::uint64_t>> numbers() {
    const VtuArray* array = find("PointData", vtu_vertex_numbers);
    const auto values_of_points = values<std::int64_t>(array, points());
    Array<std::uint64_t> numbers;
    for (std::size_t i = 0; i < values_of_points.size(); ++i)
      if (kept_.empty() || kept_[i] != no_index)
        numbers.push_back(static_cast<std::uint64_t>(checked(array, values_of_points, i, 0, no_index - 1)));
    if (error_) return *error_;
    return numbers;
  }

  Result<Mesh> read() {
    read_points();
    read_cells();
    read_regions();
    read_markers_of_lines();
    read_markers_of_points();
    read_attributes();
    read_fields();
    if (piece_ == 0) read_field_data();
    if (error_) return *error_;
    if (!is_middle_.empty()) kept_ = remove_middles(mesh_, std::move(is_middle_));
    rebuild_neighbours(mesh_.triangles, mesh_.points.size(), file_.stop());
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::size_t points() const { return file_.pieces()[piece_].points; }
  [[nodiscard]] std::size_t cells() const { return file_.pieces()[piece_].cells; }
  [[nodiscard]] const VtuArray* find(std::string_view section, std::string_view name) const {
    return file_.find(piece_, section, name);
  }

  void fail(const VtuArray& array, const std::string& message) {
    if (!error_) error_ = file_.error_at(array.begin, "array " + in_quotes(array.name) + ": " + message);
  }

  const VtuArray* required(std::string_view section, std::string_view name) {
    const VtuArray* array = find(section, name);
    if (array == nullptr && !error_) {
      error_ = file_.error_at(0, "expected an array " + std::string(name) + " in <" + std::string(section) + ">");
    }
    return array;
  }

  /// Returns the values of an array. If n is given, the array must have n values. Empty if the array is missing or
  /// invalid.
  template <class Value>
  Array<Value> values(const VtuArray* array, std::optional<std::size_t> n = std::nullopt) {
    if (error_ || array == nullptr) return {};
    auto values = file_.values<Value>(*array);
    if (!values.ok()) {
      error_ = values.error();
      return {};
    }
    if (n && values->size() != *n) {
      fail(*array, "expected " + std::to_string(*n) + " values, found " + std::to_string(values->size()));
      return {};
    }
    return std::move(*values);
  }

  /// values[i] if it is a number from low to high; otherwise fails and returns low.
  std::int64_t checked(const VtuArray* array, const Array<std::int64_t>& values, std::size_t i, std::int64_t low,
                       std::int64_t high) {
    if (values[i] >= low && values[i] <= high) return values[i];
    fail(*array, "expected value " + std::to_string(i) + " from " + std::to_string(low) + " to " +
                     std::to_string(high) + ", found " + std::to_string(values[i]));
    return low;
  }
  Index point_index(const VtuArray* array, const Array<std::int64_t>& values, std::size_t i) {
    return static_cast<Index>(checked(array, values, i, 0, static_cast<std::int64_t>(mesh_.points.size()) - 1));
  }
  int marker(const VtuArray* array, const Array<std::int64_t>& values, std::size_t i) {
    return static_cast<int>(checked(array, values, i, any_marker_low, any_marker_high));
  }

  void read_points() {
    if (points() > max_points) error_ = file_.error_at(0, "the piece announces more points than a mesh can hold");
    const VtuArray* array = required("Points", "");
    const auto xyz = values<double>(array, 3 * points());
    if (array != nullptr && array->type == "Float32") unit_of_points_ = std::numeric_limits<float>::epsilon();
    mesh_.points.resize_uninitialised(xyz.size() / 3);
#pragma omp parallel for schedule(dynamic, 1 << 14) if (mesh_.points.size() > 100'000)
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) mesh_.points[i] = {xyz[3 * i], xyz[3 * i + 1]};
  }

  /// Reads the triangles at the beginning of the cells on all threads and returns their number. If one of them is
  /// wrong, it reads none.
  std::size_t read_leading_triangles(const Array<std::int64_t>& corners, const Array<std::int64_t>& ends,
                                     const Array<std::int64_t>& types) {
    const auto other = std::find_if(types.begin(), types.end(), [](std::int64_t type) { return type != vtk_triangle; });
    const auto n = std::min(static_cast<std::size_t>(other - types.begin()), corners.size() / 3);
    const auto points = static_cast<std::uint64_t>(mesh_.points.size());
    mesh_.triangles.resize_uninitialised(n);
    bool right = true;
#pragma omp parallel for schedule(dynamic, 1 << 14) reduction(&& : right) if (n > 100'000)
    for (std::size_t t = 0; t < n; ++t) {
      Triangle triangle;
      bool in_range = ends[t] == static_cast<std::int64_t>(3 * t + 3);
      for (std::size_t i = 0; i < 3; ++i) {
        in_range = in_range && static_cast<std::uint64_t>(corners[3 * t + i]) < points;
        triangle.v[i] = static_cast<Index>(corners[3 * t + i]);
      }
      right = right && in_range;
      mesh_.triangles[t] = triangle;
    }
    if (!right) mesh_.triangles.clear();
    return leading_triangles_ = mesh_.triangles.size();
  }

  void read_cells() {
    const VtuArray* corners_array = required("Cells", "connectivity");
    const VtuArray* ends_array = required("Cells", "offsets");
    const VtuArray* types_array = required("Cells", "types");
    const auto corners = values<std::int64_t>(corners_array);
    const auto ends = values<std::int64_t>(ends_array, cells());
    const auto types = values<std::int64_t>(types_array, cells());
    if (!error_ && !can_be_a_mesh(corners.size() / 3)) fail(*corners_array, "more triangles than a mesh can hold");
    const std::size_t leading = error_ ? 0 : read_leading_triangles(corners, ends, types);
    std::size_t first = 3 * leading;
    for (std::size_t c = leading; c < cells() && !error_; ++c) {
      const std::size_t n = nodes_of_vtk_cell(types[c]);
      if (n == 0) {
        fail(*types_array, "cell " + std::to_string(c) + " is of type " + std::to_string(types[c]) +
                               ", neither a triangle (5) nor a line (3) nor a vertex (1)");
      } else if (ends[c] != static_cast<std::int64_t>(first + n) || first + n > corners.size()) {
        fail(*ends_array, "expected cell " + std::to_string(c) + " to end at " + std::to_string(first + n) + " of " +
                              std::to_string(corners.size()) + " corners, found " + std::to_string(ends[c]));
      } else if (types[c] == vtk_triangle || types[c] == vtk_triangle_of_6) {
        note_middles(corners_array, corners, first, 3, n);
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) triangle.v[i] = point_index(corners_array, corners, first + i);
        mesh_.triangles.push_back(triangle);
        cell_of_triangle_.push_back(c);
      } else if (types[c] == vtk_line || types[c] == vtk_line_of_3) {
        note_middles(corners_array, corners, first, 2, n);
        const Index a = point_index(corners_array, corners, first);
        mesh_.constrained_edges.push_back({a, point_index(corners_array, corners, first + 1), no_index, 0});
        cell_of_line_.push_back(c);
      }
      first += n;
    }
  }

  /// Of the n nodes of a cell, which begin at `first`, those after the corners are middles of edges.
  void note_middles(const VtuArray* array, const Array<std::int64_t>& nodes, std::size_t first, std::size_t corners,
                    std::size_t n) {
    if (n == corners) return;
    is_middle_.resize(mesh_.points.size());
    const auto node = [&](std::size_t k) {
      const Index v = point_index(array, nodes, first + k);
      return error_ ? NumberedNode{} : NumberedNode{v, mesh_.points[v]};
    };
    for (std::size_t k = 0; corners + k < n && !error_; ++k) {
      const NumberedNode middle = node(corners + k), a = node(k), b = node((k + 1) % corners);
      if (error_) return;
      if (const std::string fault = why_curved(middle, a, b, unit_of_points_); !fault.empty()) fail(*array, fault);
      is_middle_[middle.number] = 1;
    }
  }

  [[nodiscard]] std::size_t cell_of(std::size_t triangle) const {
    return triangle < leading_triangles_ ? triangle : cell_of_triangle_[triangle - leading_triangles_];
  }

  void read_regions() {
    const VtuArray* array = find("CellData", "region");
    const auto by_cell = values<double>(array, cells());
    if (error_ || array == nullptr) return;
    Array<double> by_triangle(mesh_.triangles.size());
    for (std::size_t t = 0; t < by_triangle.size(); ++t) by_triangle[t] = by_cell[cell_of(t)];
    set_regions(mesh_, by_triangle.span());
  }

  /// The values of an array "marker" with one number per place; nothing for other arrays, which are fields.
  std::optional<Array<double>> values_of_markers(const VtuArray* array, std::size_t places) {
    if (error_ || array == nullptr || !VtuFile::is_number(array->type)) return std::nullopt;
    auto values = file_.values<double>(*array, true);
    if (!values) error_ = values.error();
    if (!values || values->size() != places) return std::nullopt;
    return std::move(*values);
  }

  /// What the array says about triangles is a field. Files that have markers of lines have 0 there, so zeroes alone say
  /// nothing.
  void read_markers_of_lines() {
    const VtuArray* array = find("CellData", "marker");
    auto values = values_of_markers(array, cells());
    if (!values) return;
    const auto markers = whole_markers(values->span(), cell_of_line_);
    if (!markers) return;
    markers_of_lines_ = array;
    for (std::size_t i = 0; i < cell_of_line_.size(); ++i) {
      mesh_.constrained_edges[i].marker = (*markers)[i];
      (*values)[cell_of_line_[i]] = std::numeric_limits<double>::quiet_NaN();
    }
    keep_triangles(*values, 1);
    if (std::ranges::any_of(*values, says_something))
      mesh_.fields.push_back({std::string(array->name), Field::Place::triangles, 1, std::move(*values), 0});
  }

  void read_markers_of_points() {
    const VtuArray* array = find("PointData", "marker");
    const auto values = values_of_markers(array, points());
    if (!values) return;
    auto markers = whole_markers(values->span());
    if (!markers) return;
    markers_of_points_ = array;
    mesh_.point_markers = std::move(*markers);
  }

  void read_attributes() {
    const VtuArray* attributes = find("PointData", "attributes");
    if (attributes == nullptr || points() == 0) return;
    mesh_.point_attributes = values<double>(attributes);
    mesh_.attributes_per_point = mesh_.point_attributes.size() / points();
    if (mesh_.point_attributes.size() % points() != 0) fail(*attributes, "expected as many values at every point");
  }

  /// Arrays that are no fields: write_vtu() writes them from other parts of the mesh.
  [[nodiscard]] bool is_of_mesh(const VtuArray& array) const {
    if (&array == markers_of_lines_ || &array == markers_of_points_) return true;
    if (array.section == "CellData") return array.name == "region";
    return array.name == "attributes" || array.name == vtu_vertex_numbers;
  }

  /// Those at points come first, as in a .msh.
  void read_fields() {
    for (const auto& [section, place] :
         {std::pair("PointData", Field::Place::points), std::pair("CellData", Field::Place::triangles)})
      for (const VtuArray& array : file_.arrays())
        if (array.piece == piece_ && array.section == section && !is_of_mesh(array) && !error_)
          read_field(array, place);
    std::ranges::stable_sort(mesh_.fields, {}, &Field::place);
  }

  /// Text and bits are left out, and so are values of cells that are no triangles.
  void read_field(const VtuArray& array, Field::Place place) {
    const std::string name = xml_text(array.name);
    if (!VtuFile::is_number(array.type)) return mesh_.left_out.add("the array " + in_quotes(name));
    const bool of_points = place == Field::Place::points;
    const std::size_t places = of_points ? points() : cells();
    auto read = file_.values<double>(array, true);
    if (!read) {
      error_ = read.error();
      return;
    }
    if (places == 0 ? !read->empty() : read->size() % places != 0) {
      return fail(array, "expected as many values " + std::string(of_points ? "at every point" : "in every cell"));
    }
    constexpr std::size_t usual = 9;  // a tensor
    const std::size_t components = places == 0 ? std::min(array.components, usual) : read->size() / places;
    if (components == 0) return;
    Field field{name, place, components, std::move(*read)};
    if (!of_points) keep_triangles(field.values, components);
    if (!is_quality(field, mesh_)) mesh_.fields.push_back(std::move(field));
  }

  /// Of the values of cells, leaves those of triangles.
  void keep_triangles(Array<double>& values, std::size_t components) {
    for (const std::size_t line : cell_of_line_)
      for (std::size_t k = 0; k < components; ++k)
        if (!std::isnan(values[line * components + k])) mesh_.left_out.add("values in cells that are not triangles");
    keep_cells(values, components, leading_triangles_, cell_of_triangle_);
  }

  void read_field_data() {
    for (const VtuArray& array : file_.arrays())
      if (array.section == "FieldData" && !array.name.starts_with("constrained_edge") && !error_) read_name(array);
    read_constrained_edges();
  }

  /// The name of the array is that of a marker or a region if its values are the marker and 1, or the region and 2, as
  /// in files that meshio makes of Gmsh's.
  void read_name(const VtuArray& array) {
    const std::string name = xml_text(array.name);
    const auto pair =
        VtuFile::is_number(array.type) ? file_.values<double>(array, true) : Result<Array<double>>(Error{});
    if (pair && pair->size() == 2 && ((*pair)[1] == 1 || (*pair)[1] == 2)) {
      const auto of = (*pair)[1] == 1 ? GroupName::Of::marker : GroupName::Of::region;
      const double value = (*pair)[0];
      const bool is_tag = value >= 1 && value <= std::numeric_limits<int>::max() && value == std::floor(value);
      const auto is_named = [&](const GroupName& other) { return other.of == of && other.value == value; };
      if (is_tag && is_group_name(of, name) && std::ranges::none_of(mesh_.names, is_named)) {
        mesh_.names.push_back({of, static_cast<int>(value), name});
        return;
      }
    }
    mesh_.left_out.add("the field data " + in_quotes(name));
  }

  /// Earlier versions of write_vtu() stored the constrained edges as field data instead of cells.
  void read_constrained_edges() {
    const VtuArray* ends_array = find("FieldData", "constrained_edges");
    const VtuArray* markers_array = find("FieldData", "constrained_edge_markers");
    const auto ends = values<std::int64_t>(ends_array);
    const auto markers = values<std::int64_t>(markers_array, ends.size() / 2);
    for (std::size_t i = 0; i < ends.size() / 2 && !error_; ++i) {
      const Index a = point_index(ends_array, ends, 2 * i);
      const Index b = point_index(ends_array, ends, 2 * i + 1);
      const int given = markers.empty() ? 0 : marker(markers_array, markers, i);
      mesh_.constrained_edges.push_back({a, b, no_index, given});
    }
  }

  const VtuFile& file_;
  std::size_t piece_;
  Mesh mesh_;
  std::size_t leading_triangles_ = 0;          ///< their cells are the first cells
  std::vector<std::size_t> cell_of_triangle_;  ///< of the other triangles
  std::vector<std::size_t> cell_of_line_;
  const VtuArray *markers_of_lines_ = nullptr, *markers_of_points_ = nullptr;  ///< the arrays that are no fields
  double unit_of_points_ = std::numeric_limits<double>::epsilon();  ///< in the last place of a coordinate of 1
  std::vector<char> is_middle_;  ///< per point: 1 for the middle of an edge; empty if there are none
  std::vector<Index> kept_;      ///< the result of remove_middles(); empty if there were none
  std::optional<Error> error_;
};

/// The points of the pieces have numbers, as in the pieces of a .pvtu.
bool have_numbers(const std::vector<NumberedMesh>& pieces) {
  return std::ranges::all_of(pieces,
                             [](const NumberedMesh& piece) { return piece.number.size() == piece.mesh.points.size(); });
}

Result<NumberedMesh> read_piece(const VtuFile& file, std::size_t piece) {
  VtuMesh reader(file, piece);
  Result<Mesh> mesh = reader.read();
  if (!mesh) return mesh.error();
  Result<Array<std::uint64_t>> numbers = reader.numbers();
  if (!numbers) return numbers.error();
  return NumberedMesh{std::move(*mesh), std::move(*numbers)};
}

}  // namespace

Result<Mesh> parse_vtu(std::string_view text, const std::string& name, StopSignal* stop) {
  const auto file = VtuFile::parse(text, name, stop);
  if (!file.ok()) return file.error();
  if (file->pieces().size() == 1) return VtuMesh(*file, 0).read();
  std::vector<NumberedMesh> pieces;
  for (std::size_t piece = 0; piece < file->pieces().size(); ++piece) {
    Result<NumberedMesh> read = read_piece(*file, piece);
    if (!read) return read.error();
    pieces.push_back(std::move(*read));
  }
  if (have_numbers(pieces)) return join_read_pieces(std::move(pieces), name);
  std::vector<std::uint64_t> in_file = number_equal_points(pieces);
  Result<Mesh> mesh = join_read_pieces(std::move(pieces), name);
  if (mesh) mesh->numbers.of_points = std::move(in_file);
  return mesh;
}

Result<NumberedMesh> read_piece(const std::filesystem::path& file, StopSignal* stop) {
  const auto text = read_file(file, stop);
  if (!text) return text.error();
  const auto parsed = VtuFile::parse(*text, file.string(), stop);
  if (!parsed) return parsed.error();
  if (const std::size_t n = parsed->pieces().size(); n != 1)
    return parsed->error_at(0, "expected one <Piece>, as a file of a .pvtu has, found " + std::to_string(n));
  Result<NumberedMesh> piece = read_piece(*parsed, 0);
  if (piece && piece->number.size() != piece->mesh.points.size())
    return parsed->error_at(0, std::string("expected a point array ") + vtu_vertex_numbers + ", as a piece has");
  return piece;
}

}  // namespace pardel::files

namespace pardel {

Result<NumberedMesh> read_vtu_piece(const std::filesystem::path& file) { return files::read_piece(file, nullptr); }

}  // namespace pardel
