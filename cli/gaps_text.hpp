// The gaps of a domain as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "../parallel/gaps.hpp"

namespace pardel::cli {

/// A warning that lists ten gaps, one per line, and names a snapping distance that closes the narrowest. Empty without
/// gaps. `first_id`: the first id of the file.
[[nodiscard]] std::string gaps_text(std::span<const Gap> gaps, const std::string& file, int first_id);

/// All gaps, as an array. Ids are counted from `first_id`.
[[nodiscard]] nlohmann::ordered_json gaps_json(std::span<const Gap> gaps, int first_id);

}  // namespace pardel::cli
