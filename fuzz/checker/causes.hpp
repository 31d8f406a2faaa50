// Which angles may be below the bound, by definition (properties/THEORY.md, "Checker", step 9, and "Refinement: every
// input", rule 2).
#pragma once

#include <map>
#include <set>

#include "chains.hpp"

namespace pardel::fuzz {

struct SmallAngles {
  Triangles without_cause;  ///< triangles with an angle below the bound that has no cause
  /// The other triangles with angles below the bound: the apexes of the causes of their smallest angle.
  std::map<Index, std::set<Index>> apexes;
};

/// Preconditions: the mesh is conformal, its vertices begin with the input points, and chains meet in input points
/// only.
[[nodiscard]] SmallAngles small_angles(const ExactMesh& mesh, const Chains& chains, double min_angle_deg);

/// All triangles with an angle below the bound. Precondition: all triangles are counter-clockwise.
[[nodiscard]] Triangles with_small_angles(const ExactMesh& mesh, double min_angle_deg);

}  // namespace pardel::fuzz
