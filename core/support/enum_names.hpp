// Tables of the names of enumerators. The compiler rejects a table that lacks an enumerator or has another order.
//
//   constexpr auto colour_names = enum_names<Colour>({{Colour::red, "red"}, {Colour::green, "green"}});
//   colour_names[Colour::red]      // "red"
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace pardel {
namespace detail {

/// False if `value` equals no enumerator of its type. The test uses that g++ and clang print an enumerator by its name,
/// but any other value as a cast: "(Colour)2".
template <auto value>
[[nodiscard]] consteval bool is_enumerator() {
  const std::string_view text = __PRETTY_FUNCTION__;
  const std::string_view printed = text.substr(text.rfind("value = "));
  const std::size_t bracket = printed.rfind(')');
  return bracket == std::string_view::npos || printed[bracket + 1] < '0' || printed[bracket + 1] > '9';
}

}  // namespace detail

/// One name per enumerator of Enum, whose values are 0 to n - 1.
template <class Enum, std::size_t n>
struct EnumNames {
  std::array<const char*, n> names{};

  [[nodiscard]] static constexpr std::size_t size() { return n; }

  /// Returns the name; "unknown" if `value` is not an enumerator.
  [[nodiscard]] constexpr const char* operator[](Enum value) const {
    const auto i = static_cast<std::size_t>(value);
    return i < n ? names[i] : "unknown";
  }
};

/// Makes a table. `entries`: every enumerator with its name, in the order of the enumerators' values.
template <class Enum, std::size_t n>
[[nodiscard]] consteval EnumNames<Enum, n> enum_names(const std::pair<Enum, const char*> (&entries)[n]) {
  static_assert(detail::is_enumerator<static_cast<Enum>(n - 1)>(), "the table has more entries than enumerators");
  static_assert(!detail::is_enumerator<static_cast<Enum>(n)>(), "an enumerator has no name");
  EnumNames<Enum, n> table;
  for (std::size_t i = 0; i < n; ++i) {
    if (static_cast<std::size_t>(entries[i].first) != i) throw "the names are not in the order of the enumerators";
    table.names[i] = entries[i].second;
  }
  return table;
}

}  // namespace pardel
