#include "../../../parallel/decomposition/lattice.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

const std::vector<Lattice>& lattices() {
  static const std::vector<Lattice> all{
      Lattice::over({0, 0, 1, 1}, 1),
      Lattice::over({0, 0, 1, 1}, 2),
      Lattice::over({0, 0, 1, 1}, 7),
      Lattice::over({-3, 5, 4, 5.5}, 9),
      Lattice::over({0, 0, 1e-6, 1}, 13),
      Lattice::over({654321, 4987654, 654400, 4987754}, 6),
      Lattice::over({0, 0, 0x1p-60, 0x1p-61}, 5),
      Lattice::over({0, 0, 3, 1}, 3),
      Lattice({0, 0, 3, 1}, 2, 5),
      Lattice({-1, 2, 1, 3}, 1, 4),
  };
  return all;
}

TEST(Lattice, gives_points_at_any_distance_to_the_nearest_column_and_row) {
  const Lattice lattice({0, 0, 4, 4}, 4, 4);
  for (const double far : {0x1p31, 0x1p32, 0x1p33, 1e300, 1 + 0x1p32}) {
    EXPECT_EQ(lattice.cell_of({far, 1.5}), 7U);
    EXPECT_EQ(lattice.cell_of({1.5, far}), 13U);
    EXPECT_EQ(lattice.cell_of({-far, 1.5}), 4U);
  }
}

TEST(Lattice, contains_every_point_of_the_plane_in_the_box_of_its_cell) {
  samples::Random random(1);
  for (const Lattice& lattice : lattices()) {
    const Box last = lattice.box_of(lattice.cells() - 1);
    const Point corner = lattice.cells() == 1 ? Point{0, 0} : Point{last.min_x, last.min_y};
    for (int round = 0; round < 2000; ++round) {
      const double reach = round % 4 == 0 ? 100 : 3;
      Point p{random.uniform(-reach, reach) * lattice.width(), random.uniform(-reach, reach) * lattice.height()};
      if (std::isfinite(corner.x)) p.x += corner.x;
      if (std::isfinite(corner.y)) p.y += corner.y;
      const Index cell = lattice.cell_of(p);
      ASSERT_LT(cell, lattice.cells());
      EXPECT_TRUE(lattice.box_of(cell).contains_half_open(p)) << p.x << ' ' << p.y;
    }
  }
}

TEST(Lattice, gives_four_different_colours_to_cells_around_a_corner) {
  const Lattice lattice = Lattice::over({0, 0, 1, 1}, 6);
  for (Index j = 0; j + 1 < lattice.rows(); ++j)
    for (Index i = 0; i + 1 < lattice.columns(); ++i) {
      const Index cell = j * lattice.columns() + i;
      unsigned seen = 0;
      for (const Index c : {cell, cell + 1, cell + lattice.columns(), cell + lattice.columns() + 1})
        seen |= 1U << lattice.colour_of(c);
      EXPECT_EQ(seen, 15U);
    }
}

TEST(Lattice, has_the_requested_number_of_cells_along_its_longer_side) {
  for (const Index along : {1U, 2U, 3U, 100U}) {
    const Lattice wide = Lattice::over({0, 0, 10, 3}, along), high = Lattice::over({0, 0, 3, 10}, along);
    EXPECT_EQ(wide.columns(), along);
    EXPECT_EQ(high.rows(), along);
    EXPECT_LE(wide.rows(), wide.columns());
  }
}

TEST(Lattice, sums_a_uniform_quantity_to_the_area_of_the_box) {
  for (const Lattice& lattice : lattices()) {
    const std::vector<double> one_per_cell(lattice.cells(), 1);
    for (Index cell = 0; cell < lattice.cells(); ++cell) {
      const auto covered = [](Index at, Index count) { return 1 + (at > 0 ? 0.5 : 0) + (at + 1 < count ? 0.5 : 0); };
      EXPECT_EQ(lattice.sum_over_box(cell, one_per_cell), covered(cell % lattice.columns(), lattice.columns()) *
                                                              covered(cell / lattice.columns(), lattice.rows()));
    }
  }
}

/// The circumcentre of a needle can lie anywhere, and its coordinates can be infinite or NaN.
TEST(Lattice, has_a_cell_for_every_point_even_if_a_coordinate_is_not_finite) {
  const Lattice lattice = Lattice::over({0, 0, 1, 1}, 4);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {-1e300, 1e300, -infinity, infinity, nan})
    for (const double y : {-1e300, 1e300, 0.5}) EXPECT_LT(lattice.cell_of({x, y}), lattice.cells());
}

TEST(Lattice, gives_the_centre_of_a_cell_to_this_cell) {
  for (const Lattice& lattice : lattices())
    for (Index cell = 0; cell < lattice.cells(); ++cell) EXPECT_EQ(lattice.cell_of(lattice.centre_of(cell)), cell);
  EXPECT_EQ(Lattice({0, 0, 6, 2}, 3, 2).centre_of(4), (Point{3, 1.5}));
}

TEST(Lattice, has_boxes_with_margins_of_half_a_cell_inside_and_without_end_at_the_border) {
  const Lattice lattice({10, 20, 16, 26}, 3, 3);
  const Box inner = lattice.box_of(4), corner = lattice.box_of(2);
  EXPECT_EQ(inner.min_x, 11);
  EXPECT_EQ(inner.min_y, 21);
  EXPECT_EQ(inner.max_x, 15);
  EXPECT_EQ(inner.max_y, 25);
  EXPECT_EQ(corner.min_x, 13);
  EXPECT_EQ(corner.max_x, INFINITY);
  EXPECT_EQ(corner.min_y, -INFINITY);
  EXPECT_EQ(corner.max_y, 23);
  EXPECT_EQ(lattice.box_area(4), 16);
  EXPECT_EQ(lattice.side(), 2);
  EXPECT_DOUBLE_EQ(lattice.radius_that_fits(), 0.99 * 0.5);
  EXPECT_EQ(Lattice::colours(), 4U);
}

}  // namespace
}  // namespace pardel::engine
