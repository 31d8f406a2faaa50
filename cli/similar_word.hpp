// "Did you mean": finds the known word that a mistyped word resembles.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pardel::cli {

/// The least number of characters to insert, delete or replace that turns `a` into `b` (Levenshtein 1966).
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `known` with the least edit distance to `word`. Empty if that distance exceeds a third of the length of
/// `word`, rounded up: the words then have too little in common.
[[nodiscard]] std::string similar_word(std::string_view word, std::span<const std::string> known);

}  // namespace pardel::cli
