// The data of vertices that are in several pieces.
#pragma once

#include <cstdint>

#include "../../../core/ranks.hpp"
#include "../../../core/result.hpp"
#include "border.hpp"

namespace pardel::checker {

/// Compares the markers, the origins and the attributes that pieces give to one vertex. Collective; an error is the
/// same on all ranks. `points`: the number of points of the whole mesh. Precondition: check_numbers() has found
/// nothing, so each vertex of several pieces is kept in all of them.
///
/// Errors: invalid_input if the pieces do not have the same kinds of data (a piece without points does not count), or
/// if two of them do not agree on a vertex. Memory: 16 bytes per kept vertex, and its attributes.
[[nodiscard]] Status check_data_of_vertices(const PiecesRead& read, std::uint64_t points, Ranks& ranks);

}  // namespace pardel::checker
