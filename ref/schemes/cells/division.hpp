// A division of the plane into cells, as one sweep uses it: which cell a point belongs to, and in which phase and by
// which worker a cell is refined. The schemes that refine cells differ in their divisions only.
#pragma once

#include <functional>
#include <vector>

#include "../workers/territory.hpp"

namespace pardel::schemes::cells {

/// Which worker refines a cell. The literature leaves it open.
enum class Assignment {
  blocks,       ///< neighbouring cells by the expected work (Territory): few messages
  round_robin,  ///< the cells of one colour in turn: equal numbers of cells in each phase
};

/// Cells are numbered from 0.
struct Division {
  std::vector<int> colour;  ///< of each cell: the phase in which it is refined
  std::vector<int> worker;  ///< of each cell
  int colours = 1;
  std::function<Index(Point)> cell_of;
  /// The other cells whose closed squares meet that of a cell.
  std::function<std::vector<Index>(Index)> touching;
  /// Does the point lie in the box of the cell, the cell with a margin? Its worker holds the triangles of the box.
  std::function<bool(Index, Point)> in_box;
  /// Is the circumdisk of a triangle so small that the next phase may begin with it?
  std::function<bool(Point centre, double radius)> allows;
  /// A task inserts a point only if the box of its cell contains it and its cavity (T-region). Otherwise a task inserts
  /// the points of its cell.
  bool owns_box = false;
  /// Is a triangle refined in this division? Otherwise it waits for a later one.
  std::function<bool(const LinkedMesh&, Index)> is_due = [](const LinkedMesh&, Index) { return true; };
};

/// Gives each cell a worker. `place`: a point that stands for the cell.
void assign(Division& division, Assignment assignment, const Territory& territory,
            const std::function<Point(Index)>& place);

}  // namespace pardel::schemes::cells
