// --paranoid: what has to be true of a mesh after every sweep of its refinement.
#pragma once

#include <cstdint>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::cli {

struct SweepCheck {
  bool convex_hull = false;
  bool foreign = false;  ///< of check(): the mesh was refined from one that knows nothing of the domain
};

/// Checks the mesh that sweep `number`, counted from 1, left, exactly: conformity, constrained Delaunay, labels. Bounds
/// are due at the end only, and so is what a conforming goal asks of constrained edges. Violations give `internal`,
/// the first of them named.
[[nodiscard]] Status check_sweep(const Pslg& pslg, const Mesh& mesh, std::uint64_t number, const Sweep& sweep,
                                 const SweepCheck& how);

}  // namespace pardel::cli
