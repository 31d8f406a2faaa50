// The Delaunay property of edges between two pieces.
#pragma once

#include "border.hpp"

namespace pardel::checker {

/// Checks that edges between two pieces are locally Delaunay, as check_delaunay() does within a piece. The piece whose
/// triangle has the smaller number checks an edge. Returns how many triangles had such tests that floating-point
/// filters left open, though the scan had left no test open for them.
std::uint64_t check_border_delaunay(const Piece& piece, std::span<const BorderSide> border, const Chains& chains,
                                    const Scan& scan, Findings& found);

}  // namespace pardel::checker
