// Reads legacy files of VTK as text ("Simple legacy formats" of The VTK User's Guide): an unstructured grid of
// triangles, lines and vertices. CELLS are lists of points, each after its length, or, since version 5.1, OFFSETS and
// CONNECTIVITY. vtk_data.hpp reads the arrays.
#include "../formats.hpp"
#include "../neighbours.hpp"
#include "mesh_readers.hpp"
#include "triangle_sections.hpp"
#include "vtk_cells.hpp"
#include "vtk_data.hpp"

namespace pardel::files {
namespace {

class VtkReader {
 public:
  VtkReader(std::string_view text, const std::string& name, StopSignal* stop) : in_(text, name, stop), stop_(stop) {}

  Result<Mesh> read() {
    read_head();
    while (in_.next_field()) read_section(in_.word());
    if (!has_points_) in_.fail("expected POINTS, found the end of the file");
    if (!has_types_) in_.fail("expected CELL_TYPES, found the end of the file");
    if (in_.failed()) return in_.error();
    data_.give_to(cell_of_triangle_, cell_of_line_);
    rebuild_neighbours(mesh_.triangles, mesh_.points.size(), stop_);
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
    if ((word == "CELL_DATA" || word == "POINT_DATA") && !has_types_)
      return in_.fail("expected CELL_TYPES before " + std::string(word));
    if (data_.read_section(word, ends_.size())) return;
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

  TextReader in_;
  StopSignal* stop_;
  Mesh mesh_;
  VtkData data_{in_, mesh_};
  bool has_points_ = false, has_types_ = false;
  Array<Index> corners_;     ///< of all cells
  Array<std::size_t> ends_;  ///< per cell: the end of its corners
  std::vector<std::size_t> cell_of_triangle_, cell_of_line_;
};

}  // namespace

Result<Mesh> parse_vtk(std::string_view text, const std::string& name, StopSignal* stop) {
  return VtkReader(text, name, stop).read();
}

}  // namespace pardel::files
