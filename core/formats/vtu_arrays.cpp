#include "vtu_arrays.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base64.hpp"
#include "expand.hpp"
#include "text_reader.hpp"

namespace pardel::files {
namespace {

template <class Stored, class Value>
Array<Value> converted(std::string_view bytes) {
  Array<Value> values;
  values.resize_uninitialised(bytes.size() / sizeof(Stored));
#pragma omp parallel for schedule(dynamic, 1 << 14) if (values.size() > 100'000)
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored stored;
    std::memcpy(&stored, bytes.data() + i * sizeof(Stored), sizeof(Stored));
    values[i] = static_cast<Value>(stored);  // NOLINT(bugprone-signed-char-misuse): VTK's Int8 is a number
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

/// any: also numbers that are not finite.
template <class Value>
Result<Array<Value>> parse_values(TextReader& in, bool any) {
  Array<Value> values;
  while (in.next_field()) {
    if constexpr (std::is_same_v<Value, double>) {
      values.push_back(any ? in.any_number("a value") : in.number("a value"));
    } else {
      values.push_back(in.integer("a value", std::numeric_limits<Value>::min(), std::numeric_limits<Value>::max()));
    }
  }
  if (in.failed()) return in.error();
  return values;
}

}  // namespace

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
    if (stop_ != nullptr) stop_->ask();
    const std::uint64_t compressed = header_number(header, 3 + i);
    const std::uint64_t size = i + 1 == blocks && last != 0 ? last : block;
    if (!append_expanded(bytes.substr(at, compressed), size, expanded))
      return error_at(array.begin, "block " + std::to_string(i) + " of this array does not expand to " +
                                       std::to_string(size) + " bytes");
    at += compressed;
  }
  return std::string_view(expanded);
}

bool VtuFile::is_number(std::string_view type) {
  Array<double> none;
  return convert({}, type, none);
}

template <class Value>
Result<Array<Value>> VtuFile::values(const VtuArray& array, bool any) const {
  if (stop_ != nullptr) stop_->ask();
  if (array.format == "ascii") {
    TextReader in(text_.substr(0, array.end), name_, stop_);
    in.skip(array.begin);
    return parse_values<Value>(in, any);
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
    const auto* const bad =
        any ? values.end() : std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    if (bad != values.end()) {
      return error_at(array.begin, "value " + std::to_string(bad - values.begin()) + " of the array " +
                                       in_quotes(array.name) + " is not finite");
    }
  }
  return values;
}

template Result<Array<double>> VtuFile::values(const VtuArray& array, bool any) const;
template Result<Array<std::int64_t>> VtuFile::values(const VtuArray& array, bool any) const;

}  // namespace pardel::files
