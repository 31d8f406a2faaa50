// --paranoid: checks the mesh after every sweep of the refinement. A sweep goes once through all cells of a level.
#pragma once

#include <cstdint>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::cli {

struct SweepCheck {
  bool convex_hull = false;
  bool foreign = false;  ///< as CheckOptions::foreign: the origins of the refined mesh's vertices are unknown
};

/// Checks with exact arithmetic that the mesh after sweep `number` (counted from 1) conforms to the Pslg, is
/// constrained Delaunay and has the right labels. Does not check bounds or the conforming Delaunay property, because
/// these hold only at the end. A violation gives an `internal` error; the message names the first violation.
[[nodiscard]] Status check_sweep(const Pslg& pslg, const Mesh& mesh, std::uint64_t number, const Sweep& sweep,
                                 const SweepCheck& how);

}  // namespace pardel::cli
