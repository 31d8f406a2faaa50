// Random domains whose coordinates are rounded.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../../parallel/validate.hpp"
#include "meshing.hpp"

namespace pardel::properties {

/// The domain, scaled to coordinates up to 1000, turned, and moved far from the origin. All coordinates are rounded.
inline Pslg turned(const generators::LatticeDomain& domain, double angle, Point to) {
  generators::LatticeDomain near = domain;
  near.offset = {};
  near.exponent = 0;
  Pslg pslg = generators::to_pslg(near);
  double largest = 1;
  for (const Point p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const double c = 1000 / largest * std::cos(angle), s = 1000 / largest * std::sin(angle);
  const auto turn = [&](Point& p) { p = {to.x + c * p.x - s * p.y, to.y + s * p.x + c * p.y}; };
  for (Point& p : pslg.points) turn(p);
  for (Point& p : pslg.holes) turn(p);
  for (Region& r : pslg.regions) {
    turn(r.seed);
    r.max_area = std::numeric_limits<double>::infinity();
  }
  return pslg;
}

inline constexpr const char* turned_families = "lattice domains of every family, turned and far from the origin";

/// A valid domain that was turned. Rounding can make a turned domain invalid; such cases are discarded.
inline Problem some_turned_problem(Exhibit& exhibit) {
  const generators::Case c = some_case(exhibit);
  const Point to{*rc::gen::element(0.0, 654321.0), *rc::gen::element(0.0, 4987654.0)};
  Problem problem{turned(c.domain, 0.01 * *rc::gen::inRange(0, 157), to),
                  {.min_angle_deg = c.goal.min_angle_deg, .conforming = c.goal.conforming}};
  RC_PRE(find_problems(problem.pslg).empty());
  exhibit.show(problem.pslg);
  return problem;
}

}  // namespace pardel::properties
