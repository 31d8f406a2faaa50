// How the program evaluates and prints a certificate.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "../properties/checker/check.hpp"
#include "exit_code.hpp"

namespace pardel::cli {

/// The largest number of triangles or violations that are listed on stderr. The counts include all of them.
inline constexpr std::size_t most_listed = 10;

/// How many violations of each kind a certificate has to list: all of them if they are written to the file `json`.
[[nodiscard]] std::size_t most_kept(const std::filesystem::path& json);

/// True for the kinds of violations that a valid mesh has if it misses a bound of the goal.
[[nodiscard]] bool is_missed_bound(ViolationKind kind);

/// True if is_missed_bound() holds for every violation.
[[nodiscard]] bool only_bounds_missed(const Certificate& certificate);

/// The exit code of a command that has made a mesh and perhaps checked it.
[[nodiscard]] ExitCode code_of(const std::optional<Certificate>& certificate, bool goal_met);

/// The number of violations by kind, then the first `most` of them, one per line, with the numbers of files.
[[nodiscard]] std::string violations_text(const Certificate& certificate, std::size_t most,
                                          const NumbersInWitnesses& numbers);

}  // namespace pardel::cli
