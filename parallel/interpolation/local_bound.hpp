// Bounds on size that depend on the place: functions of the caller, and values on a background triangulation.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "background.hpp"

namespace pardel::engine {

/// A function that interpolates values at the points of a background. With limited == true it throws an Error at points
/// that are farther from the background than the longest side of the nearest triangle.
struct PointValues {
  std::shared_ptr<const Background> background;
  std::vector<double> values;
  bool limited = false;
  [[nodiscard]] double at(Point p, LocationHint& hint) const;
};
/// A function that is constant on each triangle of a background. The values have to outlive it.
struct TriangleValues {
  std::shared_ptr<const Background> background;
  std::span<const double> values;
  [[nodiscard]] double at(Point p, LocationHint& hint) const { return values[background->locate(p, hint).triangle]; }
};

/// Such a function without a hint: the target of a std::function that other parts of the program can call.
template <class Values>
struct OnBackground {
  std::shared_ptr<const Values> field;
  [[nodiscard]] double operator()(Point p) const {
    LocationHint none;
    return field->at(p, none);
  }
};

/// A bound that depends on the place. The hint makes searches in a background fast; it does not change the value.
using LocalBound = std::function<double(Point, LocationHint&)>;

/// The function as a LocalBound, with hints if its target is an OnBackground. Empty if the function is empty.
[[nodiscard]] LocalBound local_bound(std::function<double(Point)> function);

/// The hints of one thread for the local bounds of a goal.
struct LocalHints {
  LocationHint size, area;
};

}  // namespace pardel::engine
