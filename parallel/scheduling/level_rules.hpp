// Which triangles the levels of a refinement leave to finer ones, and how fine the levels become.
#pragma once

#include <optional>

#include "../decomposition/lattice.hpp"
#include "../decomposition/quadtree.hpp"
#include "../options.hpp"
#include "../refinement/deferral.hpp"
#include "pending_triangles.hpp"

namespace pardel::engine {

/// The triangles that a level leaves to the next finer lattice, because they are short enough for its boxes. With the
/// paper's lattice, circumradii count (THEORY.md, T1 and Lattice).
[[nodiscard]] Deferral short_enough_for(const Lattice& finer, Decomposition decomposition);

/// The same for each leaf of a quadtree: the triangles that are left to the finer leaves in it. With the paper's
/// quadtree, the leaves around it count, too: in the buffer zone of a finer leaf, all circumradii have to fit.
[[nodiscard]] Deferrals short_enough_for(const Quadtree& tree, const Quadtree& finer, Decomposition decomposition);

/// The quadtree in which no leaf has too much work, if it was divided from this one at most twice. `available`: the
/// number of vertices that may still be inserted.
[[nodiscard]] Quadtree divided_by_work(const Quadtree& tree, const Array<WorkAt>& work, const Options& options,
                                       std::uint64_t available);

}  // namespace pardel::engine
