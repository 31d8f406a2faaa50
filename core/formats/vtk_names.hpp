// The names of arrays in a legacy file of VTK, which are words. Source: vtkDataWriter::EncodeString, which writes
// blanks and other characters as `%` and two digits. So is `#` here, which begins a comment for TextReader.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace pardel::files {

/// The name as one word. An array without a name gets that which VTK gives to it.
[[nodiscard]] inline std::string word_in_vtk(std::string_view name) {
  constexpr char digits[] = "0123456789ABCDEF";
  const bool is_section = name == "METADATA";  // such a word is no array
  std::string word;
  for (const char c : name.empty() ? std::string_view("field") : name) {
    const auto byte = static_cast<std::uint8_t>(c);
    const bool is_plain =
        byte > ' ' && byte < 0x7f && c != '"' && c != '%' && c != '#' && (!is_section || !word.empty());
    if (is_plain) word += c;
    if (!is_plain) word += {'%', digits[byte / 16], digits[byte % 16]};
  }
  return word;
}

/// The name that the word stands for.
[[nodiscard]] inline std::string name_in_vtk(std::string_view word) {
  std::string name;
  while (!word.empty()) {
    std::uint8_t byte = 0;
    const char* const begin = word.data() + 1;
    const bool is_code =
        word.front() == '%' && word.size() > 2 && std::from_chars(begin, begin + 2, byte, 16).ptr == begin + 2;
    name += is_code ? static_cast<char>(byte) : word.front();
    word.remove_prefix(is_code ? 3 : 1);
  }
  return name;
}

}  // namespace pardel::files
