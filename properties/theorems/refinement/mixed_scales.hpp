// Random problems whose domains mix scales (domains/generators/mixed_scales.hpp).
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "../../domains/generators/mixed_scales.hpp"
#include "meshing.hpp"

namespace pardel::properties {

inline constexpr const char* mixed_families =
    "lattice domains of every family, random goals; far points, a huge outline, a component up to 2^60 times smaller "
    "beside the domain, in a hole or in a face, a component far off, or a tiny feature";

/// Mixtures of two components, each with an outline of its own. No face lies between them.
inline const std::vector<generators::Mixture> mixtures_of_components{generators::Mixture::component_beside,
                                                                     generators::Mixture::component_in_hole,
                                                                     generators::Mixture::component_far_off};

/// A problem with a mixed domain, and how it was mixed.
struct MixedProblem {
  Problem problem;
  generators::Mixed mixed;
};

/// Two domains, a goal, and the seed of the mixture.
struct Ingredients {
  generators::Case one;
  generators::LatticeDomain other;
  std::uint64_t seed = 0;
};
[[nodiscard]] inline Ingredients any_ingredients(generators::Random& random, int size) {
  Ingredients drawn{generators::any_case(random, size), {}, 0};
  drawn.other = random.chance(2) ? drawn.one.domain : generators::any_domain(random, size / 2);
  drawn.seed = random.next();
  return drawn;
}
[[nodiscard]] inline std::vector<Ingredients> shrinks(const Ingredients& drawn) {
  std::vector<Ingredients> simpler;
  for (generators::Case& one : generators::shrinks(drawn.one))
    simpler.push_back({std::move(one), drawn.other, drawn.seed});
  for (generators::LatticeDomain& other : generators::shrinks(drawn.other))
    simpler.push_back({drawn.one, std::move(other), drawn.seed});
  return simpler;
}

/// A random problem that mixes scales in one of the given ways. Tags the case with the mixtures. Domains that cannot be
/// mixed are discarded. `smaller`: the domain has so many times fewer points than those of other properties.
inline MixedProblem some_mixed_problem(Exhibit& exhibit,
                                       const std::vector<generators::Mixture>& mixtures = generators::all_mixtures(),
                                       int smaller = 2) {
  const auto make = [smaller](generators::Random& random, int size) { return any_ingredients(random, size / smaller); };
  const Ingredients drawn = *generators::generator(make, [](const Ingredients& simpler) { return shrinks(simpler); });
  generators::Random random(drawn.seed);
  const Problem unmixed = to_problem(drawn.one);
  MixedProblem result{unmixed, mixed_scales(unmixed.pslg, to_pslg(drawn.other), random, false, mixtures)};
  RC_PRE(!result.mixed.what.empty());
  for (const generators::Mixture mixture : result.mixed.what) RC_TAG(std::string(name(mixture)));
  result.problem.pslg = result.mixed.pslg;
  if (result.mixed.enlarges) result.problem.goal.max_area = std::numeric_limits<double>::infinity();
  exhibit.show(result.problem.pslg);
  return result;
}

}  // namespace pardel::properties
