// Reads the arrays of a VTU file in every place and encoding that the format allows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../array.hpp"
#include "../result.hpp"
#include "../support/stop_signal.hpp"
#include "xml_tag.hpp"

namespace pardel::files {

/// One element <DataArray>. Its values stay in the text of the file.
struct VtuArray {
  std::size_t piece = 0;     ///< in FieldData: without meaning
  std::string_view section;  ///< the enclosing element: Points, Cells, CellData, PointData, FieldData
  std::string_view name;
  std::string_view type;    ///< Float64, Int32, ...
  std::string_view format;  ///< ascii, binary or appended
  std::size_t components = 1;
  std::size_t offset = 0;  ///< the array's place in the appended data, in bytes
  std::size_t begin = 0;   ///< the start of the element's content in the text
  std::size_t end = 0;
};

/// The elements of a VTU file. The text must outlive the object.
class VtuFile {
 public:
  /// Supported: the pieces of an UnstructuredGrid, not compressed or compressed by zlib, in the byte order of this
  /// machine; arrays as text, as base64 (inline or appended), or as appended raw bytes; headers of 32 and 64 bits. Any
  /// other file is an error of kind `invalid_input` that names the unsupported part.
  static Result<VtuFile> parse(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
  /// As given to parse(); null: there is none.
  [[nodiscard]] StopSignal* stop() const { return stop_; }

  /// An element <Piece>.
  struct Piece {
    std::size_t points = 0;
    std::size_t cells = 0;
  };
  /// At least one.
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  /// Returns the array of the piece with this section and name, or the first array of the section if `name` is empty;
  /// null if none exists. Arrays in FieldData belong to no piece.
  [[nodiscard]] const VtuArray* find(std::size_t piece, std::string_view section, std::string_view name) const;
  [[nodiscard]] const std::vector<VtuArray>& arrays() const { return arrays_; }

  /// True if arrays of this type hold numbers; others hold text or bits.
  [[nodiscard]] static bool is_number(std::string_view type);
  /// All values of an array, converted from the type in the file. `Value` is double or int64_t. A number with a
  /// fraction is an error if `Value` is int64_t, and a double that is not finite unless `any` is set.
  template <class Value>
  [[nodiscard]] Result<Array<Value>> values(const VtuArray& array, bool any = false) const;

  /// An error at byte `at` of the text: `NAME:LINE: message`.
  [[nodiscard]] Error error_at(std::size_t at, const std::string& message) const;

 private:
  VtuFile() = default;

  /// The data of an array that is not text: raw bytes or base64.
  struct Data {
    std::string_view source;
    bool raw = false;
    std::string decoded;  ///< the beginning of the data, if they are base64
    /// The first n bytes; fewer if there are fewer. Invalidates earlier results.
    std::string_view first(std::size_t n);
  };

  std::optional<Error> read_root(const XmlTag& tag, std::size_t at);
  std::optional<Error> read_piece(const XmlTag& tag, std::size_t at);
  std::optional<Error> read_array(const XmlTag& tag, std::string_view section, std::size_t& at);
  std::optional<Error> read_appended(const XmlTag& tag, std::size_t at);

  [[nodiscard]] Result<Data> data_of(const VtuArray& array) const;
  Result<std::string_view> plain_bytes(const VtuArray& array, Data& data) const;
  Result<std::string_view> expanded_bytes(const VtuArray& array, Data& data, std::string& expanded) const;
  [[nodiscard]] std::uint64_t header_number(std::string_view header, std::size_t i) const;
  [[nodiscard]] Error cut_off(const VtuArray& array) const;

  std::string_view text_;
  std::string name_;
  StopSignal* stop_ = nullptr;
  std::vector<VtuArray> arrays_;
  std::vector<Piece> pieces_;
  std::size_t appended_ = 0;  ///< the first byte of the appended data, after the `_`
  bool appended_raw_ = false;
  std::size_t header_bytes_ = 4;
  bool compressed_ = false;
  bool found_root_ = false;
};

}  // namespace pardel::files
