// When a vertex encroaches, and where the point goes that splits a bad triangle.
#include <cmath>
#include <numbers>

#include "../../parallel/criteria.hpp"
#include "../../properties/check.hpp"
#include "../../properties/exact.hpp"
#include "../../properties/framework/property.hpp"

namespace pardel {
namespace {

Point some_point() { return {double(*rc::gen::inRange(-12, 13)), double(*rc::gen::inRange(-12, 13))}; }

Shape some_triangle() {
  const Point a = some_point(), b = some_point(), c = some_point();
  const int turn = exactly::orientation(a, b, c);
  RC_PRE(turn != 0);
  return turn > 0 ? Shape(a, b, c) : Shape(a, c, b);
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
  const Criteria off_centres(goal, Placement::off_centre, {}), circumcentres(goal, Placement::circumcentre, {});
  const Shape s = some_triangle();
  RC_PRE(off_centres.bad_shape(s));
  const Point p = off_centres.split_point(s);
  if (p == circumcentres.split_point(s)) return;
  const unsigned o = s.shortest_side();
  const Shape made(s.p[next_corner[o]], s.p[previous_corner[o]], p);
  RC_ASSERT(made.twice_area > 0);
  RC_ASSERT(!off_centres.bad_shape(made));
}

}  // namespace
}  // namespace pardel
