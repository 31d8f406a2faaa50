// Writes many records fast: all threads format blocks of records, and one thread writes the blocks in order.
#pragma once

#include <algorithm>
#include <charconv>
#include <concepts>
#include <functional>
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

/// Calls format(bytes, b) for b = 0 .. blocks-1 and writes what it appends, in this order. Several threads call it if
/// there are many blocks. Stops early after a failure.
void write_blocks(OutputFile& out, std::size_t blocks, const std::function<void(Bytes&, std::size_t)>& format);

/// The same for n records that are short.
template <class Format>
void write_records(OutputFile& out, std::size_t n, const Format& format) {
  constexpr std::size_t block = 4096;
  write_blocks(out, (n + block - 1) / block, [&](Bytes& to, std::size_t b) {
    const std::size_t end = std::min(n, (b + 1) * block);
    for (std::size_t i = b * block; i < end; ++i) format(to, i);
  });
}

}  // namespace pardel::files
