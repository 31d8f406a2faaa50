// The triangles and points of patches, compared with the definition triangle by triangle.
#include "../../../parallel/patches/patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

using Place = std::pair<int, int>;  ///< row, x
const TriangularLattice unit_lattice({0, 0}, 1);

bool stands(int x, int row) { return ((x ^ row) & 1) == 0; }

/// The corners of the triangle at x above a row.
std::array<Place, 3> corners(int x, int row) {
  if (stands(x, row)) return {Place{row, x}, {row, x + 2}, {row + 1, x + 1}};
  return {Place{row + 1, x}, {row + 1, x + 2}, {row, x + 1}};
}

/// Random places: a block with holes and bays.
std::vector<Span> some_places(samples::Random& random) {
  std::vector<Span> all, holes;
  const int rows = 1 + static_cast<int>(random.below(9)), width = 2 + 2 * static_cast<int>(random.below(12));
  for (int row = 0; row < rows; ++row)
    all.push_back({row - 2, stands(0, row) ? 0 : 1, width + (stands(0, row) ? 0 : 1)});
  for (std::size_t n = random.below(14); n > 0; --n) {
    const int row = static_cast<int>(random.below(static_cast<std::size_t>(rows))) - 2;
    const int low = 2 * static_cast<int>(random.below(13)) + (stands(0, row) ? 0 : 1);
    holes.push_back({row, low, low + 2 * static_cast<int>(random.below(3))});
  }
  return without(merged(all), merged(holes));
}

/// Expects that the border of the patch consists of the sides that belong to one of the triangles.
void expect_border(const Patch& patch, const std::set<Place>& triangles) {
  std::vector<Place> point(patch.border_points());
  for (const Piece& piece : patch.pieces())
    for (int x = piece.low; piece.on_border && x <= piece.high; x += 2)
      point[piece.first + static_cast<std::size_t>(x - piece.low) / 2] = {piece.row, x};
  std::vector<Place> number;
  for (const Strip& strip : patch.strips())
    for (int x = strip.low; x <= strip.high; ++x) number.emplace_back(strip.row, x);

  using Side = std::tuple<Place, Place, Place>;  ///< from, to, and the triangle
  std::set<std::pair<Place, Place>> sides;
  std::set<Side> expected, found;
  // The corners of a hanging triangle are listed clockwise.
  const auto sides_of = [&](Place triangle) {
    auto c = corners(triangle.second, triangle.first);
    if (!stands(triangle.second, triangle.first)) std::swap(c[0], c[1]);
    return std::array{std::pair{c[0], c[1]}, std::pair{c[1], c[2]}, std::pair{c[2], c[0]}};
  };
  for (const Place& triangle : triangles)
    for (const auto& side : sides_of(triangle)) sides.insert(side);
  for (const Place& triangle : triangles)
    for (const auto& [from, to] : sides_of(triangle))
      if (!sides.contains({to, from})) expected.emplace(from, to, triangle);
  const std::vector<BorderSide> border = patch.border();
  for (const BorderSide& side : border) found.emplace(point[side.from], point[side.to], number[side.triangle]);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(border.size(), expected.size());
}

TEST(Patch, has_all_triangles_whose_corners_are_given) {
  samples::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Span> spans = some_places(random);
    std::set<Place> places, used;
    for (const Span& span : spans)
      for (int x = span.low; x <= span.high; x += 2) places.emplace(span.row, x);
    std::set<Place> expected;
    for (int row = -3; row < 9; ++row)
      for (int x = -3; x < 40; ++x) {
        const auto c = corners(x, row);
        if (!std::ranges::all_of(c, [&](Place p) { return places.contains(p); })) continue;
        expected.emplace(row, x);
        used.insert(c.begin(), c.end());
      }
    const Patch patch(unit_lattice, spans);
    std::set<Place> triangles;
    std::size_t number = 0;
    for (const Strip& strip : patch.strips()) {
      EXPECT_EQ(strip.first, number) << "triangles are numbered in the order of the strips";
      number += strip.count();
      for (int x = strip.low; x <= strip.high; ++x) triangles.emplace(strip.row, x);
    }
    EXPECT_EQ(triangles, expected);
    EXPECT_EQ(patch.triangles(), expected.size());

    std::size_t border = 0, inner = 0;
    std::set<Place> points;
    for (const Piece& piece : patch.pieces()) {
      std::size_t& next = piece.on_border ? border : inner;
      EXPECT_EQ(piece.first, next);
      next += piece.count();
      for (int x = piece.low; x <= piece.high; x += 2) {
        points.emplace(piece.row, x);
        const bool all_around = expected.contains({piece.row, x}) && expected.contains({piece.row, x - 1}) &&
                                expected.contains({piece.row, x - 2}) && expected.contains({piece.row - 1, x}) &&
                                expected.contains({piece.row - 1, x - 1}) && expected.contains({piece.row - 1, x - 2});
        EXPECT_EQ(piece.on_border, !all_around);
      }
    }
    EXPECT_EQ(points, used);
    expect_border(patch, expected);
    EXPECT_EQ(patch.border_points(), border);
    EXPECT_EQ(patch.inner_points(), inner);
  }
}

TEST(Patch, lists_strips_and_pieces_by_rows) {
  const Patch patch(unit_lattice, {{4, 0, 6}, {5, 1, 7}, {6, 0, 6}});
  EXPECT_TRUE(patch.strips_above(3).empty());
  ASSERT_EQ(patch.strips_above(4).size(), 1U);
  EXPECT_EQ(patch.strips_above(5)[0].row, 5);
  EXPECT_TRUE(patch.strips_above(6).empty());
  EXPECT_EQ(patch.pieces_of(4).size(), 1U);
  EXPECT_EQ(patch.pieces_of(5).size(), 3U) << "points on both ends are on the border";
  EXPECT_TRUE(patch.pieces_of(7).empty());
}

TEST(Patch, of_places_without_a_triangle_is_empty) {
  for (const auto& places : {std::vector<Span>{{0, 0, 8}}, std::vector<Span>{{0, 0, 0}, {1, 1, 1}},
                             std::vector<Span>{{0, 0, 4}, {2, 0, 4}}}) {
    const Patch patch(unit_lattice, places);
    EXPECT_EQ(patch.triangles() + patch.border_points() + patch.inner_points(), 0U);
    EXPECT_TRUE(patch.strips().empty() && patch.pieces().empty());
  }
}

TEST(Patch, of_nothing_is_empty) {
  EXPECT_EQ(Patch(unit_lattice, {}).triangles(), 0U);
  EXPECT_EQ(Patch(unit_lattice, {{0, 0, 8}}).triangles(), 0U);
  EXPECT_TRUE(Patch(unit_lattice, {{0, 0, 8}}).pieces().empty());
}

}  // namespace
}  // namespace pardel::engine
