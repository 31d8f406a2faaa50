// A command line as words, without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "../../core/result.hpp"

namespace pardel::harness {

/// Splits at blanks as a shell does: 'as it is', "with \" and \\", and \ before any other character. Nothing is
/// expanded: no variables, no wildcards, no pipes. An open quotation mark or a last \ is an error (usage).
[[nodiscard]] Result<std::vector<std::string>> split_words(std::string_view line);

/// `text` with every `what` replaced.
[[nodiscard]] std::string replaced(std::string text, std::string_view what, std::string_view with);

}  // namespace pardel::harness
