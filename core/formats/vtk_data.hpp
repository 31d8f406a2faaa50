// Reads what a legacy file of VTK has at its points and in its cells, section by section.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../array.hpp"
#include "../mesh.hpp"
#include "text_reader.hpp"

namespace pardel::files {

/// The arrays become markers, regions and attributes of the mesh if they have the names that write_vtk() gives to
/// these, and fields otherwise.
class VtkData {
 public:
  /// Both must outlive the object.
  VtkData(TextReader& in, Mesh& mesh) : in_(in), mesh_(mesh) {}

  /// Reads the section that begins with `word`; false if it has no data. `cells`: the number of cells so far.
  bool read_section(std::string_view word, std::size_t cells);

  /// After the last section: leaves the values of cells to the triangles and lines that are these cells.
  void give_to(const std::vector<std::size_t>& cell_of_triangle, const std::vector<std::size_t>& cell_of_line);

 private:
  void open(bool of_points);
  [[nodiscard]] std::size_t size() const { return *of_points_ ? mesh_.points.size() : cells_; }
  std::size_t count(std::string_view what);

  void read_field_data();
  void read_scalars();
  void read_colours();
  void read_texture();
  void read_rows(const std::string& name, std::size_t components);
  void read_array(const std::string& name, std::size_t components, std::size_t tuples, bool is_text);
  void read_attributes(std::size_t components);
  void read_numbers(Array<double>& values, std::size_t n);
  void read_field(const std::string& name, std::size_t components);
  void skip_values(std::size_t n);
  void skip_lookup_table();
  void skip_metadata();

  void take_markers_of_points();
  void take_markers_of_lines(const std::vector<std::size_t>& cell_of_line);
  void keep_triangles(Field& field, const std::vector<std::size_t>& cell_of_triangle,
                      const std::vector<std::size_t>& cell_of_line);

  TextReader& in_;
  Mesh& mesh_;
  std::size_t cells_ = 0;
  std::optional<bool> of_points_;  ///< what the arrays belong to that are read
  Array<double> region_;           ///< per cell
};

}  // namespace pardel::files
