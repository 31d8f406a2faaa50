// The sequence of lattices that a refinement uses.
#include "../../../parallel/decomposition/lattice_levels.hpp"

#include <gtest/gtest.h>

#include "../scheduling/many_tasks.hpp"

namespace pardel::engine {
namespace {

const std::vector<Box>& bounds() {
  static const std::vector<Box> all{{0, 0, 1, 1}, {-3, 5, 4, 5.5}, {0, 0, 1e-6, 1}, {654321, 4987654, 654400, 4987754}};
  return all;
}

TEST(LatticeLevels, end_at_the_finest_and_begin_with_one_cell_over_everything) {
  for (const Box& box : bounds())
    for (const Index columns : {1U, 2U, 5U, 64U})
      for (const Index rows : {1U, 3U, 4U, 17U}) {
        const std::vector<Lattice> levels = lattice_levels(box, Lattice(box, columns, rows));
        EXPECT_EQ(levels.front().cells(), 1U);
        EXPECT_EQ(levels.back().columns(), columns);
        EXPECT_EQ(levels.back().rows(), rows);
        for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_GT(levels[i].cells(), levels[i - 1].cells());
      }
}

TEST(LatticeLevels, have_as_many_cells_as_the_caller_asks_for) {
  for (const Box& box : bounds()) {
    const Lattice lattice = finest_lattice(box, 1e6, {.cells = {7, 3}});
    EXPECT_EQ(lattice.columns(), 7U);
    EXPECT_EQ(lattice.rows(), 3U);
  }
}

TEST(LatticeLevels, have_cells_for_the_work_if_the_caller_gives_only_one_of_two_numbers) {
  const Lattice by_work = finest_lattice(bounds()[0], 1e6, {});
  for (const auto& cells : {std::array<Index, 2>{7, 0}, std::array<Index, 2>{0, 7}}) {
    Options options;
    options.cells[0] = cells[0];
    options.cells[1] = cells[1];
    const Lattice lattice = finest_lattice(bounds()[0], 1e6, options);
    EXPECT_EQ(lattice.columns(), by_work.columns());
    EXPECT_EQ(lattice.rows(), by_work.rows());
  }
}

TEST(LatticeLevels, have_enough_cells_for_the_work_and_a_single_one_without_decomposition) {
  for (const double triangles : {1e3, 1e5, 1e7}) {
    const Options options;
    const Lattice lattice = finest_lattice({0, 0, 2, 1}, triangles, options);
    const double tiles = std::max(1.0, triangles / options.triangles_per_tile);
    EXPECT_LE(lattice.cells(), 2 * tiles);
    EXPECT_GE(lattice.cells(), tiles / 2);
    EXPECT_EQ(finest_lattice({0, 0, 2, 1}, triangles, {.decomposition = Decomposition::none}).cells(), 1U);
  }
}

TEST(LatticeLevels, have_at_most_about_two_cells_for_each_vertex_that_is_allowed) {
  const Options options{.triangles_per_tile = 4, .max_vertices = 500};
  const Lattice limited = finest_lattice({0, 0, 2, 1}, 1e9, options);
  EXPECT_LE(limited.cells(), 2 * 500 * 1.1);
  EXPECT_GE(limited.cells(), 500U);
  // The limit matters only if it is reached.
  const Lattice by_work = finest_lattice({0, 0, 2, 1}, 900, {.triangles_per_tile = 4});
  EXPECT_EQ(finest_lattice({0, 0, 2, 1}, 900, options).cells(), by_work.cells());
}

TEST(LatticeLevels, are_widened_no_more_than_asked) {
  for (const Box& box : bounds()) {
    const Lattice wanted(box, 40, 30);
    for (const double sides : {0.1, 1.5, 3.1, 29.9, 1e6}) {
      const double side = sides * wanted.side();
      const Lattice lattice = with_cells_at_least(side, box, wanted);
      EXPECT_GE(lattice.side(), side);  // INFINITY if there is only one cell
      EXPECT_LE(lattice.columns(), wanted.columns());
      EXPECT_LE(lattice.rows(), wanted.rows());
      if (side <= wanted.side()) {
        EXPECT_EQ(lattice.cells(), wanted.cells());
      }
    }
  }
}

/// The hypothesis of the theorem (THEORY.md, Lattice) holds when real domains are refined.
TEST(LatticeLevels, of_the_paper_have_cells_of_four_circumradii) {
  for (const samples::Case& c : samples::cases()) {
    const Tiling tiling = samples::refined(c, samples::options_for(c, Decomposition::paper), {}).counts.tiling;
    const Lattice finest({0, 0, tiling.columns * tiling.cell_width, tiling.rows * tiling.cell_height}, tiling.columns,
                         tiling.rows);
    EXPECT_GE(finest.side(), 4 * tiling.largest_radius * (1 - 1e-12)) << c.name;
    EXPECT_GT(tiling.largest_radius, 0) << c.name;
  }
}

TEST(LatticeLevels, may_have_a_single_column_or_row) {
  for (const auto& cells : {std::array<Index, 2>{1, 3}, std::array<Index, 2>{3, 1}}) {
    Options options;
    options.cells = {cells[0], cells[1]};
    const Lattice lattice = finest_lattice(bounds()[0], 1e6, options);
    EXPECT_EQ(lattice.columns(), cells[0]);
    EXPECT_EQ(lattice.rows(), cells[1]);
  }
}

}  // namespace
}  // namespace pardel::engine
