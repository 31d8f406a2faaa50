#include "vtu_arrays.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "expand.hpp"
#include "text_reader.hpp"

namespace pardel::files {
namespace {

constexpr std::string_view blanks = " \t\r\n";

}  // namespace

/// An XML start tag; text[at] is its '<'. XML entities are not decoded, because no attribute that is read here needs
/// this.
struct VtuFile::Tag {
  std::string_view name;
  std::string_view attributes;
  std::size_t end = 0;  ///< the position after the '>' of the tag
  bool closed = false;  ///< the tag has the form <.../>

  /// The value of an attribute; empty if the tag does not have it.
  [[nodiscard]] std::string_view operator[](std::string_view key) const {
    for (std::size_t at = attributes.find(key); at != std::string_view::npos; at = attributes.find(key, at + 1)) {
      const std::string_view rest = attributes.substr(at + key.size());
      if (at == 0 || blanks.find(attributes[at - 1]) == std::string_view::npos) continue;
      if (rest.size() < 2 || rest[0] != '=' || (rest[1] != '"' && rest[1] != '\'')) continue;
      return rest.substr(2, rest.find(rest[1], 2) - 2);
    }
    return {};
  }
};

namespace {

VtuFile::Tag tag_at(std::string_view text, std::size_t at) {
  VtuFile::Tag tag;
  const std::size_t close = std::min(text.find('>', at), text.size());
  std::string_view inside = text.substr(at + 1, close - at - 1);
  tag.end = std::min(close + 1, text.size());
  tag.closed = inside.ends_with('/');
  if (tag.closed) inside.remove_suffix(1);
  tag.name = inside.substr(0, inside.find_first_of(blanks));
  tag.attributes = inside.substr(tag.name.size());
  return tag;
}

/// The integer in the text; -1 if the text is not an integer; `otherwise` if the text is empty.
std::int64_t whole(std::string_view text, std::int64_t otherwise) {
  if (text.empty()) return otherwise;
  std::int64_t value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() && stop == text.data() + text.size() && value >= 0 ? value : -1;
}

bool is_section(std::string_view name) {
  return name == "Points" || name == "Cells" || name == "CellData" || name == "PointData" || name == "FieldData";
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes base64 until there are `most` bytes or a character is not base64. Padding ends a group of four characters,
/// but not the text: some writers encode the length and the data separately, and pad both.
std::string decode_base64(std::string_view text, std::size_t most) {
  std::string bytes;
  std::uint32_t group = 0;
  int digits = 0;
  for (const char c : text) {
    if (bytes.size() >= most) break;
    if (blanks.find(c) != std::string_view::npos) continue;
    if (c == '=') {
      // A group of two digits holds one byte; a group of three digits holds two bytes.
      if (digits == 2) bytes += static_cast<char>(group >> 4);
      if (digits == 3) bytes += {static_cast<char>(group >> 10), static_cast<char>(group >> 2)};
      digits = 0;
      group = 0;
      continue;
    }
    const int digit = base64_digit(c);
    if (digit < 0) break;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (++digits < 4) continue;
    bytes += {static_cast<char>(group >> 16), static_cast<char>(group >> 8), static_cast<char>(group)};
    digits = 0;
    group = 0;
  }
  if (bytes.size() > most) bytes.resize(most);
  return bytes;
}

template <class Stored, class Value>
Array<Value> converted(std::string_view bytes) {
  Array<Value> values(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored stored;
    std::memcpy(&stored, bytes.data() + i * sizeof(Stored), sizeof(Stored));
    values[i] = static_cast<Value>(stored);
  }
  return values;
}

/// Converts values of the type with this VTK name. Returns false if the type is unknown or a Value cannot hold a value.
template <class Value>
bool convert(std::string_view bytes, std::string_view type, Array<Value>& to) {
  if (type == "Int8") return to = converted<std::int8_t, Value>(bytes), true;
  if (type == "UInt8") return to = converted<std::uint8_t, Value>(bytes), true;
  if (type == "Int16") return to = converted<std::int16_t, Value>(bytes), true;
  if (type == "UInt16") return to = converted<std::uint16_t, Value>(bytes), true;
  if (type == "Int32") return to = converted<std::int32_t, Value>(bytes), true;
  if (type == "UInt32") return to = converted<std::uint32_t, Value>(bytes), true;
  if (type == "Int64") return to = converted<std::int64_t, Value>(bytes), true;
  if (type == "UInt64") return to = converted<std::uint64_t, Value>(bytes), true;
  if constexpr (std::is_same_v<Value, double>) {
    if (type == "Float32") return to = converted<float, Value>(bytes), true;
    if (type == "Float64") return to = converted<double, Value>(bytes), true;
  }
  return false;
}

template <class Value>
Result<Array<Value>> parse_values(TextReader& in) {
  Array<Value> values;
  while (in.next_field()) {
    if constexpr (std::is_same_v<Value, double>) {
      values.push_back(in.number("a value"));
    } else {
      values.push_back(in.integer("a value", std::numeric_limits<Value>::min(), std::numeric_limits<Value>::max()));
    }
  }
  if (in.failed()) return in.error();
  return values;
}

}  // namespace

Error VtuFile::error_at(std::size_t at, const std::string& message) const {
  const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return {ErrorKind::invalid_input, name_ + ":" + std::to_string(line) + ": " + message};
}

std::optional<Error> VtuFile::read_root(const Tag& tag, std::size_t at) {
  constexpr std::string_view native = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  if (tag["type"] != "UnstructuredGrid") {
    return error_at(at, "expected type=\"UnstructuredGrid\", found " + in_quotes(tag["type"]));
  }
  if (!tag["byte_order"].empty() && tag["byte_order"] != native) {
    return error_at(at, "expected byte_order=\"" + std::string(native) + "\", found " + in_quotes(tag["byte_order"]));
  }
  compressed_ = !tag["compressor"].empty();
  if (compressed_ && tag["compressor"] != "vtkZLibDataCompressor") {
    return error_at(at, "expected no compressor or vtkZLibDataCompressor, found " + in_quotes(tag["compressor"]));
  }
  if (tag["header_type"] == "UInt64") header_bytes_ = 8;
  found_root_ = true;
  return std::nullopt;
}

std::optional<Error> VtuFile::read_piece(const Tag& tag, std::size_t at) {
  if (found_piece_) return error_at(at, "expected one piece, found a second");
  found_piece_ = true;
  const std::int64_t points = whole(tag["NumberOfPoints"], -1);
  const std::int64_t cells = whole(tag["NumberOfCells"], -1);
  if (points < 0) return error_at(at, "expected the number of points, found " + in_quotes(tag["NumberOfPoints"]));
  if (cells < 0) return error_at(at, "expected the number of cells, found " + in_quotes(tag["NumberOfCells"]));
  points_ = static_cast<std::size_t>(points);
  cells_ = static_cast<std::size_t>(cells);
  return std::nullopt;
}

/// Sets `at` to the end of the content of the array.
std::optional<Error> VtuFile::read_array(const Tag& tag, std::string_view section, std::size_t& at) {
  VtuArray array{section, tag["Name"], tag["type"], tag["format"], 1, 0, tag.end, tag.end};
  const std::int64_t components = whole(tag["NumberOfComponents"], 1);
  const std::int64_t offset = whole(tag["offset"], 0);
  if (components < 1)
    return error_at(at, "expected a number of components, found " + in_quotes(tag["NumberOfComponents"]));
  if (offset < 0) return error_at(at, "expected an offset, found " + in_quotes(tag["offset"]));
  array.components = static_cast<std::size_t>(components);
  array.offset = static_cast<std::size_t>(offset);
  if (!tag.closed) {
    const std::size_t close = text_.find("</DataArray", tag.end);
    if (close == std::string_view::npos) return error_at(at, "this DataArray does not end");
    // VTK writes inner elements (InformationKey) after the values, other programs before them.
    const std::size_t inner = text_.find('<', tag.end);
    const bool values_first = text_.find_first_not_of(blanks, tag.end) < inner;
    array.begin = values_first ? tag.end : std::max(tag.end, text_.rfind('>', close) + 1);
    array.end = values_first ? inner : close;
    at = close;
  } else {
    at = tag.end;
  }
  arrays_.push_back(array);
  return std::nullopt;
}

std::optional<Error> VtuFile::read_appended(const Tag& tag, std::size_t at) {
  appended_raw_ = tag["encoding"] == "raw";
  appended_ = text_.find('_', tag.end);
  if (appended_ == std::string_view::npos) return error_at(at, "expected appended data, found none");
  ++appended_;
  return std::nullopt;
}

Result<VtuFile> VtuFile::parse(std::string_view text, const std::string& name) {
  VtuFile file;
  file.text_ = text;
  file.name_ = name;
  std::string_view section;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const Tag tag = tag_at(text, at);
    std::size_t end = tag.end;
    std::optional<Error> error;
    if (tag.name == "VTKFile") {
      error = file.read_root(tag, at);
    } else if (tag.name == "Piece") {
      error = file.read_piece(tag, at);
    } else if (tag.name == "DataArray") {
      end = at;
      error = file.read_array(tag, section, end);
    } else if (tag.name == "AppendedData") {
      error = file.read_appended(tag, at);
      end = text.size();  // the rest is not XML
    } else if (is_section(tag.name)) {
      section = tag.name;
    }
    if (error) return *error;
    at = end;
  }
  if (!file.found_root_)
    return file.error_at(0, "expected a VTK file (<VTKFile type=\"UnstructuredGrid\" ...>), found none");
  if (!file.found_piece_) return file.error_at(0, "expected a <Piece>, found none");
  return file;
}

const VtuArray* VtuFile::find(std::string_view section, std::string_view name) const {
  for (const VtuArray& array : arrays_) {
    if (array.section == section && (name.empty() || array.name == name)) return &array;
  }
  return nullptr;
}

Result<VtuFile::Data> VtuFile::data_of(const VtuArray& array) const {
  const bool appended = array.format == "appended";
  if (!appended && array.format != "binary") {
    return error_at(array.begin, "expected format ascii, binary or appended, found " + in_quotes(array.format));
  }
  if (appended && (appended_ == 0 || array.offset > text_.size() - appended_)) {
    return error_at(array.begin, "there are no appended data at offset " + std::to_string(array.offset));
  }
  return Data{appended ? text_.substr(appended_ + array.offset) : text_.substr(array.begin, array.end - array.begin),
              appended && appended_raw_,
              {}};
}

std::string_view VtuFile::Data::first(std::size_t n) {
  if (raw) return source.substr(0, n);
  if (decoded.size() < n) decoded = decode_base64(source, n);
  return std::string_view(decoded).substr(0, n);
}

std::uint64_t VtuFile::header_number(std::string_view header, std::size_t i) const {
  std::uint64_t number = 0;
  std::memcpy(&number, header.data() + i * header_bytes_, header_bytes_);  // for little-endian machines
  if constexpr (std::endian::native == std::endian::big) number >>= 8 * (sizeof(number) - header_bytes_);
  return number;
}

Error VtuFile::cut_off(const VtuArray& array) const {
  return error_at(array.begin, "the data of this array are cut off");
}

/// The data begin with their length, an integer of header_bytes_ bytes.
Result<std::string_view> VtuFile::plain_bytes(const VtuArray& array, Data& data) const {
  const std::string_view header = data.first(header_bytes_);
  if (header.size() < header_bytes_) return cut_off(array);
  const std::uint64_t length = header_number(header, 0);
  if (length > data.source.size()) {
    return error_at(array.begin, "this array announces " + std::to_string(length) + " bytes, but " +
                                     std::to_string(data.source.size()) + " follow");
  }
  const std::string_view bytes = data.first(header_bytes_ + length).substr(header_bytes_);
  if (bytes.size() < length) return cut_off(array);
  return bytes;
}

/// Compressed data begin with the number of blocks, the size of a block, the size of the last block if it is smaller
/// (0 if it is not), and the compressed size of each block.
Result<std::string_view> VtuFile::expanded_bytes(const VtuArray& array, Data& data, std::string& expanded) const {
  const std::string_view start = data.first(3 * header_bytes_);
  if (start.size() < 3 * header_bytes_) return cut_off(array);
  const std::uint64_t blocks = header_number(start, 0), block = header_number(start, 1), last = header_number(start, 2);
  if (blocks > data.source.size() / header_bytes_ - 3) return cut_off(array);
  const std::size_t header_size = (3 + blocks) * header_bytes_;
  const std::string header(data.first(header_size));
  if (header.size() < header_size) return cut_off(array);
  std::size_t at = header_size;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t compressed = header_number(header, 3 + i);
    if (compressed > data.source.size() - at) return cut_off(array);
    at += compressed;
  }
  const std::string_view bytes = data.first(at);
  if (bytes.size() < at) return cut_off(array);
  at = header_size;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t compressed = header_number(header, 3 + i);
    const std::uint64_t size = i + 1 == blocks && last != 0 ? last : block;
    if (!append_expanded(bytes.substr(at, compressed), size, expanded))
      return error_at(array.begin, "block " + std::to_string(i) + " of this array does not expand to " +
                                       std::to_string(size) + " bytes");
    at += compressed;
  }
  return std::string_view(expanded);
}

template <class Value>
Result<Array<Value>> VtuFile::values(const VtuArray& array) const {
  if (array.format == "ascii") {
    TextReader in(text_.substr(0, array.end), name_);
    in.skip(array.begin);
    return parse_values<Value>(in);
  }
  Result<Data> data = data_of(array);
  if (!data.ok()) return data.error();
  std::string expanded;
  const auto bytes = compressed_ ? expanded_bytes(array, *data, expanded) : plain_bytes(array, *data);
  if (!bytes.ok()) return bytes.error();
  Array<Value> values;
  if (!convert(*bytes, array.type, values)) {
    return error_at(array.begin,
                    std::string(std::is_same_v<Value, double> ? "expected numbers" : "expected whole numbers") +
                        ", found type " + in_quotes(array.type));
  }
  if constexpr (std::is_same_v<Value, double>) {
    const auto bad = std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (bad != values.end()) {
      return error_at(array.begin, "value " + std::to_string(bad - values.begin()) + " of the array " +
                                       in_quotes(array.name) + " is not finite");
    }
  }
  return values;
}

template Result<Array<double>> VtuFile::values(const VtuArray& array) const;
template Result<Array<std::int64_t>> VtuFile::values(const VtuArray& array) const;

}  // namespace pardel::files
