#include "text.hpp"

#include <array>
#include <charconv>

#include "../../../core/support/shortest.hpp"

namespace pardel::checker {
namespace {

template <class... Format>
std::string digits(Format... format) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), format...);
  return {buffer.data(), end.ptr};
}

}  // namespace

std::string to_text(long long value) { return digits(value); }
std::string to_text(unsigned long long value) { return digits(value); }
std::string to_text(double value) { return shortest(value); }
std::string to_text(Point p) { return shortest(p); }
std::string to_short_text(double value) { return digits(value, std::chars_format::general, 6); }

}  // namespace pardel::checker
