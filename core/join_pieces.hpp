// Makes one mesh of the pieces that several processes have made.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh.hpp"
#include "result.hpp"

namespace pardel {

/// A piece of a mesh, and for each of its points the number in the whole mesh.
struct NumberedMesh {
  Mesh mesh;
  Array<std::uint64_t> number;
};

/// The whole mesh: its points in the order of their numbers, the triangles of the first piece first. Points at the
/// border are in several pieces, triangles and constrained edges in one. The pieces agree on the meaning of
/// Mesh::region, as those of mesh(domain, goal, options, ranks) do. The neighbours are computed. Fields and names are
/// joined as join_fields() and join_names() say.
///
/// Errors: invalid_input if a number is missing, if different points have one number, or one point has different
/// markers, origins or attributes, or if some pieces have regions or attributes of points and others have none;
/// resources if the mesh has more points or triangles than an Index can number. Time O(n) for n triangles.
/// `first_id`: what messages call the number 0.
[[nodiscard]] Result<Mesh> join_pieces(std::span<const NumberedMesh> pieces, FirstId first_id = {});

/// The same for some of the pieces of a mesh: makes one piece of them. Numbers that belong to other pieces are missing.
[[nodiscard]] Result<NumberedMesh> join_some_pieces(std::vector<NumberedMesh> pieces);

/// Joins the points of a piece that have one number. The points of the result are in the order of their numbers.
/// Triangles and edges remain in their order. Precondition: their corners are points of the piece.
[[nodiscard]] Result<NumberedMesh> join_points(NumberedMesh piece);

}  // namespace pardel
