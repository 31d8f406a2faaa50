// A mesh that several processes (ranks) make together with a sequential mesher of the caller's.
#pragma once

#include "../off_the_shelf/mesh_with_mesher.hpp"
#include "distributed.hpp"

namespace pardel {

struct PieceWithMesher {
  MeshPiece piece;      ///< of this rank
  MesherReport mesher;  ///< of all ranks; but the gluing, and the extraction of parts for it, is that of this rank
};

/// Makes the mesh of mesh_with_mesher() in one process, and divides it among the ranks. Collective: all ranks pass
/// equal arguments, but options.threads may differ, and each has a mesher of its own. Each rank does its share of the
/// tasks of each phase, and sends the verified answers to all other ranks: one exchange per phase. The mesh depends
/// neither on the number of ranks nor on threads if the mesher's answers depend on the subdomains alone.
///
/// Memory of a rank: the whole mesh until the mesher has finished, then as mesh() in ranks.
///
/// Errors: those of mesh_with_mesher(), and of mesh() in ranks.
[[nodiscard]] Result<PieceWithMesher> mesh_with_mesher(const ValidPslg& domain, const Goal& goal,
                                                       SubdomainMesher& mesher, const MesherOptions& how,
                                                       const Options& options, Ranks& ranks);

}  // namespace pardel
