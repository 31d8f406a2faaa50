// Tests encroachment, and the points that split bad triangles.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "../../../parallel/quality/criteria.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/shares.hpp"
#include "exact_bounds.hpp"

namespace pardel::engine {
namespace {

Point some_point() { return {double(*rc::gen::inRange(-12, 13)), double(*rc::gen::inRange(-12, 13))}; }

Shape some_triangle() {
  const Point a = some_point(), b = some_point(), c = some_point();
  const int turn = checker::exactly::orientation(a, b, c);
  RC_PRE(turn != 0);
  return turn > 0 ? Shape(a, b, c) : Shape(a, c, b);
}

/// The triangle of the shortest side and the split point; nothing if the split point is the circumcentre.
std::optional<Shape> made_by_an_off_centre(const Shape& s, const Goal& goal) {
  const Point p = Criteria(goal, Placement::off_centre, {}).split_point(s, no_index);
  if (p == Criteria(goal, Placement::circumcentre, {}).split_point(s, no_index)) return std::nullopt;
  const unsigned o = s.shortest_side();
  return Shape(s.p[next_corner[o]], s.p[previous_corner[o]], p);
}

PARDEL_PROPERTY(Encroachment, of_a_conforming_goal_is_the_closed_diametral_disk,
                {.statement = "for a conforming goal a vertex encroaches upon a side of its triangle if and only if it "
                              "lies inside or on the circle that has the side as its diameter",
                 .source = "properties/THEORY.md, conventions",
                 .families = "lattice triangles, many of them right-angled"}) {
  const Criteria criteria({.conforming = true}, Placement::circumcentre, {});
  const Shape s = some_triangle();
  for (unsigned i = 0; i < 3; ++i) {
    const Point p = s.p[i], a = s.p[next_corner[i]], b = s.p[previous_corner[i]];
    const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);  // exact for small integers
    RC_ASSERT(criteria.encroaches(s.dot_at(i), s.squared[next_corner[i]], s.squared[previous_corner[i]]) == (dot <= 0));
  }
}

PARDEL_PROPERTY(SplitPoint, of_a_bad_triangle_makes_a_good_one_of_its_shortest_side,
                {.statement = "the shortest side of a bad triangle and its split point make a triangle that keeps the "
                              "angle bound, unless the split point is the circumcentre",
                 .source = "Ungor, Off-centers, 2004",
                 .families = "lattice triangles"}) {
  const double bound = *rc::gen::element(10.0, 20.7, 25.0, 30.0);
  const Goal goal{.min_angle_deg = bound};
  const Shape s = some_triangle();
  RC_PRE(sharper_than(s, bound));
  const std::optional<Shape> made = made_by_an_off_centre(s, goal);
  if (!made) return;
  RC_ASSERT(checker::exactly::orientation(made->p[0], made->p[1], made->p[2]) > 0);
  RC_ASSERT(!sharper_than(*made, bound));
}

PARDEL_PROPERTY(SplitPoint, of_a_large_triangle_makes_a_small_one_of_its_shortest_side,
                {.statement = "the shortest side of a triangle above the bound on areas and its split point make a "
                              "triangle that keeps that bound and the bound on angles, unless the split point is the "
                              "circumcentre, or the side's diametral circle leaves no room for it",
                 .source = "after Engwirda and Ivers, Off-centre Steiner points, 2016",
                 .families = "lattice triangles"}) {
  const Shape s = some_triangle();
  const double times = *rc::gen::element(1.25, 1.5, 2.0, 3.0, 5.0);
  const Goal goal{.min_angle_deg = *rc::gen::element(0.0, 20.7, 30.0), .max_area = s.twice_area / 2 / times};
  const std::optional<Shape> made = made_by_an_off_centre(s, goal);
  if (!made) return;
  RC_ASSERT(checker::exactly::orientation(made->p[0], made->p[1], made->p[2]) > 0);
  RC_ASSERT(!sharper_than(*made, goal.min_angle_deg));
  RC_ASSERT(!larger_than(*made, goal.max_area) || 0.25 * s.shortest_squared() > 0.98 * goal.max_area);
}

PARDEL_PROPERTY(SplitPoint, of_a_large_triangle_is_far_from_all_vertices,
                {.statement = "no vertex of a Delaunay triangulation is nearer to the split point of a triangle whose "
                              "area exceeds its bound, where angles have no bound, than the circumradius and than the "
                              "square root of 0.99 of the bound, whichever is less",
                 .source = "properties/THEORY.md, refinement",
                 .families = "lattice triangles; points beyond their shortest sides"}) {
  const Shape s = some_triangle();
  const double times = *rc::gen::element(1.25, 1.5, 2.0, 3.0, 5.0, 8.0);
  const Goal goal{.min_angle_deg = 0, .max_area = s.twice_area / 2 / times};
  const Point p = Criteria(goal, Placement::off_centre, {}).split_point(s, no_index);
  const unsigned o = s.shortest_side();
  const Point q = s.p[next_corner[o]], r = s.p[previous_corner[o]];
  const double along = *rc::gen::inRange(0, 65) / 64.0, beyond = *rc::gen::inRange(0, 65) / 128.0;
  const Point below{q.x + along * (r.x - q.x) + beyond * (r.y - q.y), q.y + along * (r.y - q.y) - beyond * (r.x - q.x)};
  for (const Point vertex : {s.p[0], s.p[1], s.p[2], below}) {
    if (checker::exactly::in_circle(s.p[0], s.p[1], s.p[2], vertex) > 0) continue;
    const double dx = vertex.x - p.x, dy = vertex.y - p.y;
    RC_ASSERT(dx * dx + dy * dy > 0.999999 * std::min(0.99 * goal.max_area, s.squared_circumradius()));
  }
}

/// Sizes between 1 and 1.5 on the squares of a lattice, each divided into two triangles.
std::function<double(Point)> some_field(int side) {
  std::vector<Point> points;
  std::vector<double> sizes;
  std::vector<std::array<Index, 3>> triangles;
  const auto at = [&](int x, int y) { return static_cast<Index>(y * (side + 1) + x); };
  const int steps = *rc::gen::inRange(0, 5);
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) {
      points.push_back({double(x), double(y)});
      sizes.push_back(1 + *rc::gen::inRange(0, steps + 1) / 16.0);
      if (x == side || y == side) continue;
      triangles.push_back({at(x, y), at(x + 1, y), at(x, y + 1)});
      triangles.push_back({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  auto background = std::make_shared<const Background>(points, std::move(triangles));
  return OnBackground<PointValues>{
      std::make_shared<const PointValues>(PointValues{std::move(background), std::move(sizes), false})};
}

/// Sizes that grow with the distance from a point, and the promise of their slope.
void promise_some_slope(Goal& goal) {
  const Point centre{*rc::gen::inRange(0, 97) / 16.0, *rc::gen::inRange(0, 97) / 16.0};
  goal.size_slope = *rc::gen::inRange(0, 17) / 32.0;
  goal.size = [centre, slope = goal.size_slope](Point p) {
    const double x = p.x - centre.x, y = p.y - centre.y;
    return 1 + slope * std::sqrt(x * x + y * y);
  };
}

/// The triangle, scaled about its first corner.
Shape scaled(const Shape& s, double factor) {
  const auto moved = [&](Point p) {
    return Point{s.p[0].x + factor * (p.x - s.p[0].x), s.p[0].y + factor * (p.y - s.p[0].y)};
  };
  return {s.p[0], moved(s.p[1]), moved(s.p[2])};
}

PARDEL_PROPERTY(
    SizeAround, a_corner_changes_no_answer,
    {.statement = "a triangle is too large for the size at its centroid if and only if it is so after the size at "
                  "its first corner was looked up",
     .source = "parallel/quality/criteria.hpp",
     .families = "triangles in a square with random sizes at lattice points, or with sizes that grow from a "
                 "point with a promised slope; scaled such that the longest side is the size up to a few "
                 "units in the last place, or differs by up to a half"}) {
  constexpr int side = 6;
  Goal goal{.min_angle_deg = 0};
  if (*rc::gen::arbitrary<bool>())
    goal.size = some_field(side);
  else
    promise_some_slope(goal);
  const Criteria criteria(goal, Placement::circumcentre, {});
  const auto coordinate = [](int low, int high) { return *rc::gen::inRange(16 * low, 16 * high + 1) / 16.0; };
  const Point p{coordinate(2, 4), coordinate(2, 4)};
  const auto corner = [&] { return Point{p.x + coordinate(-1, 1), p.y + coordinate(-1, 1)}; };
  const Point a = corner(), b = corner();
  RC_PRE(checker::exactly::orientation(p, a, b) > 0);
  const Shape shape(p, a, b);
  double low = 0, high = 2 / std::sqrt(shape.longest_squared());
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (criteria.too_large_locally(scaled(shape, middle), no_index) ? high : low) = middle;
  }
  const double factor = high * (1 + *rc::gen::element(0.0, 0x1p-51, -0x1p-50, 0x1p-44, -0x1p-42, 0.01, -0.02, 0.05,
                                                      -0.05, 0.1, -0.1, 0.3, -0.3, -0.5));
  const Shape s = scaled(shape, factor);
  LocalHints hints;
  criteria.look_around(p, hints);
  const bool decided = s.longest_squared() <= hints.around.keeps || s.longest_squared() > hints.around.exceeds;
  properties::classify(decided, "decided by the corner", 20);
  properties::classify(!decided, "not decided by the corner", 20);
  RC_ASSERT(criteria.too_large_locally(s, s.p[0], s.p[1], s.p[2], no_index, hints) ==
            criteria.too_large_locally(s, no_index));
}

}  // namespace
}  // namespace pardel::engine
