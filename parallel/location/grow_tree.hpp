// Makes a SearchTree, branch by branch.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "gridded.hpp"
#include "search_tree.hpp"

namespace pardel::engine {

/// Works in rounds. A round divides all lists that are too long, on all threads, and appends the results to the tree.
class TreeGrower {
 public:
  TreeGrower(SearchTree& tree, const Threads& threads) : tree_(tree), threads_(threads) {}
  void grow();

 private:
  /// The place of a reference in the tree: the root, a cell, or a part of a split.
  struct Place {
    enum class Of : std::uint8_t { root, cell, split } of = Of::root;
    std::size_t number = 0;
    unsigned side = 0;
  };
  struct LongList {
    Array<Index> triangles;
    Place place;
  };
  /// What a list has become: a grid, a split, or still the list.
  struct Divided {
    std::optional<GriddedTriangles> by_grid{};
    std::optional<DividedTriangles> by_split{};
  };

  [[nodiscard]] Array<Index> triangles_that_contain_points();
  [[nodiscard]] std::vector<Divided> divide(const std::vector<LongList>& lists) const;
  void append(const GriddedTriangles& by_grid, Place place);
  void append(const DividedTriangles& by_split, Place place);
  void hang(std::span<const Index> triangles, Place place);
  void set_list(std::span<const Index> triangles, Place place);
  void set(Place place, SearchTree::Tag tag, std::size_t number);

  SearchTree& tree_;
  const Threads& threads_;
  std::vector<LongList> too_long_{};
};

}  // namespace pardel::engine
