#include "../../../parallel/decomposition/quadtree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "../../../properties/domains/generators/random.hpp"

namespace pardel::engine {
namespace {

constexpr Box tree_bounds{-1, 2, 3, 5};
constexpr double tree_side = 4;

/// Trees that were divided at random places, and trees that were divided around one point.
std::vector<Quadtree> trees() {
  std::vector<Quadtree> all{Quadtree(tree_bounds)};
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    generators::Random random(seed);
    Quadtree tree(tree_bounds);
    const Point centre{random.uniform(-1, 3), random.uniform(2, 5)};
    for (int round = 0; round < 9; ++round) {
      std::vector<double> quantity(tree.cells(), 0);
      if (seed % 2 == 0)
        quantity[tree.cell_of(centre)] = 1;
      else
        for (double& q : quantity) q = random.chance(4) ? 1 : 0;
      if (tree.cells() < 3000) tree = tree.divided(quantity, 0.5);
    }
    all.push_back(tree);
  }
  return all;
}

Box square_of(const Quadtree& tree, Index cell) {
  const Point c = tree.centre_of(cell);
  const double half = tree.side_of(cell) / 2;
  return {c.x - half, c.y - half, c.x + half, c.y + half};
}

bool overlap(const Box& a, const Box& b) {
  return a.min_x < b.max_x && b.min_x < a.max_x && a.min_y < b.max_y && b.min_y < a.max_y;
}

TEST(Quadtree, covers_its_square_with_leaves_that_do_not_overlap) {
  for (const Quadtree& tree : trees()) {
    double area = 0;
    for (Index i = 0; i < tree.cells(); ++i) {
      area += tree.side_of(i) * tree.side_of(i);
      for (Index j = 0; j < i; ++j) EXPECT_FALSE(overlap(square_of(tree, i), square_of(tree, j)));
    }
    EXPECT_EQ(area, tree_side * tree_side);
  }
}

TEST(Quadtree, gives_every_point_of_the_plane_to_a_leaf_whose_box_contains_it) {
  generators::Random random(1);
  for (const Quadtree& tree : trees())
    for (int i = 0; i < 500; ++i) {
      const Point p{random.uniform(-2, 4), random.uniform(1, 7)};
      const Index cell = tree.cell_of(p);
      EXPECT_TRUE(tree.box_of(cell).contains_half_open(p));
      if (p.x >= -1 && p.x < 3 && p.y >= 2 && p.y < 6) {
        EXPECT_TRUE(square_of(tree, cell).contains_half_open(p));
      }
    }
}

TEST(Quadtree, gives_the_centre_of_a_leaf_to_this_leaf) {
  for (const Quadtree& tree : trees())
    for (Index i = 0; i < tree.cells(); ++i) EXPECT_EQ(tree.cell_of(tree.centre_of(i)), i);
}

TEST(Quadtree, is_balanced_in_sides_and_corners) {
  for (const Quadtree& tree : trees())
    for (Index i = 0; i < tree.cells(); ++i)
      for (Index j = 0; j < tree.cells(); ++j)
        if (square_of(tree, i).intersects_closed(square_of(tree, j))) {
          EXPECT_LE(tree.side_of(i), 2 * tree.side_of(j));
        }
}

TEST(Quadtree, knows_the_leaves_that_touch_a_leaf) {
  for (const Quadtree& tree : trees())
    for (Index i = 0; i < tree.cells(); ++i) {
      std::vector<Index> touching;
      for (Index j = 0; j < tree.cells(); ++j)
        if (j != i && square_of(tree, i).intersects_closed(square_of(tree, j))) touching.push_back(j);
      EXPECT_EQ(std::vector<Index>(tree.touching(i).begin(), tree.touching(i).end()), touching);
    }
}

TEST(Quadtree, has_disjoint_boxes_of_one_colour) {
  std::size_t pairs = 0;
  for (const Quadtree& tree : trees())
    for (Index i = 0; i < tree.cells(); ++i)
      for (Index j = 0; j < i; ++j) {
        if (tree.colour_of(i) != tree.colour_of(j)) continue;
        ++pairs;
        EXPECT_FALSE(overlap(tree.box_of(i), tree.box_of(j))) << i << ' ' << j;
      }
  EXPECT_GT(pairs, 1000U);
}

TEST(Quadtree, has_few_colours) {
  for (const Quadtree& tree : trees()) {
    EXPECT_LE(tree.colours(), 9U);
    std::set<unsigned> colours;
    for (Index i = 0; i < tree.cells(); ++i) colours.insert(tree.colour_of(i));
    EXPECT_EQ(colours.size(), tree.colours()) << "each colour has a leaf";
    EXPECT_EQ(*colours.begin(), 0U);
    EXPECT_EQ(*colours.rbegin(), tree.colours() - 1);
  }
}

TEST(Quadtree, sums_a_uniform_quantity_to_the_area_of_the_box) {
  for (const Quadtree& tree : trees()) {
    std::vector<double> area;
    for (Index i = 0; i < tree.cells(); ++i) area.push_back(tree.side_of(i) * tree.side_of(i));
    for (Index i = 0; i < tree.cells(); ++i) {
      const Box box = tree.box_of(i);
      if (std::isfinite(box.extent())) {
        EXPECT_NEAR(tree.sum_over_box(i, area), tree.box_area(i), 1e-9 * area[i]);
      }
    }
  }
}

TEST(Quadtree, divides_the_leaves_with_too_much_work_and_keeps_the_others_where_it_can) {
  const Quadtree four = Quadtree(tree_bounds).divided(std::vector<double>{2}, 1);
  EXPECT_EQ(four.cells(), 4U);
  EXPECT_EQ(four.divided(std::vector<double>{1, 1, 1, 1}, 1).cells(), 4U);
  EXPECT_EQ(four.divided(std::vector<double>{1, 2, 1, 1}, 1).cells(), 7U);
}

TEST(Quadtree, ends_at_the_deepest_level) {
  Quadtree tree(tree_bounds);
  for (unsigned i = 0; i < Square::deepest + 5; ++i) {
    std::vector<double> quantity(tree.cells(), 0);
    quantity[tree.cell_of({0.3, 2.7})] = 1;
    tree = tree.divided(quantity, 0.5);
  }
  EXPECT_EQ(tree.side_of(tree.cell_of({0.3, 2.7})), std::ldexp(tree_side, -30));
}

TEST(Quadtree, numbers_the_squares_of_the_deepest_level_along_a_curve) {
  for (std::uint32_t column = 0; column < 4; ++column)
    for (std::uint32_t row = 0; row < 4; ++row) {
      const std::uint64_t within = (column & 1) | (row & 1) << 1 | (column & 2) << 1 | (row & 2) << 2;
      EXPECT_EQ(Square::first_place(Square::deepest, column, row), within);
    }
  const std::uint32_t last = (1U << Square::deepest) - 1;
  EXPECT_EQ(Square::first_place(Square::deepest, last, last), (std::uint64_t{1} << 2 * Square::deepest) - 1);
}

TEST(Quadtree, has_a_leaf_for_every_point_even_if_a_coordinate_is_not_finite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = INFINITY;
  for (const Quadtree& tree : trees())
    for (const double x : {nan, inf, -inf, 0.0})
      for (const double y : {nan, inf, -inf, 1e300}) EXPECT_LT(tree.cell_of({x, y}), tree.cells());
}

}  // namespace
}  // namespace pardel::engine
