// The checker for a mesh in pieces. No rank holds the whole mesh, and a rank with several pieces holds one at a time.
#pragma once

#include "../../core/goal.hpp"
#include "../../core/join_pieces.hpp"
#include "../../core/pslg.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "certificate.hpp"
#include "check_options.hpp"
#include "pieces_of_rank.hpp"

namespace pardel {

/// Checks the mesh whose pieces the ranks have, and returns its certificate on all ranks. Collective: all ranks pass
/// the same input, goal and options; options.go_on is not called. Vertices with one number are one vertex, in several
/// pieces or in one. Each triangle and each constrained edge is in one piece, and all constrained edges are listed.
///
/// The certificate is that of check(pslg, join_pieces(pieces), goal, options), for the pieces of the first rank, then
/// those of the second one, and so on: its numbers of vertices and triangles are those in the joined mesh, and the
/// verdict is the same. If the mesh is wrong in more than its bounds, the lists of violations can differ:
/// wrong_neighbour, euler_characteristic, and non_manifold_vertex at vertices without boundary edges are then not
/// reported, because such meshes cover some points twice, which is. (If triangles are counter-clockwise and joined edge
/// to edge, a vertex that its triangles surround twice is covered twice, and a surface that covers nothing twice is a
/// part of the plane.) Triangles can be counted in other regions if chains are broken, triangles that lie on each other
/// are counted differently, and wrong_count is reported for each piece.
///
/// A rank reads its pieces in turn, and tests the triangles of each. It keeps the triangles at the border of the piece
/// and around vertices that have to do with the input, the numbers of the vertices as one bit each, and the measures.
/// Input points at which no segment ends are judged in the piece that has their triangles; only what is wrong there
/// remains. When all ranks have done so, they compare the borders, and the first rank gets the triangles around the
/// vertices on segments and at the remaining input points. It checks there that segments are chains of edges, and that
/// the boundary is that of the domain, from which the coverage follows. Then a rank reads those pieces again in which
/// something was found that only a segment can excuse, or that has to be described: a triangle below the angle bound,
/// an edge that is not locally Delaunay, any violation. Each piece is read again if a triangle may contain the seed of
/// a hole, which the boundary decides, or if a vertex in the interior of one piece is in another piece. If the input
/// has regions, each piece is read three times: chains divide its triangles into sets, and all sets have to be known
/// before a triangle has a region. A rank with one piece keeps it in memory instead.
///
/// Errors: invalid_input if the numbers of vertices are wrong (see join_pieces()), if pieces do not have the same kinds
/// of data, or do not agree on the place, the marker, the origin or the attributes of a vertex, or if a piece has not
/// one number for each vertex; resources if the mesh has more vertices or triangles than an Index can number; those of
/// PiecesOfRank::read(), and io if a piece that is read again has another size. Memory of a rank, beside the piece that
/// it holds and the input: 10 bytes per triangle of this piece; for all its pieces, about 300 bytes per vertex at a
/// border or on a segment; one bit per point of the whole mesh; and on the first rank the triangles at segments.
[[nodiscard]] Result<Certificate> check(const Pslg& pslg, const PiecesOfRank& pieces, const Goal& goal,
                                        const CheckOptions& options, Ranks& ranks);

/// The same for one piece per rank, which the rank holds.
[[nodiscard]] inline Result<Certificate> check(const Pslg& pslg, const NumberedMesh& piece, const Goal& goal,
                                               const CheckOptions& options, Ranks& ranks) {
  return check(pslg, only_piece(piece), goal, options, ranks);
}

}  // namespace pardel
