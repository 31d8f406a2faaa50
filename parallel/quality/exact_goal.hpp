// The bounds of a goal, compared exactly.
#pragma once

#include <functional>

#include "../../core/goal.hpp"

namespace pardel::engine {

/// Decides about triangles whose measures are as near to a bound as those for which Criteria, which are slightly
/// stricter, find that they break it. Values of functions are not rounded again: the goal's size and the area cap at
/// the centroid, and the cosine of the smallest angle, are doubles with which the triangle is compared exactly.
class ExactGoal {
 public:
  /// `area_cap`: the area cap at a point, or empty.
  ExactGoal(const Goal& goal, std::function<double(Point)> area_cap);

  /// True if no angle is below the bound. Precondition, here and below: a, b, c are counter-clockwise.
  [[nodiscard]] bool keeps_angles(Point a, Point b, Point c) const;
  /// True if the area and the edges keep their bounds, except area caps of regions, and the triangle passes the test of
  /// the user.
  [[nodiscard]] bool keeps_sizes(Point a, Point b, Point c) const;

 private:
  double max_area_, max_edge_;
  double cosine_;  ///< of the smallest angle; 1: no bound
  std::function<double(Point)> size_, area_cap_;
  UserTest user_test_;
};

}  // namespace pardel::engine
