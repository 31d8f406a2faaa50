// Points at the borders of the pieces of a file that has no numbers for them.
#pragma once

#include <cstdint>
#include <vector>

#include "../join_pieces.hpp"

namespace pardel::files {

/// Numbers the points of all pieces, those of the first piece first. Points of different pieces with equal coordinates,
/// markers and attributes have one number: the pieces share them. Where one piece has several points at a place, all
/// points there have numbers of their own, because no one knows which of them belong together. Returns for each number
/// the place of its first point in the list of all points of all pieces. Time O(n log n).
std::vector<std::uint64_t> number_equal_points(std::vector<NumberedMesh>& pieces);

}  // namespace pardel::files
