// Reads arrays of NumPy: the format .npy, versions 1 to 3, and the world file beside it.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "raster_readers.hpp"
#include "text_reader.hpp"

namespace pardel::files {
namespace {

/// What the header of an array says.
struct ArrayHeader {
  char kind = 'f';  ///< f: floating point, i: signed, u: unsigned
  unsigned bytes = 8;
  bool big_endian = false;
  bool columns_first = false;
  Index rows = 0, columns = 0;
};

Error broken(const std::string& name, const std::string& why) { return {ErrorKind::invalid_input, name + ": " + why}; }

/// The text after `'key':` in the header, which is a dictionary of Python; empty if there is none.
std::string_view value_of(std::string_view header, const std::string& key) {
  const std::size_t at = header.find("'" + key + "'");
  if (at == std::string_view::npos) return {};
  const std::size_t value = header.find_first_not_of(" :", at + key.size() + 2);
  return value == std::string_view::npos ? std::string_view() : header.substr(value);
}

bool is_supported(char kind, unsigned bytes) {
  if (kind == 'f') return bytes == 4 || bytes == 8;
  return (kind == 'i' || kind == 'u') && (bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8);
}

/// Reads `(rows, columns)`.
bool read_shape(std::string_view text, ArrayHeader& header) {
  const std::size_t end = text.find(')');
  if (!text.starts_with('(') || end == std::string_view::npos) return false;
  std::string numbers(text.substr(1, end - 1));
  std::ranges::replace(numbers, ',', ' ');
  TextReader in(numbers, "");
  std::array<Index, 2> shape{};
  if (!in.next_line()) return false;
  for (Index& size : shape) {
    const std::string_view word = in.word();
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size() || value == 0 || value >= no_index) return false;
    size = static_cast<Index>(value);
  }
  header.rows = shape[0];
  header.columns = shape[1];
  return !in.has_field();
}

Result<ArrayHeader> read_header(std::string_view text, const std::string& name) {
  ArrayHeader header;
  const std::string_view type = value_of(text, "descr");
  if (type.size() < 5 || type[0] != '\'') return broken(name, "the header has no type of numbers");
  header.big_endian = type[1] == '>';
  header.kind = type[2];
  header.bytes = static_cast<unsigned>(type[3] - '0');
  if (!is_supported(header.kind, header.bytes) || type[4] != '\'') {
    return broken(name, "the type of numbers is " + in_quotes(type.substr(1, type.find('\'', 1) - 1)) +
                            "; only integers, and floating-point numbers of 4 or 8 bytes, are supported");
  }
  header.columns_first = value_of(text, "fortran_order").starts_with("True");
  if (!read_shape(value_of(text, "shape"), header))
    return broken(name, "the array must have two dimensions, each from 1 to " + std::to_string(no_index - 1) + "");
  return header;
}

template <class Number>
double number_at(const char* at, bool swap) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), at, sizeof(Number));
  if (swap) std::ranges::reverse(bytes);
  return static_cast<double>(std::bit_cast<Number>(bytes));
}

using Decode = double (*)(const char*, bool);

Decode decoder(const ArrayHeader& header) {
  switch (header.bytes) {
    case 1:
      return header.kind == 'i' ? number_at<std::int8_t> : number_at<std::uint8_t>;
    case 2:
      return header.kind == 'i' ? number_at<std::int16_t> : number_at<std::uint16_t>;
    case 4:
      if (header.kind == 'f') return number_at<float>;
      return header.kind == 'i' ? number_at<std::int32_t> : number_at<std::uint32_t>;
    default:
      if (header.kind == 'f') return number_at<double>;
      return header.kind == 'i' ? number_at<std::int64_t> : number_at<std::uint64_t>;
  }
}

void read_values(const ArrayHeader& header, std::string_view data, Raster& raster) {
  const bool swap = header.big_endian != (std::endian::native == std::endian::big);
  const Decode decode = decoder(header);
  raster.values.resize(std::size_t{header.rows} * header.columns);
  for (std::size_t row = 0; row < header.rows; ++row)
    for (std::size_t column = 0; column < header.columns; ++column) {
      const std::size_t k = header.columns_first ? column * header.rows + row : row * header.columns + column;
      raster.values[(header.rows - 1 - row) * header.columns + column] = decode(data.data() + k * header.bytes, swap);
    }
}

/// Reads the six numbers of a world file. Needs raster.rows.
Status read_world(std::string_view text, const std::string& name, Raster& raster) {
  TextReader in(text, name);
  std::array<double, 6> number{};
  for (std::size_t i = 0; i < number.size() && !in.failed(); ++i) {
    in.expect_line("one of six numbers");
    const double value = number[i] = in.number("a number");
    if (i == 0 && !(value > 0)) in.fail("the first number must be greater than 0");
    if ((i == 1 || i == 2) && value != 0) in.fail("rotated rasters are not supported");
    if (i == 3 && !(value < 0)) in.fail("the fourth number must be less than 0");
  }
  if (in.failed()) return in.error();
  const auto [step_x, rotation_y, rotation_x, step_y, west, north] = number;
  raster.step_x = step_x;
  raster.step_y = -step_y;
  raster.first = {west, north + (raster.rows - 1) * step_y};
  return check_place(raster, name);
}

/// The two parts of a file: the dictionary and the data.
struct Parts {
  std::string_view header, data;
};

std::optional<Parts> parts_of(std::string_view file) {
  constexpr std::string_view magic = "\x93NUMPY";
  if (!file.starts_with(magic) || file.size() < 12 || file[6] < 1 || file[6] > 3) return {};
  const std::size_t length_bytes = file[6] == 1 ? 2 : 4;
  std::size_t length = 0;
  for (std::size_t i = length_bytes; i-- > 0;) length = length * 256 + static_cast<unsigned char>(file[8 + i]);
  const std::string_view rest = file.substr(8 + length_bytes);
  if (rest.size() < length) return {};
  return Parts{rest.substr(0, length), rest.substr(length)};
}

}  // namespace

Result<Raster> parse_npy(std::string_view bytes, const std::string& name, std::string_view world,
                         const std::string& world_name) {
  const std::optional<Parts> parts = parts_of(bytes);
  if (!parts) return broken(name, "this is not an array of NumPy, or its header is not complete");
  const Result<ArrayHeader> header = read_header(parts->header, name);
  if (!header) return header.error();
  const std::size_t wanted = std::size_t{header->rows} * header->columns;
  const std::size_t found = parts->data.size() / header->bytes, rest = parts->data.size() % header->bytes;
  if (found != wanted || rest != 0) {
    return broken(name, "expected " + std::to_string(wanted) + " numbers, found " + std::to_string(found) +
                            (rest != 0 ? " and a part of another one" : ""));
  }
  Raster raster;
  raster.columns = header->columns;
  raster.rows = header->rows;
  if (Status placed = read_world(world, world_name, raster); !placed) return placed.error();
  read_values(*header, parts->data, raster);
  return raster;
}

}  // namespace pardel::files
