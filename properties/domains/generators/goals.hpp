// Random goals for random domains. Areas are in the lattice's units, so that a goal keeps its meaning when a
// domain is moved or scaled.
#pragma once

#include <iosfwd>
#include <limits>
#include <vector>

#include "../../../core/goal.hpp"
#include "lattice_domain.hpp"

namespace pardel::generators {

/// The numbers of a Goal that a random case sets; the rest is as Goal has it.
struct LatticeGoal {
  double min_angle_deg = Goal{}.min_angle_deg;
  double max_area = std::numeric_limits<double>::infinity();  ///< in the lattice's units
  bool region_caps = true;
  bool conforming = false;
  friend bool operator==(const LatticeGoal&, const LatticeGoal&) = default;
};

/// A meshing problem.
struct Case {
  LatticeDomain domain;
  LatticeGoal goal;
  friend bool operator==(const Case&, const Case&) = default;
};
std::ostream& operator<<(std::ostream& out, const LatticeGoal& goal);
std::ostream& operator<<(std::ostream& out, const Case& c);

/// For to_pslg(domain): areas scaled as it scales them.
[[nodiscard]] Goal to_goal(const LatticeGoal& goal, const LatticeDomain& domain);

/// Angles 0, 10, 20.7, 25 or 28 degrees (at 30 refinement may not end by itself: one domain in some 10^5 shows it); no
/// area bound, or one that asks for at most a few hundred triangles.
[[nodiscard]] LatticeGoal any_goal(const LatticeDomain& domain, Random& random);
[[nodiscard]] Case any_case(Random& random, int size);

/// Towards the default goal, one number at a time.
[[nodiscard]] std::vector<LatticeGoal> shrinks(const LatticeGoal& goal);
/// The domain first, then the goal.
[[nodiscard]] std::vector<Case> shrinks(const Case& c);

}  // namespace pardel::generators
