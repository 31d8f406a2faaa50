// The decomposition of [CC]: a uniform lattice over the domain. Its cells are so large that points in two cells that
// are not neighbours can be inserted independently (THEORY.md, Lattice).
#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "definitions.hpp"

namespace pardel::ref {

/// The cell [x + i side, x + (i + 1) side) x [y + j side, y + (j + 1) side), where (x, y) is the corner of the lattice.
struct Cell {
  std::int64_t i = 0;
  std::int64_t j = 0;
  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// (i mod 2, j mod 2). Two cells of one colour share neither a side nor a corner.
using Colour = std::array<int, 2>;
inline constexpr std::array<Colour, 4> all_colours = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};

struct Lattice {
  ExactPoint corner;
  Number side;
};

/// The lattice of [CC] for this mesh. Its corner is the lower left corner of the mesh's bounding box. Its side is 4 r̄,
/// rounded up to a double, where r̄ is the largest circumradius of the mesh: this is the least side for which points in
/// two cells that are not neighbours have distance at least 4 r̄. Precondition: the mesh has triangles.
[[nodiscard]] Lattice lattice_over(const PlainMesh& mesh);

/// May the lattice be used for a mesh whose largest squared circumradius is r̄²? That is, is its side at least 4 r̄?
[[nodiscard]] bool allows(const Lattice& lattice, const Number& squared_circumradius);

[[nodiscard]] Cell cell_of(const Lattice& lattice, const ExactPoint& p);
[[nodiscard]] Colour colour_of(const Cell& cell);

}  // namespace pardel::ref
