// The evaluation of a certificate by the program.
#pragma once

#include <cstddef>
#include <string>

#include "../properties/checker/check.hpp"

namespace pardel::cli {

/// At most so many triangles or violations are listed on stderr. The counts include all of them.
inline constexpr std::size_t most_listed = 10;

/// True for the kinds that a valid mesh has where it misses a bound of the goal.
[[nodiscard]] bool is_missed_bound(ViolationKind kind);

/// True where is_missed_bound() holds for every violation.
[[nodiscard]] bool only_bounds_missed(const Certificate& certificate);

/// The number of violations by kind, then the first `most` of them, one per line.
[[nodiscard]] std::string violations_text(const Certificate& certificate, std::size_t most);

}  // namespace pardel::cli
