// Bounds on size that depend on the place: functions of the caller, and values on a background triangulation.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "background.hpp"
#include "size_envelope.hpp"

namespace pardel::engine {

/// A function that interpolates values at the points of a background. With limited == true it throws an Error at points
/// that are farther from the background than the longest side of the nearest triangle.
struct PointValues {
  std::shared_ptr<const Background> background;
  std::vector<double> values;
  bool limited = false;
  std::string name{};  ///< of a limited function, for messages
  [[nodiscard]] double at(Point p, LocationHint& hint) const;
  /// Of a limited function: where all points are near the background (coverage.hpp).
  [[nodiscard]] Steepness steepness() const { return background->steepness(values); }
};
/// A function that is constant on each triangle of a background.
struct TriangleValues {
  std::shared_ptr<const Background> background;
  std::vector<double> values;
  [[nodiscard]] double at(Point p, LocationHint& hint) const { return values[background->locate(p, hint).triangle]; }
  [[nodiscard]] static Steepness steepness() { return {}; }
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

/// A bound that depends on the place.
class LocalBound {
 public:
  using Function = std::function<double(Point, LocationHint&)>;

  LocalBound() = default;
  /// The steepness is infinite if nothing is known about it.
  explicit LocalBound(Function value, Steepness steepness = {}) : value_(std::move(value)), steepness_(steepness) {}

  explicit operator bool() const { return static_cast<bool>(value_); }
  /// The hint makes searches in a background fast; it does not change the value.
  [[nodiscard]] double operator()(Point p, LocationHint& hint) const { return value_(p, hint); }
  [[nodiscard]] const Steepness& steepness() const { return steepness_; }

 private:
  Function value_;
  Steepness steepness_;
};

/// The function as a LocalBound, with hints if its target is an OnBackground. Empty if the function is empty.
/// `promised_slope`: a bound on the slope of a function of the caller.
[[nodiscard]] LocalBound local_bound(std::function<double(Point)> function, double promised_slope = INFINITY);

/// The least of a bound, if there is one, and of lengths that grow away from their sources.
struct GradedValues {
  LocalBound size;
  SizeEnvelope grown;
  [[nodiscard]] double at(Point p, LocationHint& hint) const;
  [[nodiscard]] Steepness steepness() const;
};

/// What a size at a point says about the triangles that have their first corner there: those whose longest side has at
/// most the square `keeps` keep the size at their centroid, and those with more than `exceeds` do not.
struct SizeAround {
  Point corner{NAN, NAN};
  double keeps = 0, exceeds = INFINITY;
};

/// The hints of one thread for the local bounds of a goal.
struct LocalHints {
  LocationHint size, area;
  SizeAround around;
};

}  // namespace pardel::engine
