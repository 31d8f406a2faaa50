// From a Mesh to the triangulation of a domain, for the refinement of an existing mesh.
#pragma once

#include "../../core/mesh.hpp"
#include "../../core/result.hpp"
#include "../construction/domain_triangulation.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// Makes the domain that a mesh covers. Its segments are the constrained edges and the boundary edges of the mesh,
/// which are joined where they continue each other on a straight line (join_subsegments.hpp). Edges that are not
/// locally Delaunay are flipped. Errors: invalid_input if the mesh is not a manifold of positively oriented triangles
/// with consistent neighbours; resources if it has more triangles than the engine can number. Runs on one
/// thread.
[[nodiscard]] Result<DomainTriangulation> import_mesh(const Mesh& mesh, const Threads& threads = {});

}  // namespace pardel::engine
