// Refinement by one worker, as a part of a scheme: before cells or parts exist, or after they are put together.
#pragma once

#include <deque>
#include <functional>

#include "../rules/ruppert.hpp"

namespace pardel::schemes::cells {

/// Ruppert's algorithm on the triangles that wait and on those that it makes, as long as `is_due` holds for them. Stops
/// when the mesh has `most_points`. Returns its work.
[[nodiscard]] std::uint64_t refine_where(LinkedMesh& mesh, const Bounds& bounds, std::deque<Index> waiting,
                                         const std::function<bool(Index)>& is_due, std::size_t most_points);

/// The triangles in use.
[[nodiscard]] std::deque<Index> all_triangles(const LinkedMesh& mesh);

}  // namespace pardel::schemes::cells
