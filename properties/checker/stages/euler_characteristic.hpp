// The Euler characteristic of the components of a mesh.
#pragma once

#include "stages.hpp"

namespace pardel::checker {

/// True if it is certain that each component has V - E + F = 2 - L. Preconditions: all triangles are counter-clockwise,
/// and has_only_single_fans().
///
/// Let g be the genus of a component: V - E + F = 2 - 2g - L for a connected oriented surface with L boundary loops. So
/// half the sum of V - E + F + L over all components is the sum of 1 - g, which is at most the number of components,
/// and equal to it only if every g is 0. The number of components is at most the number of classes of loops.
[[nodiscard]] bool has_only_disks_with_holes(const Mesh& mesh, const Adjacency& adjacency, StopSignal* stop);

/// A connected oriented surface with L boundary loops is a disk with holes if and only if V - E + F = 2 - L,
/// where a vertex counts once for each of its fans (that is, a surface is cut where it touches itself in a vertex).
void check_euler(const Subject& subject, const Adjacency& adjacency, Findings& found);

}  // namespace pardel::checker
