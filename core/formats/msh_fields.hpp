// Fields in MSH: the sections $NodeData and $ElementData.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "../field.hpp"
#include "../mesh.hpp"
#include "msh_rows.hpp"
#include "msh_source.hpp"

namespace pardel::files {

/// Finds triangles by the tags of their elements. Tags that ascend one by one, as in most files, need little memory.
class MshTriangles {
 public:
  void add(std::size_t tag, Index triangle);
  void sort();
  /// The triangle with this tag, or no_index. Precondition: sort() was called last.
  [[nodiscard]] Index find(std::size_t tag) const;

 private:
  /// The triangles `first` to `first + n - 1` have the tags `tag` to `tag + n - 1`.
  struct Run {
    std::size_t tag, n;
    Index first;
  };
  std::vector<Run> runs_;
};

/// What a section of values belongs to.
struct MshPlaces {
  Field::Place place = Field::Place::points;
  std::size_t count = 0;                     ///< of points or triangles
  std::function<Index(std::size_t)> of_tag;  ///< the point or triangle, or no_index
};

/// Reads a section after the line of its name, up to the line of its end. What is not read is listed in `left_out`; the
/// field is empty if nothing is read. Values of nodes and elements that do not exist are ignored, and those of elements
/// that are no triangles are left out.
///
/// The section has lists of strings, numbers and integers, each after its length. The first string is the name and the
/// first number the time. The integers are the time step, the number of values per node or element, and the number of
/// nodes or elements. Then `tag values...` for each. The lists are text, also in binary files.
[[nodiscard]] std::optional<Field> read_msh_field(TextReader& in, MshSource& source, const MshPlaces& places,
                                                  LeftOut& left_out);

/// Writes a section per field, with the values that are present. `point_tag` and `triangle_tag` give the tags of
/// nodes and elements.
void write_fields(MshRows& out, const std::vector<Field>& fields, const std::function<std::size_t(Index)>& point_tag,
                  const std::function<std::size_t(Index)>& triangle_tag);

}  // namespace pardel::files
