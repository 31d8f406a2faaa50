// Which places of the lattice lie in a triangle or near a segment, compared with the definition place by place.
#include "../../../parallel/patches/triangular_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "../samples.hpp"
#include "distance_to.hpp"

namespace pardel::engine {
namespace {

using Places = std::set<std::pair<int, int>>;

Places places_of(const std::vector<Span>& spans) {
  Places places;
  for (const Span& span : spans) {
    EXPECT_LE(span.low, span.high);
    for (int x = span.low; x <= span.high; x += 2) {
      EXPECT_EQ((x ^ span.row) & 1, 0) << "(" << x << ", " << span.row << ") is no place";
      places.emplace(span.row, x);
    }
  }
  return places;
}

double cross(Point a, Point b, Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

/// Calls visit(place, its point) for all places of a large part of the lattice.
template <class Visit>
void visit_places(const TriangularLattice& lattice, const Visit& visit) {
  for (int row = -40; row <= 40; ++row)
    for (int x = -80 + (row & 1); x <= 80; x += 2) visit(std::pair(row, x), lattice.at(x, row));
}

Point some_point(samples::Random& random) { return {random.uniform(-3, 3), random.uniform(-3, 3)}; }

TEST(TriangularLattice, has_six_neighbours_at_the_length_of_an_edge) {
  const TriangularLattice lattice({3, -2}, 0.7);
  EXPECT_EQ(lattice.at(0, 0), (Point{3, -2}));
  const Point p = lattice.at(5, 3);
  for (const auto& [x, row] : {std::pair(3, 3), {7, 3}, {4, 2}, {6, 2}, {4, 4}, {6, 4}})
    EXPECT_NEAR(std::hypot(lattice.at(x, row).x - p.x, lattice.at(x, row).y - p.y), 0.7, 1e-15);
}

TEST(TriangularLattice, finds_the_places_in_a_triangle) {
  samples::Random random(1);
  const TriangularLattice lattice({0.1, 0.2}, 0.37);
  for (int i = 0; i < 300; ++i) {
    Point a = some_point(random), b = some_point(random), c = some_point(random);
    if (i % 3 == 0) b.y = a.y;  // a horizontal side
    if (i % 7 == 0) c = lattice.at(4, 2);
    if (cross(a, b, c) < 0) std::swap(a, b);
    std::vector<Span> spans;
    lattice.add_inside(a, b, c, spans);
    const Places found = places_of(spans);
    visit_places(lattice, [&](auto place, Point p) {
      const double least = std::min({cross(a, b, p), cross(b, c, p), cross(c, a, p)});
      if (std::abs(least) <= 1e-5) return;  // rounding decides
      EXPECT_EQ(found.contains(place), least > 0) << i;
    });
  }
}

TEST(TriangularLattice, leaves_no_gap_between_triangles_with_a_common_side) {
  samples::Random random(2);
  const TriangularLattice lattice({0, 0}, 0.21);
  for (int i = 0; i < 300; ++i) {
    const Point low{-2, -2}, high{2, 2}, left{-2, 2}, right{2, -2};
    const Point p{random.uniform(-2, 2), random.uniform(-2, 2)};
    std::vector<Span> spans;
    for (const auto& [a, b] : {std::pair(low, right), {right, high}, {high, left}, {left, low}})
      lattice.add_inside(a, b, i % 2 == 0 ? p : lattice.at(2, 4), spans);
    const Places found = places_of(spans);
    visit_places(lattice, [&](auto place, Point q) {
      const double inside = 2 - std::max(std::abs(q.x), std::abs(q.y));
      if (std::abs(inside) <= 1e-5) return;  // rounding decides
      EXPECT_EQ(found.contains(place), inside > 0);
    });
  }
}

TEST(TriangularLattice, finds_the_places_near_a_segment) {
  samples::Random random(3);
  const TriangularLattice lattice({-0.3, 0.2}, 0.31);
  for (int i = 0; i < 600; ++i) {
    const Point a = some_point(random);
    Point b = some_point(random);
    if (i % 5 == 1) b.x = a.x;
    if (i % 5 == 2) b.y = a.y;
    if (i % 5 == 3) b = a;
    const double distance = random.uniform(0.01, 1);
    std::vector<Span> spans;
    lattice.add_near(a, b, distance, spans);
    const Places found = places_of(spans);
    visit_places(lattice, [&](auto place, Point p) {
      const double beyond = distance_to(a, b, p) - distance;
      if (std::abs(beyond) <= 1e-9) return;  // rounding decides
      EXPECT_EQ(found.contains(place), beyond < 0) << i;
    });
  }
}

TEST(Spans, are_united_and_subtracted_as_sets) {
  samples::Random random(4);
  const auto some_spans = [&] {
    std::vector<Span> spans;
    for (std::size_t n = random.below(12); n > 0; --n) {
      const int row = static_cast<int>(random.below(3)), low = 2 * static_cast<int>(random.below(20)) + row % 2;
      spans.push_back({row, low, low + 2 * static_cast<int>(random.below(6))});
    }
    return spans;
  };
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Span> all = some_spans(), removed = some_spans();
    const std::vector<Span> united = merged(all), rest = without(united, merged(removed));
    EXPECT_EQ(places_of(united), places_of(all));
    Places expected = places_of(all);
    for (const auto& place : places_of(removed)) expected.erase(place);
    EXPECT_EQ(places_of(rest), expected);
    for (const auto& spans : {united, rest})
      for (std::size_t k = 1; k < spans.size(); ++k) {
        EXPECT_LE(spans[k - 1].row, spans[k].row);
        if (spans[k - 1].row == spans[k].row) {
          EXPECT_GT(spans[k].low, spans[k - 1].high + 2);
        }
      }
  }
}

}  // namespace
}  // namespace pardel::engine
