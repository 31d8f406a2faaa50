#include "vtu_arrays.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "text_reader.hpp"

namespace pardel::files {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// An XML start tag; text[at] is its '<'. XML entities are not decoded, because no attribute that is read here needs
/// this.
struct Tag {
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

Tag tag_at(std::string_view text, std::size_t at) {
  Tag tag;
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

Result<VtuFile> VtuFile::parse(std::string_view text, const std::string& name) {
  VtuFile file;
  file.text_ = text;
  file.name_ = name;
  constexpr std::string_view native = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string_view section;
  bool found_grid = false;
  bool found_piece = false;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const Tag tag = tag_at(text, at);
    if (tag.name == "VTKFile") {
      if (tag["type"] != "UnstructuredGrid") {
        return file.error_at(at, "expected type=\"UnstructuredGrid\", found " + in_quotes(tag["type"]));
      }
      if (!tag["byte_order"].empty() && tag["byte_order"] != native) {
        return file.error_at(
            at, "expected byte_order=\"" + std::string(native) + "\", found " + in_quotes(tag["byte_order"]));
      }
      if (!tag["compressor"].empty()) {
        return file.error_at(
            at, "the file is compressed (" + std::string(tag["compressor"]) + "): write it without compression");
      }
      if (tag["header_type"] == "UInt64") file.header_bytes_ = 8;
      found_grid = true;
    } else if (tag.name == "Piece") {
      if (found_piece) return file.error_at(at, "expected one piece, found a second");
      found_piece = true;
      const std::int64_t points = whole(tag["NumberOfPoints"], -1);
      const std::int64_t cells = whole(tag["NumberOfCells"], -1);
      if (points < 0)
        return file.error_at(at, "expected the number of points, found " + in_quotes(tag["NumberOfPoints"]));
      if (cells < 0) return file.error_at(at, "expected the number of cells, found " + in_quotes(tag["NumberOfCells"]));
      file.points_ = static_cast<std::size_t>(points);
      file.cells_ = static_cast<std::size_t>(cells);
    } else if (tag.name == "DataArray") {
      VtuArray array{section, tag["Name"], tag["type"], tag["format"], 1, 0, tag.end, tag.end};
      const std::int64_t components = whole(tag["NumberOfComponents"], 1);
      const std::int64_t offset = whole(tag["offset"], 0);
      if (components < 1)
        return file.error_at(at, "expected a number of components, found " + in_quotes(tag["NumberOfComponents"]));
      if (offset < 0) return file.error_at(at, "expected an offset, found " + in_quotes(tag["offset"]));
      array.components = static_cast<std::size_t>(components);
      array.offset = static_cast<std::size_t>(offset);
      if (!tag.closed) {
        array.end = text.find("</DataArray", tag.end);
        if (array.end == std::string_view::npos) return file.error_at(at, "this DataArray does not end");
        // Inner elements (VTK's InformationKey) come before the values.
        array.begin = std::max(tag.end, text.rfind('>', array.end) + 1);
      }
      file.arrays_.push_back(array);
      at = array.end;
      continue;
    } else if (tag.name == "AppendedData") {
      file.appended_raw_ = tag["encoding"] == "raw";
      file.appended_ = text.find('_', tag.end);
      if (file.appended_ == std::string_view::npos) return file.error_at(at, "expected appended data, found none");
      ++file.appended_;
      break;  // the rest is not XML
    } else if (!tag.name.starts_with('/') && !tag.name.starts_with('?') && !tag.name.starts_with('!')) {
      section = tag.name;
    }
    at = tag.end;
  }
  if (!found_grid) return file.error_at(0, "expected a VTK file (<VTKFile type=\"UnstructuredGrid\" ...>), found none");
  if (!found_piece) return file.error_at(0, "expected a <Piece>, found none");
  return file;
}

const VtuArray* VtuFile::find(std::string_view section, std::string_view name) const {
  for (const VtuArray& array : arrays_) {
    if (array.section == section && (name.empty() || array.name == name)) return &array;
  }
  return nullptr;
}

Result<std::string_view> VtuFile::bytes_of(const VtuArray& array, std::string& decoded) const {
  const bool appended = array.format == "appended";
  if (!appended && array.format != "binary") {
    return error_at(array.begin, "expected format ascii, binary or appended, found " + in_quotes(array.format));
  }
  if (appended && (appended_ == 0 || array.offset > text_.size() - appended_)) {
    return error_at(array.begin, "there are no appended data at offset " + std::to_string(array.offset));
  }
  const bool raw = appended && appended_raw_;
  const std::string_view source =
      appended ? text_.substr(appended_ + array.offset) : text_.substr(array.begin, array.end - array.begin);

  // The data begin with their length, an integer of header_bytes_ bytes.
  if (!raw) decoded = decode_base64(source, header_bytes_);
  const std::string_view header = raw ? source.substr(0, header_bytes_) : std::string_view(decoded);
  std::uint64_t length = 0;
  if (header.size() < header_bytes_) return error_at(array.begin, "the data of this array are cut off");
  std::memcpy(&length, header.data(), header_bytes_);  // for little-endian machines
  if constexpr (std::endian::native == std::endian::big) length >>= 8 * (sizeof(length) - header_bytes_);
  if (length > source.size()) {
    return error_at(array.begin, "this array announces " + std::to_string(length) + " bytes, but " +
                                     std::to_string(source.size()) + " follow");
  }
  if (!raw) decoded = decode_base64(source, header_bytes_ + length);
  const std::string_view data = (raw ? source : std::string_view(decoded)).substr(header_bytes_, length);
  if (data.size() < length) return error_at(array.begin, "the data of this array are cut off");
  return data;
}

template <class Value>
Result<Array<Value>> VtuFile::values(const VtuArray& array) const {
  if (array.format == "ascii") {
    TextReader in(text_.substr(0, array.end), name_);
    in.skip(array.begin);
    return parse_values<Value>(in);
  }
  std::string decoded;
  const auto bytes = bytes_of(array, decoded);
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
