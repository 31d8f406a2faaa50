// From the Delaunay triangulation of points to the constrained Delaunay triangulation of a domain.
#pragma once

#include <span>
#include <vector>

#include "../../core/result.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// A straight constraint between two vertices of the triangulation.
struct Constraint {
  VertexId a, b;
};

/// Forces the constraints in and restores the constrained Delaunay property (Sloan, "A fast algorithm for
/// generating constrained Delaunay triangulations", 1993). Ghosts stay. A constraint that crosses another,
/// or that runs through a vertex, gives invalid_input: validate() would have named it.
[[nodiscard]] Status insert_constraints(Triangulation& t, std::span<const Constraint> constraints);

/// What of the triangulation is the domain.
struct DomainRules {
  bool convex_hull = false;  ///< the hull's edges become constraints, and all inside them the domain
  std::vector<Point> holes;
  std::vector<Point> region_seeds;
};

/// Removes the ghosts, the exterior and the holes, numbers what is left from 0 and fills `region` when
/// there are seeds. With convex_hull the hull edges that are no constraints yet are returned. The same on any number
/// of threads.
[[nodiscard]] std::vector<Constraint> carve(Triangulation& t, const DomainRules& rules, int threads = 1);

}  // namespace pardel::engine
