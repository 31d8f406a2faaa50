// The violations of a certificate in words.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "../core/formats.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/witness.hpp"

namespace pardel::cli {

/// One violation as a short sentence with its place: "triangle 75: angle 34.9° is below 40°, at (0.5, 0.25)". Numbers
/// are rounded. The witness of the violation, which JSON contains, is exact, and counts from 0. `max_circumradius`: as
/// in CheckOptions.
[[nodiscard]] std::string in_words(const Violation& violation, const Goal& goal, const NumbersInWitnesses& numbers,
                                   double max_circumradius = 0);

/// A paragraph per kind of violation: their number, ten of them in words, and how many more there are. `all_in`: the
/// place that lists all of them. Precondition: the certificate lists at least ten violations of each kind, or all.
[[nodiscard]] std::string findings_text(const Certificate& certificate, std::string_view all_in,
                                        const NumbersInWitnesses& numbers, double max_circumradius = 0);

/// What follows the name of the input after the check of a mesh that `pardel mesh` has made: that the violations are
/// missed bounds only, if the mesher knows that it has missed some, and the findings with the numbers of the first
/// output. `is_in_pieces`: ranks have made it, each its triangles. Precondition: it is not valid.
[[nodiscard]] std::string check_message(const Certificate& certificate, bool goal_met, FirstId of_domain,
                                        std::span<const std::filesystem::path> outputs,
                                        std::optional<MeshFormat> of_stream = {}, bool is_in_pieces = false);

}  // namespace pardel::cli
