// The triangles that a task may use while other tasks run (THEORY.md, T-region): the triangles that insertions in a
// region can reach, and the triangles that a task may change if it owns a box.
#pragma once

#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// A closed box with sides parallel to the axes. It may have width or height 0.
struct Box {
  Point low, high;
};

[[nodiscard]] bool contains(const Box& box, const ExactPoint& p);

/// The triangles whose open circumdisk meets the region, whether or not a point of the region sees them; ascending
/// indices. If L is the region, this set contains K(L), which in_reach_and_sight_of() returns.
[[nodiscard]] std::vector<Index> in_reach_of(const PlainMesh& mesh, const Box& region);

/// K(L), where L is the region: the triangles t such that some point of the region lies in the open circumdisk of t and
/// sees t; ascending indices. K(L) is the union of the cavities of all points of the region. Precondition: the mesh is
/// constrained Delaunay. Then a constraint hides a part of a disk only if it crosses the whole disk (THEORY.md,
/// T-region, the visible part of a disk).
[[nodiscard]] std::vector<Index> in_reach_and_sight_of(const PlainMesh& mesh, const Box& region);

/// The unconstrained edges of these triangles.
[[nodiscard]] std::set<Edge> free_edges(const PlainMesh& mesh, const std::vector<Index>& triangles);

/// May a task that owns the box change these triangles? That is, do all corners of all triangles lie in the box?
/// Then tasks with disjoint boxes give one mesh, whatever the order of their steps (THEORY.md, T-region).
[[nodiscard]] bool owns(const PlainMesh& mesh, const Box& box, const std::vector<Index>& triangles);

}  // namespace pardel::ref
