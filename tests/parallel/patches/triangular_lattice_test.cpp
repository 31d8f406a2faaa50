// Which places of the lattice lie inside a boundary or near a segment, compared with the definition place by place.
#include "../../../parallel/patches/triangular_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// True if a ray from p upwards crosses the polygon an odd number of times.
bool is_inside(const std::vector<Point>& polygon, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.x <= p.x) == (b.x <= p.x)) continue;
    if (a.y + (p.x - a.x) / (b.x - a.x) * (b.y - a.y) > p.y) inside = !inside;
  }
  return inside;
}

/// Some corners are places of the lattice, so rows pass through them, and some sides lie in rows.
TEST(TriangularLattice, finds_the_places_inside_polygons_and_their_holes) {
  samples::Random random(1);
  const TriangularLattice lattice({0.1, 0.2}, 0.37);
  for (int i = 0; i < 300; ++i) {
    std::vector<Point> polygon;  // it may cross itself: then inside is where a ray crosses it an odd number of times
    for (int corners = 3 + i % 6; corners > 0; --corners) polygon.push_back(some_point(random));
    if (i % 3 == 0) polygon[1].y = polygon[0].y;
    if (i % 7 == 0) polygon[2] = lattice.at(4, 2);
    if (i % 14 == 0) polygon[1] = lattice.at(-6, 2);
    std::vector<Crossing> crossings;
    for (std::size_t k = polygon.size(); k-- > 0;)
      lattice.add_crossings(polygon[k], polygon[(k + 1) % polygon.size()], crossings);
    const std::vector<Span> spans = lattice.inside(crossings);
    EXPECT_EQ(spans, merged(spans));
    const Places found = places_of(spans);
    visit_places(lattice, [&](auto place, Point p) {
      for (std::size_t k = 0; k < polygon.size(); ++k)
        if (distance_to(polygon[k], polygon[(k + 1) % polygon.size()], p) < 1e-9) return;  // rounding decides
      EXPECT_EQ(found.contains(place), is_inside(polygon, p)) << i;
    });
  }
}

TEST(TriangularLattice, has_an_even_number_of_crossings_in_each_row_that_meets_corners) {
  const TriangularLattice lattice({0, 0}, 1);
  // Rows 0 to 4 meet a lowest corner, a side in the row, a corner between a lower and a higher one, a highest corner.
  const std::vector<Point> polygon{lattice.at(0, 0), lattice.at(8, 2), lattice.at(12, 2),
                                   lattice.at(9, 3), lattice.at(4, 4), lattice.at(-1, 3)};
  std::vector<Crossing> crossings;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    lattice.add_crossings(polygon[k], polygon[(k + 1) % polygon.size()], crossings);
  for (int row = -1; row <= 5; ++row)
    EXPECT_EQ(std::ranges::count(crossings, row, &Crossing::row), row >= 0 && row <= 3 ? 2 : 0) << row;
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

TEST(TriangularLattice, lists_no_places_outside_its_bounds_however_far_a_segment_or_a_distance_reaches) {
  const TriangularLattice lattice({0, 0}, 1, {-1, -1, 3, 2});
  std::vector<Span> near;
  lattice.add_near({0, 1e30}, {1e30, 1e30}, 1e20, near);
  lattice.add_near({1e30, 0}, {1e30, 0}, 1, near);
  EXPECT_TRUE(near.empty());
  for (const double distance : {1e30, std::numeric_limits<double>::infinity()}) {
    near.clear();
    lattice.add_near({0, 0}, {0, 0}, distance, near);
    const std::vector<Span> all{{-1, -1, 5}, {0, -2, 6}, {1, -1, 5}, {2, -2, 6}};
    EXPECT_EQ(near, all) << distance;
  }
}

}  // namespace
}  // namespace pardel::engine
