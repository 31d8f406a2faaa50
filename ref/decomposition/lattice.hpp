// The decomposition of [CC]: a uniform lattice over the domain. Its cells are so large that points in two cells that
// are not neighbours can be inserted independently (THEORY.md, Lattice).
#pragma once

#include "../definitions.hpp"
#include "cell.hpp"

namespace pardel::ref {

/// Cell (i, j) is [x + i side, x + (i + 1) side) x [y + j side, y + (j + 1) side), where (x, y) is the corner.
struct Lattice {
  ExactPoint corner;
  Number side;
};

/// The lattice of [CC] for this mesh. Its corner is the lower left corner of the mesh's bounding box. Its side is 4 r̄,
/// rounded up to a double, where r̄ is the largest circumradius of the mesh: this is the least side for which points in
/// two cells that are not neighbours have distance at least 4 r̄ (THEORY.md, Lattice (a)). Precondition: the mesh has
/// triangles.
[[nodiscard]] Lattice lattice_over(const PlainMesh& mesh);

/// The lattice of [CC] over the points of a domain, before a mesh exists. Its side is 4 r̄, rounded up to a double,
/// where r̄² is `squared_bound`. Precondition: the domain has points.
[[nodiscard]] Lattice lattice_over(const std::vector<Point>& points, const Number& squared_bound);

/// May the lattice be used for this mesh? That is, is its side at least 4 r̄? Then tasks in cells that are not
/// neighbours touch no common triangle (THEORY.md, Lattice (b)).
[[nodiscard]] bool allows(const Lattice& lattice, const PlainMesh& mesh);

/// The lattice for the next sweep: this one if it may be used, else a new one.
[[nodiscard]] Lattice cells_after(const Lattice& lattice, const PlainMesh& mesh);

[[nodiscard]] Cell cell_of(const Lattice& lattice, const ExactPoint& p);

[[nodiscard]] constexpr int colours(const Lattice& /*lattice*/) { return 4; }
/// i mod 2 + 2 (j mod 2). Two cells of one colour share neither a side nor a corner.
[[nodiscard]] int colour_of(const Lattice& lattice, const Cell& cell);

}  // namespace pardel::ref
