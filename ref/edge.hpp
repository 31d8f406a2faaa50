// Triangles and edges of the reference, as indices of vertices.
#pragma once

#include <array>

#include "../core/pslg.hpp"

namespace pardel::ref {

/// The three vertices of a triangle, counter-clockwise.
using Corners = std::array<Index, 3>;
/// Two vertices, the smaller index first.
using Edge = std::array<Index, 2>;
[[nodiscard]] Edge edge(Index a, Index b);
/// The edge opposite to corner i, 0 to 2.
[[nodiscard]] Edge edge_of(const Corners& t, int i);

}  // namespace pardel::ref
