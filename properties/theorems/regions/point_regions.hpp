// What two single points, each a region of its own, show about the hypothesis of T-region: searches find scenes that
// show it, and stored witnesses keep one of each.
#pragma once

#include "../framework/scenes.hpp"

namespace pardel::properties {

/// The cavities of the two insertions have a triangle in common, and inserted in turns they do not give one mesh.
[[nodiscard]] bool fails_at_a_common_triangle(const MeshedScene& given);
/// The cavities have no triangle in common, and yet it fails.
[[nodiscard]] bool fails_at_a_common_edge(const MeshedScene& given);
/// Even when each is inserted as a whole, the two orders give two meshes.
[[nodiscard]] bool depends_on_the_order(const MeshedScene& given);
/// Whole disks reach a common triangle, but what is reached in sight shares no vertex, and it holds.
[[nodiscard]] bool is_kept_apart_by_a_wall(const MeshedScene& given);
/// The cavities share a vertex and no edge, and it holds.
[[nodiscard]] bool holds_at_a_common_vertex(const MeshedScene& given);
/// What whole disks reach shares no vertex, but once the first is inserted the disk of one of its triangles holds
/// the second.
[[nodiscard]] bool grows_beyond_a_wall(const MeshedScene& given);
/// Two tasks with an insertion each, both of which own everything, do not make in turns what they make one after the
/// other.
[[nodiscard]] bool fails_for_one_box(const MeshedScene& given);

}  // namespace pardel::properties
