// Splits a command line into words without a shell.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../result.hpp"

namespace pardel {

/// Splits at blanks as a shell does. Between single quotation marks all characters are literal. Between double
/// quotation marks, a backslash makes the next character literal only if it is " or \. Outside quotation marks it does
/// so for every character. There are no variables, wildcards or pipes. An open quotation mark, or a backslash at the
/// end, is an error of kind `usage`.
[[nodiscard]] Result<std::vector<std::string>> split_words(std::string_view line);

/// Returns `text` with every `what` replaced by `with`.
[[nodiscard]] std::string replaced(std::string text, std::string_view what, std::string_view with);

/// Returns `text` with every placeholder, such as "{out}", replaced by its value. Values are not searched again.
[[nodiscard]] std::string filled_in(std::string_view text,
                                    std::span<const std::pair<std::string_view, std::string>> placeholders);

}  // namespace pardel
