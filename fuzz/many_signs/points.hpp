// Four points for a call of each predicate.
#pragma once

#include <array>

#include "../../core/pslg.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace pardel::fuzz {

using FourPoints = std::array<Point, 4>;

/// Points without a relation to each other: uniform, on a lattice, with exponents that differ by up to 20 or 300.
[[nodiscard]] FourPoints random_points(generators::Random& random);

/// Points that are degenerate or nearly so: on a line, on a circle, corners of rectangles, equal, far from the origin.
/// Some are moved by a few units in the last place.
[[nodiscard]] FourPoints hard_points(generators::Random& random);

}  // namespace pardel::fuzz
