#include "local_bound.hpp"

#include <algorithm>
#include <utility>

#include "../../core/result.hpp"
#include "../../core/support/shortest.hpp"

namespace pardel::engine {
namespace {

template <class Values>
LocalBound with_hint(const std::function<double(Point)>& function) {
  const auto* known = function.target<OnBackground<Values>>();
  if (known == nullptr) return {};
  return LocalBound([field = known->field](Point p, LocationHint& hint) { return field->at(p, hint); },
                    known->field->steepness());
}

}  // namespace

double PointValues::at(Point p, LocationHint& hint) const {
  const Located found = background->locate(p, hint);
  if (limited && !background->is_near(found, p))
    throw Error{ErrorKind::invalid_input, "the mesh of the sizes does not cover " + shortest(p)};
  return background->value_at(found, values);
}

double GradedValues::at(Point p, LocationHint& hint) const {
  const double length = grown.at(p);
  return size ? std::min(length, size(p, hint)) : length;
}

Steepness GradedValues::steepness() const {
  const Steepness both = grown.steepness();
  if (!size) return both;
  return {std::max(both.slope, size.steepness().slope), std::max(both.blur, size.steepness().blur)};
}

LocalBound local_bound(std::function<double(Point)> function) {
  if (!function) return {};
  if (LocalBound found = with_hint<PointValues>(function)) return found;
  if (LocalBound found = with_hint<TriangleValues>(function)) return found;
  if (LocalBound found = with_hint<GradedValues>(function)) return found;
  return LocalBound([function = std::move(function)](Point p, LocationHint&) { return function(p); });
}

}  // namespace pardel::engine
