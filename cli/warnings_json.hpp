// The warnings of a domain in JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "../parallel/warnings.hpp"

namespace pardel::cli {

/// `base`: the number of the first segment.
[[nodiscard]] inline nlohmann::ordered_json warnings_json(std::span<const Warning> warnings, int base) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Warning& warning : warnings) {
    nlohmann::ordered_json segments = nlohmann::ordered_json::array();
    for (const Index segment : warning.segments)
      segments.push_back(std::uint64_t{segment} + static_cast<unsigned>(base));
    list.push_back({{"segments", std::move(segments)},
                    {"where", {warning.where.x, warning.where.y}},
                    {"message", warning.message(base)}});
  }
  return list;
}

}  // namespace pardel::cli
