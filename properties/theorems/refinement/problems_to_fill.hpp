// Random problems with constant bounds on sizes, whose interiors can be filled with equilateral triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshing.hpp"

namespace pardel::properties {

inline constexpr const char* filled_families =
    "lattice domains of every family, random goals up to 30 degrees; bounds on areas from a 30th to a 3000th of the "
    "bounding box, bounds on edges, and caps per region";

inline double box_area(const Pslg& pslg) {
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [bottom, top] = std::ranges::minmax(pslg.points, {}, &Point::y);
  return (right.x - left.x) * (top.y - bottom.y);
}

/// A random problem with constant bounds on sizes.
inline Problem some_problem_to_fill(Exhibit& exhibit) {
  Problem problem = some_problem(exhibit);
  Goal& goal = problem.goal;
  if (*rc::gen::inRange(0, 6) == 0) goal.min_angle_deg = 30;
  const double area = box_area(problem.pslg) / *rc::gen::inRange(30, 3000);
  goal.max_area = goal.max_edge = std::numeric_limits<double>::infinity();
  if (*rc::gen::inRange(0, 4) == 0)
    goal.max_edge = 1.5 * std::sqrt(area);
  else
    goal.max_area = area;
  for (Region& region : problem.pslg.regions)
    if (*rc::gen::arbitrary<bool>()) region.max_area = area / *rc::gen::element(1, 4, 16);
  return problem;
}

inline Options filling_options() {
  Options options = some_options();
  options.interior = Interior::fill;
  return options;
}

}  // namespace pardel::properties
