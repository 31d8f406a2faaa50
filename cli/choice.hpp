// Options whose value is one of a few words.
#pragma once

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <map>
#include <string>
#include <utility>

namespace pardel::cli {

/// Puts the number of an enumerator in the place of its word, for an option of that type. Not CLI::CheckedTransformer,
/// which writes an enumerator of one byte into its message as a character.
template <class Enum>
[[nodiscard]] CLI::Validator choice(std::map<std::string, Enum> meaning_of) {
  CLI::Validator validator;
  validator.operation([meaning_of = std::move(meaning_of)](std::string& word) {
    const auto found = meaning_of.find(word);
    if (found == meaning_of.end()) {
      std::string words;
      for (const auto& [known, meaning] : meaning_of) words += (words.empty() ? "" : ", ") + known;
      return fmt::format("'{}' is none of {}", word, words);
    }
    word = std::to_string(static_cast<int>(found->second));
    return std::string();
  });
  return validator;
}

}  // namespace pardel::cli
