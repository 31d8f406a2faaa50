// The piece of the mesh that a rank owns, as plain values.
#pragma once

#include "../../parallel/construction/domain_triangulation.hpp"
#include "../../parallel/scheduling/refine_domain.hpp"
#include "../distributed.hpp"
#include "distribution.hpp"

namespace pardel::engine {

/// Makes the piece of this rank after the refinement, in the storage of the triangulation. Collective. `exempt`:
/// triangles of the piece; their indices become those in the piece, and their apexes points of the input.
[[nodiscard]] MeshPiece make_piece(DomainTriangulation& domain, const Distribution& distribution, InputData input,
                                   std::vector<Exemption>& exempt, const Threads& threads);

}  // namespace pardel::engine
