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

/// Writes a message.
class Writer {
 public:
  template <class T>
  void list(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = values.size();
    append(&count, sizeof count);
    append(values.data(), values.size_bytes());
  }
  template <class T>
  void list(const std::vector<T>& values) {
    list(std::span<const T>(values));
  }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }
  [[nodiscard]] Ranks::Bytes take() { return std::exchange(bytes_, {}); }

 private:
  void append(const void* data, std::size_t size) {
    if (size == 0) return;
    const std::size_t old = bytes_.size();
    bytes_.resize(old + size);
    std::memcpy(bytes_.data() + old, data, size);
  }
  Ranks::Bytes bytes_;
};

/// Reads a message. A message that does not fit throws Stopped with an internal error.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  [[nodiscard]] std::vector<T> list() {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t count = 0;
    take(&count, sizeof count);
    if (count > rest_.size() / sizeof(T)) throw does_not_match();
    std::vector<T> values(count);
    take(values.data(), count * sizeof(T));
    return values;
  }
  [[nodiscard]] bool empty() const { return rest_.empty(); }
  /// The error for a message that is not what the reader expects.
  [[nodiscard]] static Stopped does_not_match() {
    return {{ErrorKind::internal, "a message of another rank is not what this rank expects"}};
  }

 private:
  void take(void* data, std::size_t size) {
    if (size > rest_.size()) throw does_not_match();
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }
  std::span<const std::byte> rest_;
};

}  // namespace pardel
