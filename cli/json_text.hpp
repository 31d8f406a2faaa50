// The text of a JSON file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pardel::cli {

/// With indentation, and a newline at the end. JSON is UTF-8, but the name of a file may be any bytes: each part that
/// is not UTF-8 becomes U+FFFD.
[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace pardel::cli
