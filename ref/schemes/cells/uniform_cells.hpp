// Square cells of one size.
#pragma once

#include "../mesh/extent.hpp"
#include "division.hpp"

namespace pardel::schemes::cells {

/// Square cells over the extent, of four colours: two cells of one colour share neither a side nor a corner. Cell (i,
/// j) has the number i + j columns and the colour i mod 2 + 2 (j mod 2). Its box has a margin of half a side, so the
/// boxes of one colour are disjoint; beyond the extent it has no end. A row has at most 256 cells: then the side is
/// longer. There is one cell if the side is longer than the extent. All circumdisks are allowed.
[[nodiscard]] Division uniform_cells(const Extent& extent, double side, Assignment assignment,
                                     const Territory& territory);

}  // namespace pardel::schemes::cells
