// The boxes of tasks on random lattices and quadtrees: the properties that allow the tasks of one colour to run
// concurrently.
#include "../../../parallel/decomposition/lattice.hpp"
#include "../../../parallel/decomposition/quadtree.hpp"
#include "../../../properties/theorems/framework/property.hpp"

namespace pardel::engine {
namespace {

constexpr const char* lattices = "up to 12 by 12 cells, square or not, over rectangles of all shapes, some far away";

Box some_box() {
  const auto extent = [] { return std::ldexp(*rc::gen::inRange(1, 100), *rc::gen::inRange(-60, 60)); };
  const double width = extent(),
               height = width * std::ldexp(1 + 0.01 * *rc::gen::inRange(0, 100), *rc::gen::inRange(-4, 4));
  const double x = width * *rc::gen::inRange(-100000, 100000), y = height * *rc::gen::inRange(-100000, 100000);
  return {x, y, x + width, y + height};
}
Lattice some_lattice_over(const Box& bounds) {
  const auto some_number = [] { return *rc::gen::inRange<Index>(1, 13); };
  const Index along = some_number();
  return *rc::gen::arbitrary<bool>() ? Lattice::over(bounds, along) : Lattice(bounds, along, some_number());
}

constexpr const char* trees = "one to six divisions of random leaves, over rectangles of all shapes, some far away";

Quadtree some_tree() {
  const double side = std::ldexp(*rc::gen::inRange(1, 100), *rc::gen::inRange(-60, 60));
  const double x = side * *rc::gen::inRange(-1000, 1000), y = side * *rc::gen::inRange(-1000, 1000);
  Quadtree tree(Box{x, y, x + side, y + 0.25 * side * *rc::gen::inRange(1, 5)});
  for (int divisions = *rc::gen::inRange(1, 7); divisions > 0; --divisions) {
    std::vector<double> work;
    for (Index leaf = 0; leaf < tree.cells(); ++leaf) work.push_back(*rc::gen::inRange(0, 4) == 0 ? 2 : 0);
    tree = tree.divided(work, 1);
  }
  return tree;
}

bool disjoint(const Box& a, const Box& b) {
  return a.max_x <= b.min_x || b.max_x <= a.min_x || a.max_y <= b.min_y || b.max_y <= a.min_y;
}

PARDEL_PROPERTY(
    Boxes, of_one_colour_are_disjoint,
    {.statement = "the boxes of two cells of one colour are disjoint: cells of one colour are not adjacent, "
                  "and a box reaches half a cell beyond its own",
     .source = "properties/THEORY.md, T-region",
     .families = lattices}) {
  const Lattice lattice = some_lattice_over(some_box());
  for (Index a = 0; a < lattice.cells(); ++a)
    for (Index b = 0; b < a; ++b)
      RC_ASSERT(lattice.colour_of(a) != lattice.colour_of(b) || disjoint(lattice.box_of(a), lattice.box_of(b)));
}

/// The tolerance is a millionth of a side, because the border of a box far from the origin is rounded.
PARDEL_PROPERTY(Boxes, reach_half_a_side_beyond_their_cells,
                {.statement = "a point that is less than half a cell's width and half its height away from a point of "
                              "a cell lies in its box",
                 .source = "properties/THEORY.md, T-region",
                 .families = lattices}) {
  const Box bounds = some_box();
  const Lattice lattice = some_lattice_over(bounds);
  const auto somewhere = [](double low, double high) {
    return low + (high - low) * 0.001 * *rc::gen::inRange(0, 1001);
  };
  const Point p{somewhere(bounds.min_x, bounds.max_x), somewhere(bounds.min_y, bounds.max_y)};
  const auto reach = [](double side) { return 0.499999 * side * *rc::gen::inRange(-1, 2); };
  const Point q{p.x + reach(lattice.width()), p.y + reach(lattice.height())};
  RC_ASSERT(lattice.box_of(lattice.cell_of(p)).contains_half_open(p));
  RC_ASSERT(lattice.box_of(lattice.cell_of(p)).contains_half_open(q));
}

PARDEL_PROPERTY(Quadtree, boxes_of_one_colour_are_disjoint,
                {.statement = "the boxes of two leaves of one colour are disjoint: such leaves do not touch, and a box "
                              "reaches a quarter of a side beyond its leaf",
                 .source = "properties/THEORY.md, Quadtree",
                 .families = trees}) {
  const engine::Quadtree tree = some_tree();
  for (Index a = 0; a < tree.cells(); ++a)
    for (Index b = 0; b < a; ++b)
      RC_ASSERT(tree.colour_of(a) != tree.colour_of(b) || disjoint(tree.box_of(a), tree.box_of(b)));
}

}  // namespace
}  // namespace pardel::engine
