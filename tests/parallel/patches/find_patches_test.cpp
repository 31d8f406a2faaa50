// Patches keep their distance from everything, and miss no place.
#include "../../../parallel/patches/find_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "distance_to.hpp"
#include "domains_to_fill.hpp"

namespace pardel::engine {
namespace {

/// The distance from p to the nearest point or segment of a domain.
double clearance(const Pslg& pslg, Point p) {
  double least = INFINITY;
  for (const Point q : pslg.points) least = std::min(least, distance_to(q, q, p));
  for (const Segment& s : pslg.segments) least = std::min(least, distance_to(pslg.points[s.a], pslg.points[s.b], p));
  return least;
}

bool is_in_domain(const DomainTriangulation& domain, Point p) {
  const Triangulation& t = domain.triangulation;
  return std::any_of(t.slots.begin(), t.slots.end(), [&](const Slot& slot) {
    const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
    const auto left = [&](Point from, Point to) {
      return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x) >= 0;
    };
    return left(a, b) && left(b, c) && left(c, a);
  });
}

TEST(FindPatches, takes_all_triangles_of_the_lattice_that_are_far_enough_from_everything) {
  for (const Pslg& pslg : domains_to_fill()) {
    const DomainTriangulation domain = coarse(pslg);
    const double edge = extent(pslg) / 23;
    const auto found = find_patches(domain.triangulation, std::array{edge}, {}, {});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].region, no_index);
    const Patch& patch = found[0].patch;
    std::set<std::pair<int, int>> places;
    for (const Piece& piece : patch.pieces())
      for (int x = piece.low; x <= piece.high; x += 2) {
        places.emplace(piece.row, x);
        EXPECT_GE(clearance(pslg, patch.lattice().at(x, piece.row)), 0.7 * edge * (1 - 1e-9));
        EXPECT_TRUE(is_in_domain(domain, patch.lattice().at(x, piece.row)));
      }
    const auto fits = [&](int x, int row) {
      const Point p = patch.lattice().at(x, row);
      return is_in_domain(domain, p) && clearance(pslg, p) > 0.7 * edge * (1 + 1e-9);
    };
    for (int row = 0; row < 60; ++row)
      for (int x = row % 2; x < 120; x += 2)
        if (fits(x, row) && fits(x + 2, row) && fits(x + 1, row + 1)) {
          EXPECT_TRUE(places.contains({row, x}));
        }
  }
}

TEST(FindPatches, makes_none_without_a_bound_or_beyond_double_precision) {
  const DomainTriangulation square = coarse(domains::square());
  EXPECT_TRUE(find_patches(square.triangulation, std::array{double{INFINITY}}, {}, {}).empty());
  EXPECT_TRUE(find_patches(square.triangulation, std::array{3.0}, {}, {}).empty()) << "no triangle fits";
  EXPECT_FALSE(find_patches(square.triangulation, std::array{0.1}, {}, {}).empty());
  const DomainTriangulation far = coarse(domains::moved(domains::square(), 1e9, 0));
  EXPECT_TRUE(find_patches(far.triangulation, std::array{0.1}, {}, {}).empty());
  for (const double scale : {0x1p-80, 0x1p-100}) {
    Pslg small = domains::square();
    for (Point& p : small.points) p = {scale * p.x, scale * p.y};
    const auto found = find_patches(coarse(small).triangulation, std::array{scale / 16}, {}, {});
    EXPECT_EQ(found.empty(), scale < 0x1p-82) << "some coordinates could be too small for the predicates";
  }
}

TEST(FindPatches, leaves_clearings_free_and_nothing_else) {
  const DomainTriangulation square = coarse(domains::square());
  const double edge = 1.0 / 23;
  const Clearing clearing{{0.4, 0.55}, 3.3 * edge};
  const auto whole = find_patches(square.triangulation, std::array{edge}, {}, {});
  const auto found = find_patches(square.triangulation, std::array{edge}, std::array{clearing}, {});
  ASSERT_EQ(found.size(), 1U);
  const Patch& patch = found[0].patch;
  std::size_t cleared = 0, points = 0;
  for (const Piece& piece : whole[0].patch.pieces())
    for (int x = piece.low; x <= piece.high; x += 2)
      cleared += distance_to(clearing.centre, clearing.centre, patch.lattice().at(x, piece.row)) <= clearing.radius;
  for (const Piece& piece : patch.pieces())
    for (int x = piece.low; x <= piece.high; x += 2, ++points)
      EXPECT_GT(distance_to(clearing.centre, clearing.centre, patch.lattice().at(x, piece.row)), clearing.radius);
  EXPECT_GT(cleared, 30U);
  EXPECT_EQ(points + cleared, whole[0].patch.border_points() + whole[0].patch.inner_points());
}

}  // namespace
}  // namespace pardel::engine
