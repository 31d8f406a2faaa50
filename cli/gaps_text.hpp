// The gaps of a domain as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "../parallel/gaps.hpp"

namespace pardel::cli {

/// A warning that lists ten gaps of the domain, one per line, and names a snapping distance that closes the narrowest.
/// A trial of the repair shows what it merges and removes, and if that is more than gaps; the text says so. Empty
/// without gaps.
[[nodiscard]] std::string gaps_text(std::span<const Gap> gaps, const std::string& file, const ValidPslg& domain);

/// All gaps, as an array. Ids are counted from `first_id`.
[[nodiscard]] nlohmann::ordered_json gaps_json(std::span<const Gap> gaps, int first_id);

}  // namespace pardel::cli
