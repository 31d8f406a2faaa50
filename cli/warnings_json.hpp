// The warnings of a domain in JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "../parallel/least_size.hpp"
#include "../parallel/warnings.hpp"

namespace pardel::cli {

/// `base`: the number of the first point and the first segment.
[[nodiscard]] inline nlohmann::ordered_json warnings_json(std::span<const Warning> warnings, int base) {
  const auto numbered = [&](std::span<const Index> ids) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Index id : ids) list.push_back(std::uint64_t{id} + static_cast<unsigned>(base));
    return list;
  };
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Warning& warning : warnings)
    list.push_back({{"kind", name(warning.kind)},
                    {"points", numbered(warning.points)},
                    {"segments", numbered(warning.segments)},
                    {"where", {warning.where.x, warning.where.y}},
                    {"message", warning.message(base)}});
  return list;
}

/// The warning that the mesh needs many triangles, in the same form.
[[nodiscard]] inline nlohmann::ordered_json warning_json(const LeastSize& least) {
  return {{"kind", "many_triangles"},
          {"points", nlohmann::ordered_json::array()},
          {"segments", nlohmann::ordered_json::array()},
          {"where", {least.where.x, least.where.y}},
          {"message", least.message()}};
}

}  // namespace pardel::cli
