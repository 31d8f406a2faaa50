// The boxes of tasks, on random lattices: what makes it safe to run the tasks of one colour at the same time.
#include "../../parallel/tiles.hpp"
#include "../../properties/framework/property.hpp"

namespace pardel {
namespace {

constexpr const char* lattices = "up to 12 cells along the longer side of rectangles of all shapes, some far away";

Box some_box() {
  const auto extent = [] { return std::ldexp(*rc::gen::inRange(1, 100), *rc::gen::inRange(-60, 60)); };
  const double width = extent(),
               height = width * std::ldexp(1 + 0.01 * *rc::gen::inRange(0, 100), *rc::gen::inRange(-4, 4));
  const double x = width * *rc::gen::inRange(-100000, 100000), y = height * *rc::gen::inRange(-100000, 100000);
  return {x, y, x + width, y + height};
}
Index some_number_of_cells() { return *rc::gen::inRange<Index>(1, 13); }

bool disjoint(const Box& a, const Box& b) {
  return a.max_x <= b.min_x || b.max_x <= a.min_x || a.max_y <= b.min_y || b.max_y <= a.min_y;
}

PARDEL_PROPERTY(
    Boxes, of_one_colour_are_disjoint,
    {.statement = "the boxes of two cells of one colour are disjoint: cells of one colour are not adjacent, "
                  "and a box reaches half a cell beyond its own",
     .source = "properties/THEORY.md, T-region",
     .families = lattices}) {
  const Lattice lattice = Lattice::over(some_box(), some_number_of_cells());
  for (Index a = 0; a < lattice.cells(); ++a)
    for (Index b = 0; b < a; ++b)
      RC_ASSERT(lattice.colour_of(a) != lattice.colour_of(b) || disjoint(lattice.box_of(a), lattice.box_of(b)));
}

/// To a millionth of a side: far from the origin the rim of a box is rounded.
PARDEL_PROPERTY(Boxes, reach_half_a_side_beyond_their_cells,
                {.statement = "a point at a distance of less than half a side from a point of a cell lies in its box",
                 .source = "properties/THEORY.md, T-region",
                 .families = lattices}) {
  const Box bounds = some_box();
  const Lattice lattice = Lattice::over(bounds, some_number_of_cells());
  const auto somewhere = [](double low, double high) {
    return low + (high - low) * 0.001 * *rc::gen::inRange(0, 1001);
  };
  const Point p{somewhere(bounds.min_x, bounds.max_x), somewhere(bounds.min_y, bounds.max_y)};
  const double reach = 0.499999 * lattice.side();
  const Point q{p.x + reach * *rc::gen::inRange(-1, 2), p.y + reach * *rc::gen::inRange(-1, 2)};
  RC_ASSERT(lattice.box_of(lattice.cell_of(p)).contains(p));
  RC_ASSERT(lattice.box_of(lattice.cell_of(p)).contains(q));
}

}  // namespace
}  // namespace pardel
