// A constraint of the triangulation.
#pragma once

#include "triangulation.hpp"

namespace pardel::engine {

/// An edge that the triangulation must contain, given by its two vertices.
struct Constraint {
  VertexId a, b;
};

}  // namespace pardel::engine
