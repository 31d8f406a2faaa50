// What a task may work on while others work elsewhere: the triangles that insertions in a region can reach, and the
// rule by which a task that owns a box knows which triangles it may change.
#pragma once

#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// A closed box with sides parallel to the axes; it may be flat.
struct Box {
  Point low, high;
};

[[nodiscard]] bool contains(const Box& box, const ExactPoint& p);

/// K(L): the triangles whose open circumdisk meets the region, seen or unseen; ascending.
[[nodiscard]] std::vector<Index> in_reach_of(const PlainMesh& mesh, const Box& region);

/// The same, but of each disk only the part counts from which its triangle is seen. In a constrained Delaunay mesh
/// that is the union of the cavities of all points of the region: no end of a constraint that t sees lies in its
/// disk, so what hides a part of the disk is constraints that cross all of it, and t sees what is on its side of those.
[[nodiscard]] std::vector<Index> in_reach_and_sight_of(const PlainMesh& mesh, const Box& region);

/// The edges of the triangles that are no constraints.
[[nodiscard]] std::set<Edge> free_edges(const PlainMesh& mesh, const std::vector<Index>& triangles);

/// May a task that owns the box change these triangles: do all three corners of each lie in it?
[[nodiscard]] bool owns(const PlainMesh& mesh, const Box& box, const std::vector<Index>& triangles);

}  // namespace pardel::ref
