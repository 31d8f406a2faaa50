// Joins the fields of the pieces of a mesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "field.hpp"
#include "join_pieces.hpp"

namespace pardel {

/// The fields of a mesh with so many points whose triangles are those of the pieces, one piece after another. Fields of
/// the same name, place, number of components and time are one field. A value that no piece has is missing. If several
/// pieces have a value at a point, that of the first one counts. Time O(n) for each field. Precondition: numbers are
/// below `points`.
[[nodiscard]] std::vector<Field> join_fields(std::span<const NumberedMesh* const> pieces, std::size_t points);

/// The names of all pieces. If several pieces name a marker or a region, the name in the first one counts.
[[nodiscard]] std::vector<GroupName> join_names(std::span<const NumberedMesh* const> pieces);

}  // namespace pardel
