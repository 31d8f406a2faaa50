// The triangles that segments cross, in a triangulation that is divided among ranks.
#pragma once

#include <vector>

#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "../concurrency/threads.hpp"
#include "../given_points/local_delaunay.hpp"
#include "../given_points/own_points.hpp"
#include "../validate.hpp"
#include "common_vertices.hpp"

namespace pardel::engine {

/// The segments as constraints of a rank's triangulation, in the order of insert_constraints() in one process.
struct OrderedConstraints {
  std::vector<Constraint> edges;
  std::vector<Index> segment;  ///< of each edge
};

/// All ends of segments become vertices.
[[nodiscard]] OrderedConstraints ordered_constraints(const CommonVertices& common, LocalDelaunay& delaunay);

/// Afterwards the triangulation of each rank has all triangles that the constraints cross, or have as a side, in the
/// triangulation of all points. Those that they cross are the only ones that change when the constraints become edges,
/// so each rank can insert all constraints for itself, and gets all triangles with an own corner right (THEORY.md,
/// GivenPoints). Collective. If points lie inside segments, returns some of them, as problems, on all ranks alike;
/// then nothing has been added.
///
/// Precondition: all triangles with an own corner are those of the triangulation of all points; no two segments cross.
[[nodiscard]] std::vector<Problem> learn_crossed_triangles(const OrderedConstraints& constraints,
                                                           LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks,
                                                           const Threads& threads);

}  // namespace pardel::engine
