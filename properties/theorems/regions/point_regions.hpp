// Regions that are single points. Each function below tests a scene for a fact about the hypothesis of T-region
// (properties/THEORY.md). region_test.cpp searches for scenes with each fact, and there is a stored witness of each
// fact.
#pragma once

#include "../framework/scenes.hpp"

namespace pardel::properties {

/// The cavities of the two insertions have a common triangle, and interleaved insertion does not give the sequential
/// mesh.
[[nodiscard]] bool fails_at_a_common_triangle(const MeshedScene& given);
/// The cavities have no common triangle, and interleaved insertion does not give the sequential mesh.
[[nodiscard]] bool fails_at_a_common_edge(const MeshedScene& given);
/// The two sequential orders give different meshes.
[[nodiscard]] bool depends_on_the_order(const MeshedScene& given);
/// Computed from whole disks, K(p) and K(q) have a common triangle; computed from their visible parts (struct Apart),
/// they have no common vertex; and all orders give one mesh.
[[nodiscard]] bool is_kept_apart_by_a_wall(const MeshedScene& given);
/// The cavities share a vertex and no edge, and all orders give one mesh.
[[nodiscard]] bool holds_at_a_common_vertex(const MeshedScene& given);
/// Computed from whole disks, K(p) and K(q) have no common vertex; but the disk of a triangle that the first insertion
/// makes contains the second point.
[[nodiscard]] bool grows_beyond_a_wall(const MeshedScene& given);
/// Two tasks that both own the whole plane insert one point each; alternating steps do not give the sequential mesh.
[[nodiscard]] bool fails_for_one_box(const MeshedScene& given);

}  // namespace pardel::properties
