#include "point_tiles.hpp"

#include <utility>

namespace pardel::engine {

Quadtree quadtree_of(const Box& bounds, std::span<const Point> sample, std::size_t points, double most) {
  const double each = static_cast<double>(points) / static_cast<double>(sample.size());
  for (Quadtree tree(bounds);;) {
    std::vector<double> in_leaf(tree.cells(), 0);
    for (const Point p : sample) in_leaf[tree.cell_of(p)] += each;
    Quadtree finer = tree.divided(in_leaf, most);
    if (finer.cells() == tree.cells()) return tree;
    tree = std::move(finer);
  }
}

}  // namespace pardel::engine
