// Each cell has one owner. A rank watches the boxes of its cells, and owns about its share of the work.
#include "../../../parallel/distribution/ownership.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace pardel::engine {
namespace {

const Tiles lattice(Lattice({0, 0, 8, 8}, 8, 8));

Tiles some_quadtree() {
  Quadtree tree({0, 0, 1, 1});
  for (int i = 0; i < 4; ++i) {
    std::vector<double> per_leaf(tree.cells(), 0);
    per_leaf[tree.cell_of({0.1, 0.1})] = 10;
    per_leaf[tree.cell_of({0.8, 0.3})] = 10;
    tree = tree.divided(per_leaf, 1);
  }
  return Tiles(tree);
}

TEST(Ownership, divides_the_work) {
  std::vector<double> work(lattice.cells());
  std::iota(work.begin(), work.end(), 1.0);
  const double all = std::accumulate(work.begin(), work.end(), 0.0);
  const Ownership ownership(lattice, work, 5);
  std::vector<double> of_rank(5, 0);
  for (Index cell = 0; cell < lattice.cells(); ++cell) of_rank[ownership.owner(cell)] += work[cell];
  for (const double part : of_rank) EXPECT_NEAR(part, all / 5, 64);
}

TEST(Ownership, gives_a_rank_cells_that_follow_each_other_on_the_curve) {
  const Ownership ownership(lattice, std::vector<double>(lattice.cells(), 1), 7);
  int last = 0;
  for (const Index cell : ownership.curve()) {
    EXPECT_GE(ownership.owner(cell), last);
    last = ownership.owner(cell);
  }
  EXPECT_EQ(last, 6);
}

TEST(Ownership, of_more_ranks_than_cells_leaves_some_without_cells) {
  const Tiles one(Lattice({0, 0, 1, 1}, 1, 1));
  const Ownership ownership(one, std::vector<double>{1}, 4);
  EXPECT_LT(ownership.owner(0), 4);
  EXPECT_EQ(ownership.watchers_of_box(0), std::vector<int>{ownership.owner(0)});
}

TEST(Ownership, lets_a_rank_watch_the_boxes_of_its_cells) {
  for (const Tiles& tiles : {lattice, some_quadtree()}) {
    const Ownership ownership(tiles, std::vector<double>(tiles.cells(), 1), 4);
    for (Index cell = 0; cell < tiles.cells(); ++cell) {
      const Box box = tiles.box_of(cell);
      const Point low{std::max(box.min_x, 0.0), std::max(box.min_y, 0.0)};
      EXPECT_TRUE(ownership.watches(ownership.owner(cell), low));
      EXPECT_TRUE(ownership.watches(ownership.owner(cell), tiles.centre_of(cell)));
      const std::vector<int> watchers = ownership.watchers_of_box(cell);
      for (int rank = 0; rank < 4; ++rank)
        EXPECT_TRUE(!ownership.watches(rank, low) || std::ranges::find(watchers, rank) != watchers.end());
    }
  }
}

TEST(Ownership, lets_no_rank_watch_what_no_task_of_it_can_reach) {
  const Ownership ownership(lattice, std::vector<double>(lattice.cells(), 1), 2);
  for (int rank = 0; rank < 2; ++rank)
    for (double x = 0.125; x < 8; x += 0.25)
      for (double y = 0.125; y < 8; y += 0.25) {
        bool is_in_a_box = false;
        for (Index cell = 0; cell < lattice.cells(); ++cell)
          is_in_a_box =
              is_in_a_box || (ownership.owner(cell) == rank && lattice.box_of(cell).contains_half_open({x, y}));
        EXPECT_EQ(ownership.watches(rank, {x, y}), is_in_a_box);
      }
}

TEST(Ownership, lets_a_rank_watch_the_same_points_of_a_box_if_the_box_is_known) {
  for (const Tiles& tiles : {lattice, some_quadtree()}) {
    const Ownership ownership(tiles, std::vector<double>(tiles.cells(), 1), 4);
    for (Index cell = 0; cell < tiles.cells(); ++cell)
      for (double x = 0; x < 8; x += 0.25)
        for (double y = 0; y < 8; y += 0.25)
          for (int rank = 0; rank < 4; ++rank) {
            const Point p = tiles.lattice() != nullptr ? Point{x, y} : Point{x / 8, y / 8};
            if (rank == ownership.owner(cell) || !tiles.box_of(cell).contains_half_open(p)) continue;
            EXPECT_EQ(ownership.watches(rank, p, cell), ownership.watches(rank, p));
          }
  }
}

}  // namespace
}  // namespace pardel::engine
