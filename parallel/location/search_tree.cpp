#include "search_tree.hpp"

#include "grow_tree.hpp"

namespace pardel::engine {

SearchTree::SearchTree(const LocatedTriangles& all, const Threads& threads) : all_(all) {
  TreeGrower(*this, threads).grow();
}

Index SearchTree::first_around(Point p) const {
  p = {snapped(p.x), snapped(p.y)};
  if (!(p.x >= bounds_.min_x && p.x <= bounds_.max_x && p.y >= bounds_.min_y && p.y <= bounds_.max_y)) return no_index;
  Ref at = root_;
  for (;;) {
    const std::size_t number = at & number_mask;
    switch (at >> tag_shift) {
      case grid:
        at = cells_[grids_[number].first_cell + grids_[number].cell_of(p)];
        break;
      case split:
        at = splits_[number].parts[splits_[number].split.side_of(p)];
        break;
      case list:
        for (std::size_t i = number;; ++i) {
          const Index t = listed_[i] & ~last_of_list;
          if (all_.contains(t, p)) return t;
          if ((listed_[i] & last_of_list) != 0) return no_index;
        }
      default:
        return no_index;
    }
  }
}

}  // namespace pardel::engine
