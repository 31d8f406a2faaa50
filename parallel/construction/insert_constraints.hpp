// Insertion of constraints: from the Delaunay triangulation of points to a constrained Delaunay triangulation.
#pragma once

#include <span>

#include "../../core/result.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Makes every constraint an edge and restores the constrained Delaunay property (Sloan, "A fast algorithm for
/// generating constrained Delaunay triangulations", 1993). Ghost triangles remain. Returns invalid_input if a
/// constraint crosses another one or passes through a vertex; validate() reports both beforehand. Runs on
/// one thread.
[[nodiscard]] Status insert_constraints(Triangulation& t, std::span<const Constraint> constraints,
                                        const Threads& threads = {});

/// The same for constraints that are sorted already: by the order of their vertices in the triangulation of all points,
/// first by the earlier end. Which of several constrained Delaunay triangulations results depends on this order.
[[nodiscard]] Status insert_in_order(Triangulation& t, std::span<const Constraint> constraints, const Threads& threads);

}  // namespace pardel::engine
