// Refines a domain whose interior is filled with patches.
#pragma once

#include "filled_round.hpp"

namespace pardel::engine {

/// Cuts patches out of the domain, refines the rest, and lays the patches. Where a triangle is left that cannot be
/// split because of a patch, the patch gives way, and the refinement starts again (rounds.hpp). If no patch fits, or
/// after too many rounds, refines the whole domain without patches; also if this makes fewer triangles, which is tried
/// where less than half of the triangles are laid. Report::laid is 0 then. `domain`: the triangulation of the Pslg.
/// Errors: as from refine_by_sweeps().
[[nodiscard]] Result<Mesh> refine_filled(const ToFill& what, DomainTriangulation domain, const Criteria& criteria,
                                         const InputData& input, const Options& options, ProgressMonitor& progress,
                                         Report& report);

}  // namespace pardel::engine
