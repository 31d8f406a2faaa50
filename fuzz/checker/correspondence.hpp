// Whether the chains of a mesh lie to each other as the walls of the domain do, by definition (properties/THEORY.md,
// (V2)).
//
// Preconditions in this file: the mesh is conformal, its vertices begin with the input points, and there is one chain
// for each wall that has the domain on a side.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "chains.hpp"

namespace pardel::fuzz {

/// The vertices that are no input points, and that the chains of different walls pass.
[[nodiscard]] std::set<Index> meeting_points(const Chains& chains, const Pslg& pslg);

/// The input points around which the first edges of three chains do not turn as their walls do.
[[nodiscard]] std::set<Index> points_of_another_order(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg);

/// Are the border of the mesh and the triangles at the chains where the border of the domain and the domain are? Each
/// edge with one triangle belongs to a chain, and a chain has triangles on the sides on which its wall has the domain.
[[nodiscard]] bool has_the_sides_of_the_domain(const ExactMesh& mesh, const Chains& chains);

/// The faces of the walls, and the faces of their chains. Precondition: chains meet in input points only.
struct FacesOfChains {
  FacesOfChains(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg, const InputFaces& faces);

  /// Is there a bijection between them that maps each side of a wall to this side of its chain, and the outside to the
  /// outside? Only walls count that have the domain on a side.
  bool correspond = true;
  /// If they correspond: the input points of the domain on no wall that lie in another face of the chains.
  std::set<Index> strayed;
  /// If they correspond: per triangle, the face of the domain.
  std::vector<InputFaces::Face> of_triangle;
};

/// The triangles that contain the seed of a hole, each with the number of the hole. A seed that is at most two units
/// off a wall does not count in a triangle with a corner on the chain of this wall: the chain may pass on its other
/// side.
[[nodiscard]] std::set<std::pair<Index, Index>> triangles_in_holes(const ExactMesh& mesh, const Chains& chains,
                                                                   const Pslg& pslg);

/// Is (V2) satisfied?
[[nodiscard]] bool are_chains_of_the_domain(const ExactMesh& mesh, const Chains& chains, const Pslg& pslg,
                                            const InputFaces& faces);

}  // namespace pardel::fuzz
