// The decomposition of [CC]: a uniform lattice over the domain whose cells are so large that points in two cells that
// are no neighbours can be inserted independently of each other.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "definitions.hpp"

namespace pardel::ref {

/// The cell [x + i side, x + (i + 1) side) x [y + j side, y + (j + 1) side), (x, y) being the lattice's corner.
struct Cell {
  std::int64_t i = 0;
  std::int64_t j = 0;
  friend auto operator<=>(const Cell&, const Cell&) = default;
};

/// (i mod 2, j mod 2). Two cells of one colour are never neighbours, by a side or by a corner.
using Colour = std::array<int, 2>;
inline constexpr std::array<Colour, 4> all_colours = {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};

struct Lattice {
  ExactPoint corner;
  Number side;
};

/// The lattice of [CC] for this mesh: its corner is that of the mesh's bounding box, and its cells are as small as they
/// may be: points in two cells that are no neighbours are at least 4 r̄ apart, when the side is 4 r̄, rounded up to
/// a double. r̄ is the largest circumradius of the mesh, measured. The mesh must have triangles.
[[nodiscard]] Lattice lattice_over(const PlainMesh& mesh);

/// May the lattice be used for a mesh with this largest circumradius: is its side still 4 r̄ or more?
[[nodiscard]] bool allows(const Lattice& lattice, const Number& squared_circumradius);

[[nodiscard]] Cell cell_of(const Lattice& lattice, const ExactPoint& p);
[[nodiscard]] Colour colour_of(const Cell& cell);

}  // namespace pardel::ref
