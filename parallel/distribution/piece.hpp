// The piece of the mesh that a rank owns, as plain values.
#pragma once

#include "../conversion/domain_triangulation.hpp"
#include "../conversion/export_mesh.hpp"
#include "../distributed.hpp"
#include "distribution.hpp"

namespace pardel::engine {

/// Makes the piece of this rank after the refinement, in the storage of the triangulation. Collective. `data`,
/// `background`: see add_point_data(). `exempt`: triangles of the piece; their indices become those in the piece.
[[nodiscard]] MeshPiece make_piece(DomainTriangulation& domain, const Distribution& distribution,
                                   std::vector<double> region_attributes, const PointData& data,
                                   std::vector<std::array<Index, 3>> background, std::vector<Exemption>& exempt,
                                   const Threads& threads);

}  // namespace pardel::engine
