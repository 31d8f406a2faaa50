// Messages between ranks: sequences of numbers and of lists, written and read in the same order.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "../ranks.hpp"
#include "stop_signal.hpp"

namespace pardel {

/// Values in the bytes of a message, where they need not be aligned. Valid until the bytes change.
template <class T>
class PackedList {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  PackedList(const std::byte* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T operator[](std::size_t i) const {
    T value;
    std::memcpy(&value, data_ + i * sizeof(T), sizeof(T));
    return value;
  }

 private:
  const std::byte* data_;
  std::size_t size_;
};

/// Writes a message.
class Writer {
 public:
  /// Writes a list of `count` values, make(0) to make(count - 1), called in this order.
  template <class T, class Make>
  void list_of(std::size_t count, const Make& make) {
    static_assert(std::is_trivially_copyable_v<T>);
    begin_list(count);
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + count * sizeof(T));
    std::byte* const data = bytes_.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
      const T value = make(i);
      std::memcpy(data + i * sizeof(T), &value, sizeof(T));
    }
  }
  /// Takes memory for so many more bytes, so that the message does not move while it grows.
  void reserve(std::size_t more_bytes) { bytes_.reserve(bytes_.size() + more_bytes); }
  template <class T>
  void list(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    begin_list(values.size());
    append(values.data(), values.size_bytes());
  }
  template <class T>
  void list(const std::vector<T>& values) {
    list(std::span<const T>(values));
  }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] Ranks::Bytes take() { return std::exchange(bytes_, {}); }

 private:
  void begin_list(std::uint64_t count) { append(&count, sizeof count); }
  void append(const void* data, std::size_t size) {
    if (size == 0) return;
    const std::size_t old = bytes_.size();
    bytes_.resize(old + size);
    std::memcpy(bytes_.data() + old, data, size);
  }
  Ranks::Bytes bytes_;
};

/// Collective. Sends message r to rank r. Returns the messages for this rank; element r came from rank r.
[[nodiscard]] inline std::vector<Ranks::Bytes> exchange(std::vector<Writer>& messages, Ranks& ranks) {
  std::vector<Ranks::Bytes> bytes;
  bytes.reserve(messages.size());
  for (Writer& message : messages) bytes.push_back(message.take());
  return ranks.exchange(std::move(bytes));
}

/// Reads a message. A message that does not fit throws Stopped with an internal error.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  [[nodiscard]] std::vector<T> list() {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(count_of(sizeof(T)));
    take(values.data(), values.size() * sizeof(T));
    return values;
  }
  /// The same without a copy. Valid as long as the message is.
  template <class T>
  [[nodiscard]] PackedList<T> packed_list() {
    const std::size_t count = count_of(sizeof(T));
    const PackedList<T> values(rest_.data(), count);
    rest_ = rest_.subspan(count * sizeof(T));
    return values;
  }
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  /// The error for a message that is not what the reader expects.
  [[nodiscard]] static Stopped does_not_match() {
    return {{ErrorKind::internal, "a message of another rank is not what this rank expects"}};
  }

 private:
  [[nodiscard]] std::size_t count_of(std::size_t size_of_value) {
    std::uint64_t count = 0;
    take(&count, sizeof count);
    if (count > rest_.size() / size_of_value) throw does_not_match();
    return count;
  }
  void take(void* data, std::size_t size) {
    if (size > rest_.size()) throw does_not_match();
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }
  std::span<const std::byte> rest_;
};

}  // namespace pardel
