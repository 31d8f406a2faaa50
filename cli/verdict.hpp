// What a certificate means to the program.
#pragma once

#include <cstddef>
#include <string>

#include "../properties/checker/check.hpp"

namespace pardel::cli {

/// Triangles or violations that are listed on stderr; the counts are complete.
inline constexpr std::size_t most_listed = 10;

/// True for the violations of a goal alone: the mesh is right but for a bound that is not met.
[[nodiscard]] bool is_missed_bound(ViolationKind kind);

/// True where every violation counted is one of these.
[[nodiscard]] bool only_bounds_missed(const Certificate& certificate);

/// How many violations there are, by kind, then the first `most` of them, a line each.
[[nodiscard]] std::string violations_text(const Certificate& certificate, std::size_t most);

}  // namespace pardel::cli
