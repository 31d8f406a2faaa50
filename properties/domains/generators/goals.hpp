// Random goals for random domains. Areas are in lattice units, so a goal keeps its meaning when a domain is moved or
// scaled.
#pragma once

#include <iosfwd>
#include <limits>
#include <vector>

#include "../../../core/goal.hpp"
#include "lattice_domain.hpp"

namespace pardel::generators {

/// The members of a Goal that random cases set. The other members of the Goal keep their defaults.
struct LatticeGoal {
  double min_angle_deg = Goal{}.min_angle_deg;
  double max_area = std::numeric_limits<double>::infinity();  ///< in lattice units
  bool region_caps = true;
  bool conforming = false;
  friend bool operator==(const LatticeGoal&, const LatticeGoal&) = default;
};

/// A meshing problem: a domain and a goal.
struct Case {
  LatticeDomain domain;
  LatticeGoal goal;
  friend bool operator==(const Case&, const Case&) = default;
};
std::ostream& operator<<(std::ostream& out, const LatticeGoal& goal);
std::ostream& operator<<(std::ostream& out, const Case& c);

/// The goal for to_pslg(domain), with the area bound scaled like the domain.
[[nodiscard]] Goal to_goal(const LatticeGoal& goal, const LatticeDomain& domain);

/// A goal with an angle bound of 0, 10, 20.7, 25 or 28 degrees. It has no area bound, or an area bound that a mesh of
/// at most a few hundred triangles meets. (Larger angle bounds are not drawn: at 30 degrees refinement does not
/// terminate by itself on about one domain in 10^5.)
[[nodiscard]] LatticeGoal any_goal(const LatticeDomain& domain, Random& random);
/// A random domain of any family with a random goal. `size`: see generate().
[[nodiscard]] Case any_case(Random& random, int size);

/// Simpler goals: each sets one member to its default.
[[nodiscard]] std::vector<LatticeGoal> shrinks(const LatticeGoal& goal);
/// Simpler cases: first those with a simpler domain, then those with a simpler goal.
[[nodiscard]] std::vector<Case> shrinks(const Case& c);

}  // namespace pardel::generators
