// The characters of a text of numbers: blanks, ends of fields, digits.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace pardel::files {

/// A set of characters with codes below 64. One test decides whether a character is in it.
class CharacterSet {
 public:
  explicit constexpr CharacterSet(std::string_view characters) {
    for (const char c : characters) bits_ |= std::uint64_t{1} << static_cast<unsigned char>(c);
  }
  [[nodiscard]] constexpr bool has(char c) const {
    const auto code = static_cast<unsigned char>(c);
    return code < 64 && (bits_ >> code & 1U) != 0;
  }

 private:
  std::uint64_t bits_ = 0;
};

inline constexpr CharacterSet field_blanks(" \t\r\v\f"), field_ends(" \t\r\v\f\n#");

/// Reads the digits at the beginning of a text, up to the first other character, but at most 18 of them. Sets `value`
/// to their value, 0 if there is none. Returns the end of what was read.
inline const char* read_digits(const char* begin, const char* end, std::int64_t& value) {
  constexpr std::ptrdiff_t most = 18, at_once = 8;
  const char* at = begin;
  value = 0;
  if (std::endian::native == std::endian::little && end - begin >= at_once) {
    // Without a branch for each digit, because a processor cannot predict how many there are. Byte k becomes digit k.
    std::uint64_t digits = 0;
    std::memcpy(&digits, begin, sizeof(digits));
    digits ^= 0x3030303030303030U;
    // The highest bit of the first byte that is greater than 9 is set; those of later bytes have no meaning.
    const std::uint64_t others = (digits | (digits + 0x7676767676767676U)) & 0x8080808080808080U;
    const int n = std::countr_zero(others) / 8;
    if (n == 0) return begin;
    digits <<= 64 - 8 * n;                              // zeros in front of the digits
    digits = digits * 10 + (digits >> 8U);              // each even byte: two digits
    constexpr std::uint64_t two = 0x000000ff000000ffU;  // the bytes with digits 1, 2, 5 and 6
    digits = (digits & two) * (100 + (1'000'000ULL << 32U)) + (digits >> 16U & two) * (1 + (10'000ULL << 32U));
    value = static_cast<std::int64_t>(digits >> 32U);
    at += n;
    if (n < at_once) return at;
  }
  for (; at != end && *at >= '0' && *at <= '9' && at - begin < most; ++at) value = 10 * value + (*at - '0');
  return at;
}

}  // namespace pardel::files
