// Shares: how many of the cases of a property are of a kind, and how many must be. A kind that is rare or absent would
// make a property test less than it says.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pardel::properties {

/// Counts the current case as one of this kind if `is_of_kind` is true. The property fails if fewer than
/// `least_percent` of its cases are of this kind. Call it in every case, at most once per kind. Precondition:
/// least_percent > 0, and `kind` contains no quotation marks.
void classify(bool is_of_kind, const std::string& kind, double least_percent);

struct Shares {
  std::map<std::string, std::uint64_t> cases;  ///< by kind; each case counts once, however often it was tagged
  std::map<std::string, double> promised;      ///< by kind: the least share, in percent
};

/// Counts the tags of RapidCheck's result.
[[nodiscard]] Shares shares_of(const rc::detail::Distribution& distribution);

/// A sentence for each promised share that the cases fall short of. Nothing if there are fewer than 500 cases, because
/// shares of few cases vary too much.
[[nodiscard]] std::vector<std::string> broken_promises(const Shares& shares, std::uint64_t cases);

}  // namespace pardel::properties
