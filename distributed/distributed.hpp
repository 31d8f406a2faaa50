// One mesh made by several processes (ranks). None of them holds all of a large mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "../core/digest.hpp"
#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/part_of_points.hpp"
#include "../core/piece_of_mesh.hpp"
#include "../core/ranks.hpp"
#include "../parallel/options.hpp"
#include "../parallel/report.hpp"
#include "../parallel/validate.hpp"

namespace pardel {

/// The part of a mesh that belongs to one rank. Each triangle, and each constrained edge, belongs to one rank.
struct MeshPiece {
  /// The triangles, with all their corners, in numbers of the piece. Triangles have no neighbours in other pieces.
  Mesh mesh;
  /// For each point of `mesh`, its number in the whole mesh: input points first, in their order, then the others. The
  /// numbers depend on the domain, the goal and the options only, not on the number of ranks or of pieces. If the
  /// interior is filled, they are those of the mesh of one process.
  Array<std::uint64_t> number;
  std::vector<SharedVertices> shared;  ///< in ascending order of ranks
  std::uint64_t first_point = 0;       ///< see PieceOfMesh
  std::uint64_t first_triangle = 0;    ///< the number of triangles of the pieces before this one
  // Of the whole mesh:
  std::uint64_t points = 0, triangles = 0, constrained_edges = 0;
  std::uint64_t missed = 0;  ///< triangles that miss the goal although no small input angle justifies it
  /// Triangles of other pieces that this rank held when the refinement ended. 0 if the ranks did not refine together.
  std::uint64_t margin = 0;
  double seconds = 0;  ///< to make the piece after the refinement
  /// Of the whole run, except for what belongs to this rank: exemptions (Exemption::triangle is a triangle of the
  /// piece), times, Sweep::largest_task, and the threads of cells. It has no sweeps for triangles whose cavities fit no
  /// box.
  Report report;
};

/// Makes the mesh of mesh(domain, goal, options), and divides it among the ranks. Collective: all ranks pass equal
/// arguments, but options.threads may differ. Every rank refines the coarse levels for itself. Then each rank refines
/// the tiles that it owns, which follow each other on a space-filling curve, and exchanges triangles near its border
/// with the other ranks after each phase. The mesh depends neither on the number of ranks nor on threads.
///
/// If the interior is filled (Options::interior), every rank refines what is around the equilateral triangles for
/// itself, and makes its share of all triangles; the ranks exchange nothing. Where one process would refine the whole
/// domain for comparison, or because the filling has to be given up, the ranks do so, too, as described above.
///
/// Memory of a rank: its share of the mesh, a margin around it (half a tile wide on a lattice, the neighbouring leaves
/// of a quadtree), the input, and the coarse levels; if the interior is filled, the mesh around the equilateral
/// triangles. options.max_memory is a limit for each rank.
///
/// Errors, beside those of mesh(): `usage` for options.max_vertices and options.after_sweep, which are for one process;
/// `resources` for a filled interior with more triangles or points than an Index can number. Errors of validation and
/// of the coarse levels occur on all ranks alike. If a later error occurs on one rank only, the other ranks wait for
/// it; the caller has to end them (MPI_Abort).
[[nodiscard]] Result<MeshPiece> mesh(const ValidPslg& domain, const Goal& goal, const Options& options, Ranks& ranks);

/// Makes the mesh in more pieces than there are ranks, one after another, so that a rank needs the memory of one piece
/// only. Only for interiors that are filled. Calls visit(piece, number): rank r makes the pieces r, r + count, and so
/// on; it makes the next one when visit() has returned. An error that visit() returns ends the run on this rank, and
/// becomes the result. visit() is called in the thread of the caller, and should not communicate: ranks can have
/// different numbers of pieces.
///
/// If the filling has to be given up, or if a refined mesh has fewer triangles (Report::laid is 0), the ranks make that
/// mesh together as mesh() does. Then rank r has piece r, and the other pieces are empty.
///
/// Collective; arguments and errors as for mesh(), and `usage` if there are fewer pieces than ranks, or if the options
/// and the goal do not fill the interior: options.interior, and constant bounds on areas or edges.
[[nodiscard]] Status mesh_in_pieces(const ValidPslg& domain, const Goal& goal, const Options& options, Ranks& ranks,
                                    int pieces, const std::function<Status(MeshPiece&& piece, int number)>& visit);

/// Makes the Delaunay triangulation of the points of all ranks: that of triangulate() in one process, with the edges of
/// the convex hull as constrained edges. Collective. No rank has all points: they are divided along a space-filling
/// curve, and each rank triangulates its own. Then ranks ask each other about the triangles at their borders. The
/// numbers of the points in the pieces are those of the input. The triangulation depends neither on the number of ranks
/// nor on which rank has read which points.
///
/// Memory of a rank: its share of the points and triangles, the points of others beside its own, about 8 points per
/// rank from all over the plane, and the convex hull. All points in one cell of a grid of 2^16 by 2^16 cells over the
/// points go to one rank.
///
/// Errors, on all ranks alike: `invalid_input`, with the problems that find_problems() lists; `resources` if a rank
/// gets more than 2^28 - 3 points. Of the options, threads and progress are used.
[[nodiscard]] Result<MeshPiece> triangulate(PartOfPoints&& points, const Options& options, Ranks& ranks);

/// The problems of points of which each rank has a part, on all ranks alike: those of find_problems() (validate.hpp)
/// for a domain of these points, except that equal points are not searched for if coordinates or counts cannot be used.
/// Collective. `threads`: of this rank; 0: as many as OpenMP offers.
[[nodiscard]] std::vector<Problem> find_problems(PartOfPoints&& points, int threads, Ranks& ranks);

/// True if mesh() can begin with points that are divided among ranks: the goal has no field of sizes and no gradation
/// (bounds on angles, areas, edges, and areas of regions are possible), the decomposition is a lattice or none, the
/// interior is refined, and there is neither a limit on vertices nor a function that needs the whole mesh.
[[nodiscard]] bool can_divide_points(const Goal& goal, const Options& options);

/// Makes the mesh of a domain that no rank has as a whole: that of mesh() for the domain, with the same numbers.
/// Collective; all ranks pass the same holes and regions. The points are triangulated as by triangulate(). Each rank
/// gets the segments at its points. Those that are no edges of this triangulation are inserted by all ranks. One rank
/// refines the coarse levels, in a gathered submesh: the triangles that are long compared with the tiles, and some
/// around them. Then the triangles go to the ranks that refine their tiles.
///
/// Memory of a rank: its share of the mesh and of the segments, a margin around it, the segments that cross triangles
/// of the triangulation of the points, these triangles and the segments at them, and the vertices of the convex hull;
/// on the first rank also the submesh. If points have attributes, also its share of the triangulation of the points, on
/// which they are interpolated. Time for the segments, on each rank: O((k + c) log (k + c)) for k segments and hull
/// vertices that the rank knows, and c crossed triangles. MeshPiece::report has no gaps, and no sweeps of the coarse
/// levels.
///
/// Errors as for triangulate() and mesh(). On all ranks alike: `invalid_input`, with all problems as find_problems()
/// lists them (then the first rank has had the whole domain); `usage` if
/// can_divide_points() is false, or if domain.rest has points or segments.
[[nodiscard]] Result<MeshPiece> mesh(PartOfPslg&& domain, const Goal& goal, const Options& options, Ranks& ranks);

/// The piece as the writers of files need it. The piece must not be moved while the result is used.
[[nodiscard]] inline PieceOfMesh view_of(const MeshPiece& piece) {
  return {piece.mesh, piece.number.span(), piece.shared, piece.first_point, piece.points};
}

/// The digest of the whole mesh (core/digest.hpp). Collective.
[[nodiscard]] Digest digest(const MeshPiece& piece, Ranks& ranks);

}  // namespace pardel
