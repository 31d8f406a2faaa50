// The chains of a mesh by definition (properties/THEORY.md, (V2)): a chain of a wall is a path of edges from one end to
// the other that passes no input point, of which each step goes forward, and of which each vertex is at most two units
// of the wall off. All paths are listed.
//
// Preconditions in this file: the mesh is conformal, and its vertices begin with the input points.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "exact_mesh.hpp"
#include "input_faces.hpp"

namespace pardel::fuzz {

struct Chain {
  const Wall* wall;
  std::vector<Index> path;  ///< the vertices, from end a of the wall to end b

  [[nodiscard]] bool ends_at(Index v) const { return path.front() == v || path.back() == v; }
  [[nodiscard]] bool passes(Index v) const;
  /// The vertex next to an end.
  [[nodiscard]] Index next_to(Index end) const { return path.front() == end ? path[1] : path[path.size() - 2]; }
};

/// One chain for each wall that has the domain on a side.
using Chains = std::vector<Chain>;

/// The possible chains of each wall that has the domain on a side.
struct PossibleChains {
  std::vector<Chains> of_walls;
  std::set<Index> broken;  ///< the segments that have none
  bool are_whole = true;   ///< no segment and no side of the hull is broken
  bool are_listed = true;  ///< false if there are too many

  /// Has a wall several chains?
  [[nodiscard]] bool leave_a_choice() const;
};
[[nodiscard]] PossibleChains possible_chains(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces);

/// The chains that the mesh means: the only one of a wall, or the only one of listed edges that have triangles where
/// the wall has the domain. Nothing if a wall leaves a choice. Precondition: PossibleChains::are_whole.
[[nodiscard]] std::optional<Chains> meant_chains(const ExactMesh& mesh, const PossibleChains& possible);

/// Does fits(chains) hold for some choice of chains? Nothing if there are too many choices to try.
[[nodiscard]] std::optional<bool> some_choice_fits(const PossibleChains& possible,
                                                   const std::function<bool(const Chains&)>& fits);

/// Which wall an edge belongs to, and in the interior of which wall a vertex lies. Precondition: chains do not meet
/// elsewhere than in input points.
struct WallsOfMesh {
  explicit WallsOfMesh(const ExactMesh& mesh, const Chains& chains);

  std::map<ref::Edge, const Wall*> of_edge;
  std::vector<const Wall*> of_vertex;  ///< per point; or null
};

}  // namespace pardel::fuzz
