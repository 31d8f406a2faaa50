// The arrays of a VTU file, wherever and however it keeps them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "../array.hpp"
#include "../result.hpp"

namespace pardel::files {

/// One <DataArray>, its values still where they are.
struct VtuArray {
  std::string_view section;  ///< the element around it: Points, Cells, CellData, PointData, FieldData
  std::string_view name;
  std::string_view type;    ///< Float64, Int32, ...
  std::string_view format;  ///< ascii, binary or appended
  std::size_t components = 1;
  std::size_t offset = 0;  ///< of appended data
  std::size_t begin = 0;   ///< of the element's content in the text
  std::size_t end = 0;
};

/// The skeleton of the file. `text` must outlive it.
class VtuFile {
 public:
  /// Understood: one piece of an UnstructuredGrid, without compression, in the byte order of this machine;
  /// arrays as text, as base64 inline or appended, or raw and appended; headers of 32 and 64 bits. Another
  /// file is an `invalid_input` error that names what is not understood.
  static Result<VtuFile> parse(std::string_view text, const std::string& name);

  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] std::size_t cells() const { return cells_; }
  /// By section and name; an empty name takes the first of the section. Null if there is none.
  [[nodiscard]] const VtuArray* find(std::string_view section, std::string_view name) const;

  /// All values of an array, whatever type the file has them in. `Value` is double or int64_t; numbers with a
  /// fraction are refused as the latter.
  template <class Value>
  [[nodiscard]] Result<Array<Value>> values(const VtuArray& array) const;

  /// An error at byte `at` of the text: `NAME:LINE: message`.
  [[nodiscard]] Error error_at(std::size_t at, const std::string& message) const;

 private:
  VtuFile() = default;
  /// The bytes of an array that is not kept as text; `decoded` holds them if they are not in the file as such.
  Result<std::string_view> bytes_of(const VtuArray& array, std::string& decoded) const;

  std::string_view text_;
  std::string name_;
  std::vector<VtuArray> arrays_;
  std::size_t points_ = 0;
  std::size_t cells_ = 0;
  std::size_t appended_ = 0;  ///< where appended data begin, behind the `_`
  bool appended_raw_ = false;
  std::size_t header_bytes_ = 4;
};

}  // namespace pardel::files
