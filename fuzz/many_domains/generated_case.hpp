// A meshing problem that is drawn from a seed and a number: a domain of one of the families, a goal, and options.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/pslg.hpp"
#include "../../parallel/options.hpp"
#include "../../properties/domains/generators/mixed_scales.hpp"

namespace pardel::fuzz {

struct GeneratedCase {
  Pslg pslg;  ///< valid
  Goal goal;
  Options options;
  int ranks = 0;              ///< the mesh is also made on so many ranks; 0: it is not
  bool delays = false;        ///< the messages of ranks are delayed
  bool turned = false;        ///< coordinates are rounded, so points may lie almost on a line
  bool far_off = false;       ///< they are rounded so much that points may nearly coincide
  bool refine_again = false;  ///< the mesh is also refined, with other bounds on areas
  /// If scales are mixed: the domains of which the domain is made, see generators::Mixed. Empty if they are not.
  std::vector<Pslg> parts;
  std::vector<generators::Mixture> mixtures;  ///< how they are mixed
  bool is_tiny = false;                       ///< edges of the least possible length may be needed
  /// What was drawn, for counts of cases of a kind: the family first, then "angle28", "field", "threads3" and so on.
  std::vector<std::string> kinds;

  /// True if points may lie almost on a segment or almost on an edge of the convex hull. Between such lines, refinement
  /// ends only at the resolution of doubles, so these cases have a limit on vertices.
  [[nodiscard]] bool has_gaps_of_rounding() const;
  /// True if two segments meet at so small an angle, so far from the origin, that between their pieces refinement can
  /// reach the shortest edge that the mesher makes at such coordinates (2^-42 of the largest one).
  [[nodiscard]] bool has_angles_of_rounding() const;
  /// True if a bound may be missed although the limit on vertices was not reached.
  [[nodiscard]] bool may_miss() const;
};

/// The case depends on the two numbers only. The domains of a seed are drawn independently of each other.
[[nodiscard]] GeneratedCase generated_case(std::uint64_t seed, std::uint64_t number);

}  // namespace pardel::fuzz
