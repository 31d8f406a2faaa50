// Options whose values are markers.
#pragma once

#include <CLI/Validators.hpp>
#include <string>

namespace pardel::cli {

/// CLI11 takes an empty text as 0, so a list without markers would be the marker 0.
[[nodiscard]] inline CLI::Validator marker_value() {
  return {[](std::string& text) { return std::string(text.empty() ? "a marker is missing" : ""); }, ""};
}

}  // namespace pardel::cli
