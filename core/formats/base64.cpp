#include "base64.hpp"

#include <cstdint>

namespace pardel::files {
namespace {

constexpr std::string_view blanks = " \t\r\n";

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::string decode_base64(std::string_view text, std::size_t most) {
  std::string bytes;
  std::uint32_t group = 0;
  int digits = 0;
  for (const char c : text) {
    if (bytes.size() >= most) break;
    if (blanks.find(c) != std::string_view::npos) continue;
    if (c == '=') {
      // A group of two digits holds one byte; a group of three digits holds two bytes.
      if (digits == 2) bytes += static_cast<char>(group >> 4);
      if (digits == 3) bytes += {static_cast<char>(group >> 10), static_cast<char>(group >> 2)};
      digits = 0;
      group = 0;
      continue;
    }
    const int digit = base64_digit(c);
    if (digit < 0) break;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (++digits < 4) continue;
    bytes += {static_cast<char>(group >> 16), static_cast<char>(group >> 8), static_cast<char>(group)};
    digits = 0;
    group = 0;
  }
  if (bytes.size() > most) bytes.resize(most);
  return bytes;
}

}  // namespace pardel::files
