// How Goal::user_test is asked about a triangle. The mesher and the checker ask in the same way, so the answers are the
// same.
#pragma once

#include "goal.hpp"

namespace pardel {

/// True if the test says that the triangle must be refined. The test gets the corners from the lexicographically least
/// one, and the area computed from this order, at least 0. So neither depends on which corner is stored first.
/// Precondition: the corners are counter-clockwise.
[[nodiscard]] bool must_be_refined(const UserTest& test, Point a, Point b, Point c);

}  // namespace pardel
