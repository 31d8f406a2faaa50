// Regions that are single points: what they show about the hypothesis of T-region (properties/THEORY.md).
// region_test.cpp searches for a scene of each kind, and a stored witness shows one of each kind.
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
/// Whole disks reach a common triangle, their visible parts reach no common vertex, and all orders give one mesh.
[[nodiscard]] bool is_kept_apart_by_a_wall(const MeshedScene& given);
/// The cavities share a vertex and no edge, and all orders give one mesh.
[[nodiscard]] bool holds_at_a_common_vertex(const MeshedScene& given);
/// Whole disks reach no common vertex; but after the first insertion, the disk of one of its triangles contains the
/// second point.
[[nodiscard]] bool grows_beyond_a_wall(const MeshedScene& given);
/// Two tasks that both own the whole plane insert one point each; alternating steps do not give the sequential mesh.
[[nodiscard]] bool fails_for_one_box(const MeshedScene& given);

}  // namespace pardel::properties
