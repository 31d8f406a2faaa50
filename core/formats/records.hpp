// Writes many records fast: all threads format blocks of records, which are written in order.
#pragma once

#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstring>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "../array.hpp"
#include "../support/output_file.hpp"

namespace pardel::files {

/// A growing sequence of bytes. Numbers are written with the fewest digits that read back to the same value.
class Bytes {
 public:
  /// Appends numbers, separated by blanks.
  template <class... Numbers>
  Bytes& numbers(Numbers... values) {
    make_room(sizeof...(values) * (longest + 1));
    // One number's end is the next one's begin. In a variable it is at hand sooner than in a member.
    char* to = end_;
    ((to = put(to, values), *to++ = ' '), ...);
    end_ = to - 1;
    return *this;
  }
  template <class Number>
  requires(std::integral<Number> || std::floating_point<Number>) &&
      (!std::same_as<Number, char>)Bytes& operator<<(Number value) {
    return numbers(value);
  }
  Bytes& operator<<(char c) {
    *add(1) = c;
    return *this;
  }
  Bytes& operator<<(std::string_view text) {
    std::copy(text.begin(), text.end(), add(text.size()));
    return *this;
  }
  /// Appends the bytes of the value as they are in memory.
  template <class Value>
  Bytes& raw(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::memcpy(add(sizeof(value)), &value, sizeof(value));
    return *this;
  }
  /// Appends `size` bytes for the caller to set, and returns the first one.
  char* add(std::size_t size) {
    make_room(size);
    return std::exchange(end_, end_ + size);
  }
  [[nodiscard]] std::string_view view() const { return {buffer_.data(), size()}; }
  void clear() { end_ = buffer_.data(); }

 private:
  static constexpr std::size_t longest = 40;  ///< no number has more characters

  template <class Number>
  static char* put(char* to, Number value) {
    return std::to_chars(to, to + longest, value).ptr;
  }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - buffer_.data()); }
  /// The next `size` bytes exist.
  void make_room(std::size_t size) {
    if (static_cast<std::size_t>(buffer_.end() - end_) < size) grow(size);
  }
  void grow(std::size_t size);

  Array<char> buffer_;
  char* end_ = nullptr;  ///< the end of the bytes that are used
};

/// Calls format(bytes, b) for b = 0 .. blocks-1 and writes what it appends, in this order. Several threads call it if
/// there are many blocks; while one of them writes, the others format. Stops early after a failure. Blocks of a quarter
/// of a megabyte fit a cache, and the system takes them in few pieces.
void write_blocks(OutputFile& out, std::size_t blocks, const std::function<void(Bytes&, std::size_t)>& format);

/// The same for n records that are short.
template <class Format>
void write_records(OutputFile& out, std::size_t n, const Format& format) {
  constexpr std::size_t block = 8192;
  write_blocks(out, (n + block - 1) / block, [&](Bytes& to, std::size_t b) {
    const std::size_t end = std::min(n, (b + 1) * block);
    for (std::size_t i = b * block; i < end; ++i) format(to, i);
  });
}

/// Writes the bytes of value(0), ..., value(n-1) as they are in memory.
template <class ValueOf>
void write_values(OutputFile& out, std::size_t n, const ValueOf& value) {
  using Value = std::invoke_result_t<const ValueOf&, std::size_t>;
  static_assert(std::is_trivially_copyable_v<Value>);
  constexpr std::size_t block = (std::size_t{1} << 18) / sizeof(Value);
  write_blocks(out, (n + block - 1) / block, [&](Bytes& to, std::size_t b) {
    const std::size_t begin = b * block, end = std::min(n, begin + block);
    char* const bytes = to.add((end - begin) * sizeof(Value));
    for (std::size_t i = begin; i < end; ++i) {
      const Value each = value(i);
      std::memcpy(bytes + (i - begin) * sizeof(Value), &each, sizeof(Value));
    }
  });
}

}  // namespace pardel::files
