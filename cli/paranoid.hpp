// --paranoid: the check of the mesh after every sweep of the refinement.
#pragma once

#include <cstdint>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::cli {

struct SweepCheck {
  bool convex_hull = false;
  bool foreign = false;  ///< CheckOptions::foreign: the mesh was refined from a mesh without provenance
};

/// Checks with exact arithmetic that the mesh after sweep `number` (counted from 1) conforms to the Pslg, is
/// constrained Delaunay and has the right labels. Bounds, and the conforming Delaunay property, hold only at the end
/// and are not checked. Violations give `internal`; the message names the first of them.
[[nodiscard]] Status check_sweep(const Pslg& pslg, const Mesh& mesh, std::uint64_t number, const Sweep& sweep,
                                 const SweepCheck& how);

}  // namespace pardel::cli
