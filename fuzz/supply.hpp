// Supplies numbers from bytes. A number below n is a byte modulo n, so every sequence of bytes is an input, and a small
// change of the bytes is a small change of the case. After the last byte all numbers are zero.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace pardel::fuzz {

class Supply {
 public:
  explicit Supply(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] bool empty() const { return next_ >= bytes_.size(); }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : bytes_[next_++]; }
  /// A number in [0, n). Precondition: 0 < n <= 256.
  int below(int n) { return byte() % n; }
  /// True for `times` of 256 bytes, and false for the byte zero.
  bool flag(int times) { return byte() >= 256 - times; }
  /// One of the values. The byte zero gives the first.
  template <class T, std::size_t N>
  T one_of(const T (&values)[N]) {
    return values[static_cast<std::size_t>(below(static_cast<int>(N)))];
  }
  /// Eight bytes, the first one the lowest.
  std::uint64_t word() {
    std::uint64_t value = 0;
    for (int i = 0; i < 64; i += 8) value |= static_cast<std::uint64_t>(byte()) << i;
    return value;
  }
  /// The next n bytes, or those that are left.
  std::span<const std::uint8_t> take(std::size_t n) {
    const std::span<const std::uint8_t> rest = bytes_.subspan(next_ < bytes_.size() ? next_ : bytes_.size());
    const std::span<const std::uint8_t> taken = rest.first(n < rest.size() ? n : rest.size());
    next_ += n;
    return taken;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace pardel::fuzz
