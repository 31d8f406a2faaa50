// Splits a command line into words without a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "../../core/result.hpp"

namespace pardel::harness {

/// Splits at blanks as a shell does. Between single quotation marks all characters are literal. Between double
/// quotation marks, a backslash makes the next character literal only if it is " or \. Outside quotation marks it does
/// so for every character. There are no variables, wildcards or pipes. An open quotation mark, or a backslash at the
/// end, is an error of kind `usage`.
[[nodiscard]] Result<std::vector<std::string>> split_words(std::string_view line);

/// Returns `text` with every `what` replaced by `with`.
[[nodiscard]] std::string replaced(std::string text, std::string_view what, std::string_view with);

}  // namespace pardel::harness
