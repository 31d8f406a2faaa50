// The lens that the engine uses in place of the diametral circle of a wall (properties/THEORY.md, T2).
#pragma once

#include "../../../ref/definitions.hpp"

namespace pardel::properties {

/// The lens of an angle bound α with a rational tangent.
struct Lens {
  ref::Number squared_cosine, squared_sine;  ///< of 2 α

  explicit Lens(const ref::Number& tangent) {
    const ref::Number squares = 1 + tangent * tangent, cosine = (1 - tangent * tangent) / squares;
    squared_cosine = cosine * cosine;
    squared_sine = 1 - squared_cosine;
  }
  /// Does p see ab at an angle of 180° - 2 α or more?
  [[nodiscard]] bool contains(const ref::ExactPoint& p, const ref::ExactPoint& a, const ref::ExactPoint& b) const {
    const auto u = a - p, v = b - p;
    const ref::Number dot = u * v;
    return dot < 0 && dot * dot >= squared_cosine * u.squared_length() * v.squared_length();
  }
};

}  // namespace pardel::properties
