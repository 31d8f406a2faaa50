// Each cell has one owner. A rank watches the boxes of its cells, and owns about its share of the work.
#include "../../../distributed/meshing/ownership.hpp"

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

TEST(WorkOfTasks, tasks_of_the_first_colour_have_all_work_of_a_lattice) {
  const Tiles tiles(Lattice({0, 0, 9, 9}, 9, 9));
  const std::vector<double> of_task = work_of_tasks(tiles, std::vector<double>(tiles.cells(), 1));
  for (Index cell = 0; cell < tiles.cells(); ++cell) {
    if (tiles.colour_of(cell) != 0) {
      EXPECT_EQ(of_task[cell], 0);
      continue;
    }
    // The boxes extend half a cell to each side. Beyond the bounds there is nothing.
    const auto extent = [](Index i) { return i == 0 || i == 8 ? 1.5 : 2; };
    EXPECT_EQ(of_task[cell], extent(cell % 9) * extent(cell / 9)) << cell;
  }
}

TEST(WorkOfTasks, no_work_is_lost) {
  for (const Tiles& tiles : {Tiles(Lattice({0, 0, 3, 2}, 5, 7)), some_quadtree()}) {
    std::vector<double> work(tiles.cells());
    std::iota(work.begin(), work.end(), 1.0);
    const std::vector<double> of_task = work_of_tasks(tiles, work);
    EXPECT_DOUBLE_EQ(std::accumulate(of_task.begin(), of_task.end(), 0.0),
                     std::accumulate(work.begin(), work.end(), 0.0));
  }
}

TEST(WorkOfTasks, the_work_of_a_leaf_goes_only_to_tasks_that_reach_it) {
  const Tiles tiles = some_quadtree();
  for (Index cell = 0; cell < tiles.cells(); ++cell) {
    std::vector<double> work(tiles.cells(), 0);
    work[cell] = 1;
    const std::vector<double> of_task = work_of_tasks(tiles, work);
    double near = of_task[cell];
    for (const Index touched : tiles.touching(cell)) near += of_task[touched];
    EXPECT_EQ(near, 1);
    // The middle of a leaf lies in no other box.
    EXPECT_GT(of_task[cell], 0);
  }
}

TEST(Ownership, divides_the_work) {
  for (const Tiles& tiles : {lattice, Tiles(Lattice({0, 0, 1, 1}, 25, 30)), some_quadtree()}) {
    std::vector<double> work(tiles.cells());
    std::iota(work.begin(), work.end(), 1.0);
    const std::vector<double> of_task = work_of_tasks(tiles, work);
    const double all = std::accumulate(of_task.begin(), of_task.end(), 0.0);
    const Ownership ownership(tiles, of_task, 5);
    std::vector<double> of_rank(5, 0);
    for (Index cell = 0; cell < tiles.cells(); ++cell) of_rank[ownership.owner(cell)] += of_task[cell];
    for (const double part : of_rank) EXPECT_NEAR(part, all / 5, std::ranges::max(of_task));
  }
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

TEST(Ownership, gives_a_task_between_those_of_the_first_colour_to_the_owner_of_one_of_them) {
  for (const auto& [columns, rows] : {std::pair<Index, Index>{8, 8}, {9, 9}, {35, 35}, {1, 6}, {6, 1}, {2, 3}}) {
    const Tiles tiles(Lattice({0, 0, 1, 1}, columns, rows));
    const Ownership ownership(tiles, std::vector<double>(tiles.cells(), 1), 3);
    std::vector<Index> visited(ownership.curve().begin(), ownership.curve().end());
    std::ranges::sort(visited);
    for (Index cell = 0; cell < tiles.cells(); ++cell) {
      EXPECT_EQ(visited[cell], cell);
      const auto is_between = [](Index i, Index count) { return i % 2 == 0 || i + 1 < count; };
      if (!is_between(cell % columns, columns) || !is_between(cell / columns, rows)) continue;
      if (tiles.colour_of(cell) == 0) continue;
      const std::vector<Index> around = tiles.touching(cell);
      EXPECT_TRUE(std::ranges::any_of(around, [&](Index near) {
        return tiles.colour_of(near) == 0 && ownership.owner(near) == ownership.owner(cell);
      })) << cell;
    }
  }
}

TEST(Ownership, gives_each_of_two_ranks_half_of_the_tasks_between_them) {
  const Lattice cells({0, 0, 1, 1}, 35, 35);
  const Ownership ownership(Tiles(cells), std::vector<double>(cells.cells(), 1), 2);
  std::vector<int> of_rank(2, 0);
  for (Index cell = 0; cell < cells.cells(); ++cell)  // those of the colour 1 are never at the ends of a row
    if (cells.colour_of(cell) == 1 && ownership.owner(cell - 1) != ownership.owner(cell + 1))
      ++of_rank[ownership.owner(cell)];
  EXPECT_GE(of_rank[0] + of_rank[1], 10);
  EXPECT_NEAR(of_rank[0], of_rank[1], 2);
}

TEST(Ownership, divides_even_few_tiles) {
  const Tiles tiles(Lattice({0, 0, 1, 1}, 2, 2));
  const Ownership ownership(tiles, work_of_tasks(tiles, std::vector<double>(tiles.cells(), 1)), 2);
  std::vector<int> of_rank(2, 0);
  for (Index cell = 0; cell < tiles.cells(); ++cell) ++of_rank[ownership.owner(cell)];
  EXPECT_GE(of_rank[0], 1);
  EXPECT_GE(of_rank[1], 1);
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
