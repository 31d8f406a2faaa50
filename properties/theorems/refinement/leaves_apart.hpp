// Points in leaves of a quadtree outside each other's buffer zones, where circumradii are larger than the condition
// allows. Each function tests a scene for a fact; there is a stored witness of each fact.
#pragma once

#include "../framework/scene.hpp"

namespace pardel::properties {

/// The leaves of the two insertions are outside each other's buffer zones. They satisfy the condition on circumradii
/// with 0.251 in place of a quarter, but not with a quarter; and the cavities of the two points have a common vertex.
[[nodiscard]] bool share_a_vertex_above_a_quarter(const Scene& scene);
/// The same with 0.506, and the two points are not independent.
[[nodiscard]] bool are_dependent_above_a_half(const Scene& scene);

}  // namespace pardel::properties
