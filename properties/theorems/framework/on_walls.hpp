// Insertions that lie on walls, as split points do.
#pragma once

#include "scenes.hpp"

namespace pardel::properties {

/// The wall or border edge of the mesh that p splits. Neither, if p lies on no such edge.
struct SplitEdge {
  bool is_wall = false;
  bool is_border = false;
};
[[nodiscard]] SplitEdge split_edge_at(const ref::PlainMesh& mesh, const ref::ExactPoint& p);

/// The least shares of cases, in percent, for classify_on_walls().
struct ShareOnWalls {
  double inside = 8;   ///< an insertion lies on a wall with triangles on both sides
  double border = 10;  ///< an insertion lies on a wall of the border
  double two = 0;      ///< two insertions lie on walls; 0 if there is only one insertion
};

/// Counts the current case by the walls on which its insertions lie.
void classify_on_walls(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& insertions,
                       const ShareOnWalls& least);

}  // namespace pardel::properties
