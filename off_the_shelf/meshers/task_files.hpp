// A subdomain as Triangle's files, and the answer of a program as a mesh.
#pragma once

#include <filesystem>
#include <span>

#include "../../core/mesh.hpp"
#include "../../core/result.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// Writes stem.node, stem.ele, stem.poly and stem.area (program_mesher.hpp). `caps`: see area_caps(). Errors: `io`;
/// with holes, those of hole_seeds().
[[nodiscard]] Status write_task(const Subdomain& subdomain, std::span<const double> caps,
                                const std::filesystem::path& stem, bool with_holes);

/// The answer that a mesh is: its points after those of the subdomain are new.
[[nodiscard]] RefinedSubdomain answer_of(const Mesh& mesh, const Subdomain& subdomain);

}  // namespace pardel::engine
