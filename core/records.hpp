// Writing many records fast: each block of records is formatted by one thread, and the blocks are written in
// order. The bytes do not depend on the number of threads.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "output_file.hpp"

namespace pardel {

/// Bytes under construction. Numbers take the fewest digits that read back to the same value.
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
  /// The value's own bytes, as the machine holds them.
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

/// Writes what format(bytes, i) appends for i = 0 .. n-1. `format` is called from several threads at once.
template <class Format>
void write_records(OutputFile& out, std::size_t n, const Format& format) {
  constexpr std::size_t block = std::size_t{1} << 14;
  const std::size_t blocks = (n + block - 1) / block;
#pragma omp parallel if (blocks > 1)
  {
    Bytes bytes;
#pragma omp for ordered schedule(static, 1)
    for (std::size_t b = 0; b < blocks; ++b) {
      bytes.clear();
      const std::size_t end = b + 1 == blocks ? n : (b + 1) * block;
      for (std::size_t i = b * block; i < end; ++i) format(bytes, i);
#pragma omp ordered
      out.write(bytes.view());
    }
  }
}

}  // namespace pardel
