// At a bound of 30 degrees refinement has no guarantee of grading, and there is a domain that shows it.
#pragma once

#include <gtest/gtest.h>

#include "../../../core/pslg.hpp"

namespace pardel::properties {

/// Right triangles with an angle of 30 degrees and 1.1e-11 more at one vertex of the input, within the hair by which
/// the engine is stricter than the goal, half of each the next, until the floor on edges: over a thousand of them, and
/// reported. At 28 and 29 degrees a mesh of fewer than 50 triangles is valid. Refinement is known to fail above 30
/// degrees, and may from 29.5 on (A. Rand, "On the non-termination of Ruppert's algorithm", 2011, arXiv 1101.1071).
[[nodiscard]] testing::AssertionResult is_halved_down_to_the_floor(const Pslg& domain);

}  // namespace pardel::properties
