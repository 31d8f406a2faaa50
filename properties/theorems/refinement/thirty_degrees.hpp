// A domain without small angles for which refinement at a bound of 30 degrees makes a cascade of smaller and smaller
// triangles.
#pragma once

#include <gtest/gtest.h>

#include "../../../core/pslg.hpp"

namespace pardel::properties {

/// Succeeds if the engine meshes the domain as follows. At 30 degrees it makes over a thousand right triangles with an
/// angle that exceeds 30 degrees by 1.1e-11, which is less than the margin by which the engine is stricter than the
/// goal. Each triangle is half as large as the one before it, until edges have the shortest length that the engine
/// allows (the floor). The report lists these triangles. At 28 and 29 degrees the mesh has fewer than 50 triangles and
/// is valid. From 29.5 degrees on, refinement may fail to end (A. Rand, "On the non-termination of Ruppert's
/// algorithm", 2011, arXiv 1101.1071).
[[nodiscard]] testing::AssertionResult is_halved_down_to_the_floor(const Pslg& domain);

}  // namespace pardel::properties
