#include "../../core/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "../fingerprint.hpp"

namespace pardel {
namespace {

/// Three columns and two rows; the south row is 1, 2, 4, the north row 5, 6, 8.
Raster sample() {
  Raster raster;
  raster.columns = 3;
  raster.rows = 2;
  raster.first = {10, 20};
  raster.step_x = 2;
  raster.step_y = 4;
  raster.values = {1, 2, 4, 5, 6, 8};
  return raster;
}

TEST(Raster, has_its_values_at_the_grid_points) {
  const Raster raster = sample();
  for (Index row = 0; row < 2; ++row)
    for (Index column = 0; column < 3; ++column)
      EXPECT_EQ(interpolate(raster, {10 + 2.0 * column, 20 + 4.0 * row}), raster.values[row * 3 + column]);
}

TEST(Raster, is_bilinear_between_the_grid_points) {
  EXPECT_EQ(interpolate(sample(), {11, 20}), 1.5);
  EXPECT_EQ(interpolate(sample(), {10, 21}), 2);
  EXPECT_EQ(interpolate(sample(), {13, 22}), 5);
}

TEST(Raster, is_constant_beyond_the_outer_grid_points) {
  EXPECT_EQ(interpolate(sample(), {9, 18}), 1);
  EXPECT_EQ(interpolate(sample(), {15, 26}), 8);
  EXPECT_EQ(interpolate(sample(), {12, 18}), 2);
}

TEST(Raster, covers_half_a_step_around_the_grid_points) {
  EXPECT_TRUE(sample().covers({9, 18}));
  EXPECT_TRUE(sample().covers({15, 26}));
  EXPECT_FALSE(sample().covers({8.999, 20}));
  EXPECT_FALSE(sample().covers({10, 26.001}));
  EXPECT_FALSE(sample().covers({NAN, 20}));
}

TEST(Raster, of_one_value_is_constant) {
  Raster raster;
  raster.columns = raster.rows = 1;
  raster.values = {3};
  EXPECT_EQ(interpolate(raster, {0.25, -0.5}), 3);
}

TEST(Raster, has_no_value_only_if_a_missing_one_has_a_weight) {
  Raster raster = sample();
  raster.values[1] = NAN;
  EXPECT_TRUE(std::isnan(interpolate(raster, {11, 20})));
  EXPECT_TRUE(std::isnan(interpolate(raster, {13, 23.9})));
  EXPECT_EQ(interpolate(raster, {10, 20}), 1);
  EXPECT_EQ(interpolate(raster, {13, 24}), 7);
  EXPECT_EQ(interpolate(raster, {14, 22}), 6);
}

TEST(Raster, is_infinite_beside_an_infinite_value) {
  Raster raster = sample();
  raster.values[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(interpolate(raster, {11, 20}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(interpolate(raster, {13, 20}), std::numeric_limits<double>::infinity()) << "from the other side";
  EXPECT_EQ(interpolate(raster, {10, 21}), 2);
  raster.values[0] = NAN;
  EXPECT_TRUE(std::isnan(interpolate(raster, {11, 20})));
}

TEST(SizeOfARaster, is_the_interpolated_value) {
  const auto size = interpolated_size(sample());
  ASSERT_TRUE(size);
  EXPECT_EQ((*size)({13, 22}), 5);
}

TEST(SizeOfARaster, must_be_greater_than_zero) {
  for (const double wrong : {0.0, -1.0, -std::numeric_limits<double>::infinity()}) {
    Raster raster = sample();
    raster.values[2] = wrong;
    const auto size = interpolated_size(raster, "field");
    ASSERT_FALSE(size);
    EXPECT_EQ(size.error().kind, ErrorKind::invalid_input);
    EXPECT_TRUE(size.error().message.starts_with("field: the size in row 2, column 3")) << size.error().message;
    EXPECT_NE(size.error().message.find("at (14, 20)"), std::string::npos) << size.error().message;
  }
}

TEST(SizeOfARaster, throws_an_error_that_names_the_point_where_there_is_none) {
  Raster raster = sample();
  raster.values[1] = NAN;
  const auto size = interpolated_size(raster, "field");
  ASSERT_TRUE(size);
  for (const Point p : {Point{11, 20}, Point{100, 20}}) {
    try {
      (void)(*size)(p);
      ADD_FAILURE() << "no exception";
    } catch (const Error& e) {
      EXPECT_EQ(e.kind, ErrorKind::invalid_input);
      EXPECT_EQ(e.message.find("field has no size at ("), 0u) << e.message;
    }
  }
}

TEST(SourcesOfARaster, are_the_lines_from_the_least_lengths_of_cells_that_change_fast) {
  Raster raster{5, 4, {0, 0}, 1, 1, std::vector<double>(20, 1.0)};
  EXPECT_TRUE(size_sources(raster, 0.1)->empty());
  raster.values[0] = 0.5;
  const auto sources = size_sources(raster, 0.1);
  ASSERT_TRUE(sources);
  ASSERT_EQ(sources->size(), 2U) << "from one corner";
  EXPECT_EQ((*sources)[0], (SizeSource{{0, 0}, {1, 0}, 0.5, 1}));
  raster.values[6] = 0.5;
  EXPECT_EQ(size_sources(raster, 0.1)->size(), 6U) << "four more from a point inside";
  EXPECT_TRUE(size_sources(raster, 1)->empty());
}

TEST(SourcesOfARaster, of_one_row_are_where_it_changes_fast) {
  const Raster row{4, 1, {0, 0}, 2, 1, {1, 1, 2, 2}};
  ASSERT_EQ(size_sources(row, 0.4)->size(), 1U);
  EXPECT_EQ((*size_sources(row, 0.4))[0], (SizeSource{{2, 0}, {4, 0}, 1, 2}));
  EXPECT_TRUE(size_sources(row, 0.6)->empty());
  EXPECT_EQ(size_sources(row, 0.5 * (1 + 0.00100098))->size(), 1U) << "changes by 0.9990000 of the limit";
  EXPECT_EQ(size_sources(row, 0.5 * (1 + 0.0010012))->size(), 0U) << "changes by 0.9989998 of the limit";
}

TEST(SourcesOfARaster, leave_out_values_that_are_not_finite) {
  const Raster raster{2, 2, {0, 0}, 1, 1, {1, NAN, std::numeric_limits<double>::infinity(), 1}};
  const auto sources = size_sources(raster, 10);
  ASSERT_TRUE(sources);
  ASSERT_EQ(sources->size(), 4U);
  for (const SizeSource& source : *sources) EXPECT_EQ(source.a, source.b);
}

/// From 0 to 1.
double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11U) * 0x1p-53; }

/// The least of (length + limit * distance from p) over a line with these lengths at its ends.
double limit_from(const SizeSource& line, double limit, Point p) {
  const auto at = [&](double t) {
    const double x = line.a.x + t * (line.b.x - line.a.x) - p.x, y = line.a.y + t * (line.b.y - line.a.y) - p.y;
    return line.at_a + t * (line.at_b - line.at_a) + limit * std::sqrt(x * x + y * y);
  };
  double low = 0, high = 1;  // the function is convex
  for (int i = 0; i < 100; ++i) {
    const double first = (2 * low + high) / 3, second = (low + 2 * high) / 3;
    (at(first) < at(second) ? high : low) = at(first) < at(second) ? second : first;
  }
  return std::min({at(0), at(low), at(1)});
}

double limit_from(const std::vector<SizeSource>& lines, double limit, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const SizeSource& line : lines) least = std::min(least, limit_from(line, limit, p));
  return least;
}

/// All lines between neighbouring grid points that have values.
std::vector<SizeSource> all_lines(const Raster& raster) {
  std::vector<SizeSource> lines;
  const auto place = [&](Index i, Index j) {
    return Point{raster.first.x + i * raster.step_x, raster.first.y + j * raster.step_y};
  };
  const auto value = [&](Index i, Index j) { return raster.values[std::size_t{j} * raster.columns + i]; };
  for (Index j = 0; j < raster.rows; ++j)
    for (Index i = 0; i < raster.columns; ++i)
      for (const auto& [k, l] : {std::pair(i + 1, j), std::pair(i, j + 1)})
        if (k < raster.columns && l < raster.rows && std::isfinite(value(i, j)) && std::isfinite(value(k, l)))
          lines.push_back({place(i, j), place(k, l), value(i, j), value(k, l)});
  return lines;
}

TEST(SourcesOfARaster, give_at_each_grid_point_the_limit_from_all_lines) {
  std::mt19937_64 random(7);
  for (const double noise : {0.0, 0.1, 1.0, 30.0})
    for (const double limit : {0.05, 0.4, 3.0})
      for (const bool holes : {false, true}) {
        Raster raster{11, 8, {3, -2}, 0.5, 0.75, {}};
        for (int k = 0; k < 88; ++k) {
          const double smooth = 1 + 0.2 * std::sin(0.7 * (k % 11)) + 0.1 * (k / 11);
          raster.values.push_back(holes && k % 13 == 5 ? NAN : smooth + noise * unit(random));
        }
        const std::vector<SizeSource> lines = all_lines(raster), sources = *size_sources(raster, limit);
        for (Index j = 0; j < raster.rows; ++j)
          for (Index i = 0; i < raster.columns; ++i) {
            const Point p{raster.first.x + i * raster.step_x, raster.first.y + j * raster.step_y};
            const double own = raster.values[std::size_t{j} * 11 + i];
            if (std::isnan(own)) continue;
            EXPECT_NEAR(std::min(own, limit_from(sources, limit, p)), std::min(own, limit_from(lines, limit, p)), 1e-9)
                << i << ", " << j << ", noise " << noise << ", limit " << limit;
          }
      }
}

TEST(SourcesOfARaster, are_few_if_the_lengths_are_noise) {
  std::mt19937_64 random(8);
  Raster raster{100, 90, {0, 0}, 1, 1, std::vector<double>(9000)};
  for (double& value : raster.values) value = 1 + 99 * unit(random);
  EXPECT_LT(size_sources(raster, 0.1)->size(), 900U) << "of 17,810 lines";
}

TEST(SourcesOfARaster, of_a_ramp_steeper_than_the_limit_are_at_its_foot) {
  Raster raster{40, 3, {0, 0}, 1, 1, {}};
  for (int k = 0; k < 120; ++k) raster.values.push_back(5 + 2.0 * (k % 40));
  const auto sources = size_sources(raster, 1);
  ASSERT_FALSE(sources->empty());
  for (const SizeSource& source : *sources) EXPECT_EQ(std::min(source.a.x, source.b.x), 0);
}

/// A raster whose lengths are 1, 9/8, ..., up to `values` of them, and of which `percent` have no length.
Raster random_raster(std::mt19937_64& random, Index columns, Index rows, std::uint64_t values, std::uint64_t percent) {
  Raster raster{columns, rows, {1, -2}, 0.5, 0.75, {}};
  for (Index i = 0; i < columns * rows; ++i)
    raster.values.push_back(random() % 100 < percent ? NAN : 1 + static_cast<double>(random() % values) / 8);
  return raster;
}

/// The number of sources and a fingerprint. After a change that is meant to change them, take over the values that the
/// test shows.
TEST(SourcesOfARaster, of_many_rasters_are_those_that_were_recorded) {
  std::mt19937_64 random(9);
  std::size_t sources = 0;
  testing::Fingerprint all;
  const auto add = [&](const Raster& raster, double limit) {
    const std::vector<SizeSource> found = *size_sources(raster, limit);
    sources += found.size();
    all.add(found);
  };
  for (Index columns = 1; columns <= 8; ++columns)
    for (Index rows = 1; rows <= 8; ++rows)
      for (int k = 0; k < 20; ++k) {
        const std::uint64_t percent = random() % 40, values = 2 + random() % 40;
        const Raster raster = random_raster(random, columns, rows, values, percent);
        for (const double limit : {0.25, 1.0, 2.5}) add(raster, limit);
      }
  // Mazes: what a point knows takes several turns to reach another one.
  for (int k = 0; k < 20; ++k) add(random_raster(random, 40, 30, 400, 38), 0.25);
  EXPECT_EQ(sources, 104'894U);
  EXPECT_EQ(all.text(), "e9dc852f95210280");
}

/// A spiral of n columns and rows that is one point wide, with a length of 1 at its inner end, and of 100 and 101 in
/// turn everywhere else. Between its turns there are no lengths.
Raster spiral(int n) {
  Raster raster{static_cast<Index>(n), static_cast<Index>(n), {0, 0}, 1, 1, {}};
  raster.values.assign(std::size_t(n) * std::size_t(n), NAN);
  int x = 0, y = 0, dx = 1, dy = 0, steps = 0;
  const auto at = [&]() -> double& { return raster.values[std::size_t(y) * std::size_t(n) + std::size_t(x)]; };
  at() = 100;
  for (int side = 0, left = n - 1; left > 0; ++side) {
    for (int k = 0; k < left; ++k) {
      x += dx;
      y += dy;
      at() = 100 + ++steps % 2;
    }
    std::swap(dx, dy);
    dx = -dx;
    if (side >= 2 && side % 2 == 0) left -= 2;
    if (side == 0) left = n - 1;
  }
  at() = 1;
  return raster;
}

/// The inner end decides about all of the spiral. Each round carries this knowledge through one turn.
TEST(SourcesOfARaster, are_looked_for_in_two_rounds) {
  const auto lines = [](int n) {
    const std::vector<SizeSource> sources = *size_sources(spiral(n), 0.25);
    return std::ranges::count_if(sources, [](const SizeSource& s) { return s.a != s.b; });
  };
  for (const int n : {3, 5, 7, 9}) EXPECT_EQ(lines(n), 1) << "the line at the inner end";
  EXPECT_EQ(lines(11), 38) << "lines that a third round would leave out";
}

/// The limit from the first point is below the third one. At the second one, it is 2^30 - 2 or 2^30 - 1 instead of
/// 2^30.
TEST(SourcesOfARaster, leave_out_a_line_only_if_another_limit_is_lower_by_more_than_rounding) {
  for (const double less : {3.0, 2.0}) {
    const Raster row{3, 1, {0, 0}, 1, 1, {0x1p30 - less, 0x1p30, 0x1p31}};
    const auto sources = size_sources(row, 1);
    ASSERT_TRUE(sources);
    ASSERT_EQ(sources->size(), less == 3 ? 1U : 2U);
    EXPECT_EQ((*sources)[0], (SizeSource{{0, 0}, {1, 0}, 0x1p30 - less, 0x1p30}));
    EXPECT_EQ(sources->back().at_b, less == 3 ? 0x1p30 : 0x1p31);
  }
}

TEST(SourcesOfARaster, need_a_limit_that_is_positive_and_finite) {
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity(), static_cast<double>(NAN)})
    EXPECT_EQ(size_sources(sample(), wrong).error().kind, ErrorKind::usage);
}

TEST(SourcesOfARaster, compare_slopes_with_any_limit) {
  for (const double limit : {0.125, 0.5, 3.0, 8.0})
    for (const double share : {0.9, 1.1}) {
      const Raster row{3, 2, {0, 0}, 1, 1, {20, 20 + share * limit, 20, 20, 20 + share * limit, 20}};
      EXPECT_EQ(size_sources(row, limit)->empty(), share < 1) << limit;
    }
}

}  // namespace
}  // namespace pardel
