// The checker for a mesh in pieces. No rank holds the whole mesh.
#pragma once

#include "../../core/goal.hpp"
#include "../../core/join_pieces.hpp"
#include "../../core/pslg.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "certificate.hpp"
#include "check_options.hpp"

namespace pardel {

/// Checks the mesh whose pieces the ranks hold, and returns its certificate on all ranks. Collective: all ranks pass
/// the same input, goal and options; options.go_on is not called. Vertices of several pieces with one number are one
/// vertex. Each triangle and each constrained edge is in one piece, and all constrained edges are listed.
///
/// The certificate is that of check(pslg, join_pieces(pieces), goal, options): its numbers of vertices and triangles
/// are those in the joined mesh, and the verdict is the same. If the mesh is wrong in more than its bounds, the lists
/// of violations can differ: wrong_neighbour, euler_characteristic, and non_manifold_vertex at vertices without
/// boundary edges are then not reported, because such meshes cover some points twice, which is. (If triangles are
/// counter-clockwise and joined edge to edge, a vertex that its triangles surround twice is covered twice, and a
/// surface that covers nothing twice is a part of the plane.) Triangles can be counted in other regions if chains are
/// broken.
///
/// Each rank makes the tests of its triangles, and compares triangles at its border with those of other ranks. The
/// first rank gets the triangles around the vertices on segments and at input points. It checks there that segments are
/// chains of edges, and that the boundary is that of the domain, from which the coverage follows.
///
/// Errors: invalid_input if the numbers of vertices are wrong (see join_pieces()), if pieces do not agree on the
/// marker, the origin or the attributes of a vertex on a segment or at an input point, or if a piece has not one number
/// for each vertex; resources if the mesh has more vertices or triangles than an Index can number. Memory of a rank,
/// beside its piece and the input: 10 bytes per triangle of the piece, one bit per point of the whole mesh, and on the
/// first rank the triangles at segments.
[[nodiscard]] Result<Certificate> check(const Pslg& pslg, const NumberedMesh& piece, const Goal& goal,
                                        const CheckOptions& options, Ranks& ranks);

}  // namespace pardel
