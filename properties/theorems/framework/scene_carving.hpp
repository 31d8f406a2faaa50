// Scenes whose domain is not a convex hull: pockets of the outline and holes are carved away, and every edge of the
// border is a wall. Slits are walls that run from the border into the domain.
#pragma once

#include "scenes.hpp"

namespace pardel::properties {

/// Carves up to two pockets and up to two holes out of the scene, at least one of them, and perhaps adds a slit. What
/// remains is connected across edges. Names what was done in `families`. Returns false, and leaves the scene as it is,
/// if no part that it tries can be carved away.
[[nodiscard]] bool carve_at_random(generators::Random& random, Scene& scene, Families& families);

/// How a domain differs from a convex hull. Found from the mesh alone.
struct Outline {
  bool is_walled = false;   ///< every edge of the border is a wall
  bool has_reflex = false;  ///< some edge of the border has points of the mesh strictly on its outer side
  bool has_hole = false;    ///< by Euler's formula, for a mesh that is connected
  bool has_slit = false;    ///< a wall with triangles on both sides ends on the border
};
[[nodiscard]] Outline outline_of(const ref::PlainMesh& mesh);

/// Does the border hide a triangle from the point? That is, is there a triangle whose open circumdisk contains the
/// point, and that the point would see if no wall were on the border, but does not see?
[[nodiscard]] bool border_hides(const ref::PlainMesh& mesh, const ref::ExactPoint& p);

/// Counts the current case by the outline of its domain and by what the border hides from the insertions. Promises the
/// least shares of carved domains in a property that draws every kind of domain (in_any_domain() or
/// in_any_walled_domain()): reflex outlines, holes, slits. `hidden_percent` is the promised share of cases in which the
/// border hides something from an insertion.
void classify_outline(const MeshedScene& meshed, const std::vector<Point>& insertions, double hidden_percent);

}  // namespace pardel::properties
