#include "grow_tree.hpp"

#include <utility>

#include "../threads/parallel_arrays.hpp"
#include "../threads/parallel_for.hpp"

namespace pardel::engine {
namespace {

constexpr std::size_t longest_leaf = 20;     // longer lists are divided
constexpr std::size_t fewest_in_grid = 256;  // fewer triangles are divided by lines
// Per triangle of the mesh. When the lists are longer together, no more are divided. Typical lists have 4 per triangle.
constexpr std::size_t most_listed = 16;

}  // namespace

void TreeGrower::set(Place place, SearchTree::Tag tag, std::size_t number) {
  if (number > SearchTree::number_mask)
    throw Error{ErrorKind::resources, "the mesh has too many triangles for the location of points"};
  const SearchTree::Ref ref = SearchTree::ref_to(tag, number);
  switch (place.of) {
    case Place::Of::root:
      tree_.root_ = ref;
      break;
    case Place::Of::cell:
      tree_.cells_[place.number] = ref;
      break;
    case Place::Of::split:
      tree_.splits_[place.number].parts[place.side] = ref;
  }
}

void TreeGrower::set_list(std::span<const Index> triangles, Place place) {
  if (triangles.empty()) return;  // the place says so already
  set(place, SearchTree::list, tree_.listed_.size());
  tree_.listed_.append(triangles);
  tree_.listed_[tree_.listed_.size() - 1] |= SearchTree::last_of_list;
}

/// Puts a list at its place. If it is too long, the next round does so.
void TreeGrower::hang(std::span<const Index> triangles, Place place) {
  if (triangles.size() > longest_leaf)
    too_long_.push_back({Array<Index>(triangles), place});
  else
    set_list(triangles, place);
}

void TreeGrower::append(const GriddedTriangles& by_grid, Place place) {
  const std::size_t first = tree_.cells_.size();
  set(place, SearchTree::grid, tree_.grids_.size());
  tree_.grids_.push_back(by_grid.grid);
  tree_.grids_.back().first_cell = first;
  tree_.cells_.resize(first + by_grid.grid.cells(), SearchTree::ref_to(SearchTree::nothing, 0));
  SparseAsk ask(threads_.stop);
  for (std::size_t cell = 0; cell < by_grid.grid.cells(); ++cell) {
    ask();
    hang(by_grid.in_cell(cell), {Place::Of::cell, first + cell});
  }
}

void TreeGrower::append(const DividedTriangles& by_split, Place place) {
  const std::size_t number = tree_.splits_.size();
  set(place, SearchTree::split, number);
  tree_.splits_.push_back({.split = by_split.split});
  for (unsigned side = 0; side < 3; ++side) hang(by_split.lists[side], {Place::Of::split, number, side});
}

std::vector<TreeGrower::Divided> TreeGrower::divide(const std::vector<LongList>& lists) const {
  std::vector<Divided> results(lists.size());
  const auto divide_one = [&](std::size_t i, const Threads& threads) {
    const std::span<const Index> list = lists[i].triangles.span();
    if (list.size() >= fewest_in_grid) results[i].by_grid = gridded(tree_.all_, list, threads);
    if (!results[i].by_grid) results[i].by_split = divided(tree_.all_, list);
  };
  if (lists.size() == 1)
    divide_one(0, threads_);
  else
    parallel_for(threads_, lists.size(), [&](std::size_t i, int) { divide_one(i, {1, threads_.stop}); });
  return results;
}

/// Those that are not flat. Sets the bounds of the tree, too.
Array<Index> TreeGrower::triangles_that_contain_points() {
  const LocatedTriangles& all = tree_.all_;
  const Array<Index> found = indices_where(threads_, all.triangles.size(), [&](std::size_t t) {
    const auto c = all.corners(static_cast<Index>(t));
    return orient2d(c[0], c[1], c[2]) > 0;
  });
  SparseAsk ask(threads_.stop);
  for (const Index t : found) {
    ask();
    tree_.bounds_.cover(all.box(t));
  }
  return found;
}

void TreeGrower::grow() {
  const Array<Index> triangles = triangles_that_contain_points();
  hang(triangles.span(), {});
  while (!too_long_.empty()) {
    std::size_t listed = tree_.listed_.size();
    for (const LongList& each : too_long_) listed += each.triangles.size();
    const std::vector<LongList> lists = std::exchange(too_long_, {});
    const bool has_room = listed <= most_listed * triangles.size();
    const std::vector<Divided> results = has_room ? divide(lists) : std::vector<Divided>(lists.size());
    for (std::size_t i = 0; i < lists.size(); ++i) {
      threads_.ask();
      if (results[i].by_grid)
        append(*results[i].by_grid, lists[i].place);
      else if (results[i].by_split)
        append(*results[i].by_split, lists[i].place);
      else
        set_list(lists[i].triangles.span(), lists[i].place);
    }
  }
  tree_.listed_.shrink_to_fit();
}

}  // namespace pardel::engine
