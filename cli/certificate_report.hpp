// What the programs say about a certificate.
#pragma once

#include <filesystem>

#include "../core/result.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/witness.hpp"

namespace pardel::cli {

/// The Error of a field of sizes that has no value at the centroid of a triangle: of the first such triangle. Without
/// sizes there is no verdict. The checker counts these triangles as too large, so they are looked for only if it found
/// large ones.
[[nodiscard]] Status require_sizes(const Mesh& mesh, const Goal& goal, const Certificate& certificate);

/// False if require_sizes() would look at no triangle of any mesh.
[[nodiscard]] bool may_lack_sizes(const Goal& goal, const Certificate& certificate);

/// Prints the summary and the findings. `json`: the file with all findings, or empty. `max_circumradius`: as in
/// CheckOptions.
void print_certificate(const Certificate& certificate, const std::filesystem::path& json,
                       const NumbersInWitnesses& numbers, double max_circumradius);

}  // namespace pardel::cli
