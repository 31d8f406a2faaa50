// Points, lines and polygons that Python has read from the shapes of other programs.
#pragma once

#include "../../../cli/drawn_domain.hpp"
#include "arrays.hpp"

namespace pardel::python {

/// Arrays that have been checked. Parts of shapes are points, lines or rings; rings of holes follow their outer ring.
struct Shapes {
  Numbers coordinates;  ///< of all parts
  Integers starts;      ///< where each part begins in them, and the end
  Integers kinds;       ///< of each part
  Integers rows;        ///< the row of its properties
  Numbers properties;   ///< five columns
};

/// The first part that is a hole outside the outline of its polygon (cli::lies_outside()).
[[nodiscard]] std::optional<std::size_t> first_hole_outside(const Shapes& shapes);

[[nodiscard]] cli::DrawnDomain drawing_of(const Shapes& shapes);

}  // namespace pardel::python
