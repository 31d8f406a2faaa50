// Decides, from coordinates and chains only, which angles below the bound small input angles justify.
//
// The smallest angle of a mesh is at most the smallest angle of its input. Near a small input angle, refinement by
// shells has to leave some triangles with angles below the bound (Miller, Pav, Walkington, "When and why Ruppert's
// algorithm works", 2003). Every angle below the bound needs a cause of its own. It is justified if
// - it is nestled: it lies at an input vertex, between pieces of two segments that meet there at less than 60 degrees;
//   or
// - the edge opposite is seditious. Seditious edges join vertices strictly inside two segments that share an end, the
//   apex, at an angle θ of less than 60 degrees; both vertices have the same distance from the apex ("lie on one
//   shell"). Below about one degree, one of the two can be the end of its segment: the longer segment is split beside
//   the end of the shorter one.
// In both cases the angle has to be at least arctan(sin θ / (2 - cos θ)), that of a triangle with its third corner on
// the next shell, twice as far away.
// Straight paths of segments count as segments (model/straight_paths.hpp).
// Rounded vertices count as equally distant within a tolerance, see tolerances.hpp.
#pragma once

#include <optional>

#include "stages.hpp"

namespace pardel::checker {

/// Whether small input angles justify the angles of a triangle.
struct AngleVerdict {
  /// A corner with an angle below the bound that nothing justifies; -1 if there is none.
  int unjustified = -1;
  /// The cause of the smallest of the angles below the bound, if all are justified and there is one.
  std::optional<Justified> cause;
};

/// `cosine_bound`: angles with a larger cosine are below the bound.
[[nodiscard]] AngleVerdict judge_angles(Index t, double cosine_bound, const Subject& subject, const Domain& domain,
                                        const Adjacency& adjacency, const Chains& chains, const InputVertices& inputs);

}  // namespace pardel::checker
