// Options whose value is one of a few words.
#pragma once

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "../core/support/enum_names.hpp"

namespace pardel::cli {

/// Accepts the names of the enumerators as values of an option of type Enum. CLI::CheckedTransformer cannot be used:
/// its message shows an enumerator of one byte as a character.
template <class Enum, std::size_t n>
[[nodiscard]] CLI::Validator choice(const EnumNames<Enum, n>& names) {
  CLI::Validator validator;
  validator.operation([names](std::string& word) {
    std::vector<std::string> words(names.names.begin(), names.names.end());
    if (const auto found = std::ranges::find(words, word); found != words.end()) {
      word = std::to_string(found - words.begin());  // CLI11 reads an enumerator as its number
      return std::string();
    }
    std::ranges::sort(words);
    return fmt::format("'{}' is not one of {}", word, fmt::join(words, ", "));
  });
  return validator;
}

}  // namespace pardel::cli
